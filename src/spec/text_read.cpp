#include <heed/logic/parse.h>
#include <heed/spec/symbols.h>
#include <heed/spec/text.h>
#include <heed/util/diagnostic.h>

#include "cursor.h"
#include "lowering.h"
#include "words.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

namespace heed::spec {
namespace {

using model::OutputRole;

template <typename Value, std::size_t n>
std::vector<std::string> keys(const std::array<Word<Value>, n>& words) {
  std::vector<std::string> out;
  for (const auto& [word, value] : words) out.emplace_back(word);
  return out;
}

template <typename Value, std::size_t n>
const Value* find_word(const std::array<Word<Value>, n>& words, const std::string& word) {
  for (const auto& [text, value] : words)
    if (text == word) return &value;
  return nullptr;
}

/// What stands before an entry.
struct Attributes {
  std::optional<OutputRole> role;
  std::optional<Origin> origin;
  std::string note;
  std::vector<std::string> axioms;
};

/// Which attributes a section's entries may have.
enum class Admits : std::uint8_t { Nothing, Note, Role, RoleWithAxioms, Origin };

class Reader {
 public:
  Reader(const util::SourceText& source, const util::Limits& limits) : source_(source), limits_(limits) {}

  Gr1 read() {
    const std::string& text = source_.text();
    if (limits_.input_bytes != 0 && text.size() > limits_.input_bytes)
      throw util::InputError(source_, 0, "too-large", "the file is larger than the limit");
    for (std::size_t begin = 0; begin < text.size();) {
      std::size_t end = std::min(text.find('\n', begin), text.size());
      read_line(begin, end);
      begin = end + 1;
    }
    for (const auto& [offset, end] : updates_) read_update(offset, end);
    check_updates();
    sort_definitions(spec_);
    add_requirements(spec_, requirements_);
    validate(spec_);
    return std::move(spec_);
  }

 private:
  /// Where the entry ends: before a comment outside quotes, a carriage return or the line's end.
  [[nodiscard]] std::size_t entry_end(std::size_t begin, std::size_t end) const {
    bool quoted = false;
    for (std::size_t i = begin; i < end; ++i) {
      const char c = source_.text()[i];
      if (quoted && c == '\\') {
        ++i;
      } else if (c == '"') {
        quoted = !quoted;
      } else if (!quoted && c == '#') {
        return i;
      }
    }
    return end > begin && source_.text()[end - 1] == '\r' ? end - 1 : end;
  }

  void read_line(std::size_t begin, std::size_t end) {
    Cursor cursor(source_, begin, entry_end(begin, end), limits_);
    if (cursor.done()) return;
    const std::size_t start = cursor.offset();
    const bool formula = source_.text().compare(start, 2, "[]") == 0;
    if (!formula && cursor.accept("[")) return read_section(cursor, start);
    if (section_.empty())
      cursor.fail("no-section", "an entry outside any section", "begin with a section such as [input]");
    if (section_ == "options") return read_option(cursor);
    if (section_ == "input") return read_variable(cursor);
    if (section_ == "output") return read_variable(cursor);
    if (section_ == "memory") return read_memory(cursor, entry_end(begin, end));
    if (section_ == "define") return read_definition(cursor);
    if (section_ == "task") return read_requirement(cursor);
    read_clause(cursor);
  }

  void read_section(Cursor& cursor, std::size_t start) {
    std::string name = cursor.word();
    if (const std::string second = cursor.word(); !second.empty()) name += ' ' + second;
    cursor.expect("]", "after the name of a section");
    cursor.expect_end();
    std::vector<std::string> known{"options", "input", "output", "memory", "define"};
    for (const Part& part : parts) known.emplace_back(part.section);
    known.emplace_back("task");
    if (std::find(known.begin(), known.end(), name) == known.end())
      cursor.fail_at(start, "unknown-section", fmt::format("unknown section '{}'", name),
                     util::suggestion(name, known, 20));
    section_ = name;
  }

  void read_option(Cursor& cursor) {
    const std::size_t start = cursor.offset();
    const std::string key = cursor.word();
    if (key != "name" && key != "timing" && key != "initial")
      cursor.fail_at(start, "unknown-key", fmt::format("unknown option '{}'", key),
                     util::suggestion(key, {"name", "timing", "initial"}));
    if (!options_.insert(key).second)
      cursor.fail_at(start, "duplicate-key", fmt::format("the option '{}' stands twice", key));
    cursor.expect("=", "after an option's name");
    if (key == "name") spec_.name = cursor.name("a name");
    if (key == "timing") spec_.timing = choice(cursor, timing_words);
    if (key == "initial") spec_.initial = choice(cursor, initial_words);
    cursor.expect_end();
  }

  template <typename Value, std::size_t n>
  Value choice(Cursor& cursor, const std::array<Word<Value>, n>& words) {
    const bool blanks = cursor.done();
    const std::size_t start = cursor.offset();
    const std::string word = blanks ? std::string() : cursor.word();
    if (const Value* value = find_word(words, word)) return *value;
    cursor.fail_at(start, "unknown-value", fmt::format("unknown value '{}'", word),
                   util::suggestion(word, keys(words)));
  }

  Attributes attributes(Cursor& cursor, Admits admits) {
    Attributes out;
    while (cursor.accept("@")) {
      const std::size_t start = cursor.offset();
      const std::string word = cursor.word();
      const bool role = admits == Admits::Role || admits == Admits::RoleWithAxioms;
      if (const OutputRole* found = find_word(role_words, word); found && role) {
        out.role = *found;
      } else if (const Origin* origin = find_word(origin_words, word); origin && admits == Admits::Origin) {
        out.origin = *origin;
      } else if (word == "note" && admits != Admits::Origin) {
        out.note = note(cursor);
        continue;
      } else {
        std::vector<std::string> known =
            admits == Admits::Origin ? keys(origin_words) : std::vector<std::string>{"note"};
        if (role)
          for (const auto& key : keys(role_words)) known.push_back(key);
        cursor.fail_at(start, "unknown-attribute", fmt::format("unknown attribute '@{}'", word),
                       util::suggestion(word, known));
      }
      if (admits != Admits::Role && cursor.accept("(")) out.axioms = strings(cursor);
    }
    return out;
  }

  static std::vector<std::string> strings(Cursor& cursor) {
    std::vector<std::string> out;
    do {
      out.push_back(cursor.quoted());
    } while (cursor.accept(","));
    cursor.expect(")", "after the arguments of an attribute");
    return out;
  }

  static std::string note(Cursor& cursor) {
    cursor.expect("(", "after @note");
    const std::vector<std::string> texts = strings(cursor);
    if (texts.size() != 1) cursor.fail("syntax", "a note is one text");
    return texts[0];
  }

  model::Variable variable(Cursor& cursor, const std::string& comment) {
    model::Variable out;
    out.comment = comment;
    if (!cursor.done()) out.location = cursor.location();
    out.name = cursor.name("the name of a variable");
    cursor.expect(":", "between name and type");
    out.domain = cursor.type();
    return out;
  }

  void read_variable(Cursor& cursor) {
    const bool input = section_ == "input";
    const Attributes found = attributes(cursor, input ? Admits::Note : Admits::Role);
    model::Variable read = variable(cursor, found.note);
    cursor.expect_end();
    if (input)
      spec_.inputs.push_back(std::move(read));
    else
      spec_.outputs.push_back({std::move(read), found.role.value_or(OutputRole::Output)});
  }

  void read_memory(Cursor& cursor, std::size_t end) {
    const std::size_t start = cursor.offset();
    const Attributes found = attributes(cursor, Admits::Role);
    Cursor ahead = cursor;
    static_cast<void>(ahead.name("the name of a memory"));
    if (ahead.accept("'")) {
      updates_.emplace_back(start, end);
      return;
    }
    Memory memory;
    memory.variable = variable(cursor, found.note);
    memory.role = found.role.value_or(OutputRole::Memory);
    memory.comment = found.note;
    memory.initial.clear();
    cursor.expect("=", "before the initial value");
    do {
      memory.initial.push_back(cursor.value(memory.variable.domain));
    } while (cursor.accept(","));
    cursor.expect_end();
    spec_.memories.push_back(std::move(memory));
  }

  void read_update(std::size_t begin, std::size_t end) {
    Cursor cursor(source_, begin, end, limits_);
    const std::string name = cursor.name("the name of a memory");
    cursor.expect("'", "after the name");
    cursor.expect("=", "before the next value");
    std::vector<std::string> known;
    for (Memory& memory : spec_.memories) {
      known.push_back(memory.variable.name);
      if (known.back() != name) continue;
      if (memory.variable.domain.kind != model::Domain::Kind::Boolean) return read_case(cursor, memory);
      if (!updated_.insert(name).second)
        cursor.fail_at(begin, "duplicate-update", fmt::format("a second update of '{}'", name));
      memory.update = cursor.formula();
      return;
    }
    cursor.fail_at(begin, "unknown-name", fmt::format("an update of the unknown memory '{}'", name),
                   util::suggestion(name, known));
  }

  static void read_case(Cursor& cursor, Memory& memory) {
    const std::int32_t value = cursor.value(memory.variable.domain);
    cursor.expect("when", "between the value and its condition");
    memory.cases.push_back({cursor.formula(), value});
  }

  void check_updates() const {
    for (const Memory& memory : spec_.memories)
      if (memory.variable.domain.kind == model::Domain::Kind::Boolean &&
          updated_.count(memory.variable.name) == 0)
        throw util::InputError(memory.variable.location, "no-update",
                               fmt::format("the memory '{}' has no update", memory.variable.name),
                               fmt::format("add a line: {}' = ...", quoted_name(memory.variable.name)));
  }

  void read_definition(Cursor& cursor) {
    const Attributes found = attributes(cursor, Admits::RoleWithAxioms);
    Definition definition;
    definition.name = cursor.name("the name of a definition");
    cursor.expect(":=", "after the name of a definition");
    definition.formula = cursor.formula();
    definition.role = found.role.value_or(OutputRole::Recognised);
    definition.comment = found.note;
    definition.axioms = found.axioms;
    spec_.definitions.push_back(std::move(definition));
  }

  void read_clause(Cursor& cursor) {
    const Attributes found = attributes(cursor, Admits::Origin);
    Clause clause;
    clause.origin = found.origin.value_or(Origin::Task);
    clause.axioms = found.axioms;
    clause.formula = cursor.formula();
    clause.text = logic::to_string(clause.formula);
    for (const Part& part : parts)
      if (part.section == section_) (spec_.*part.clauses).push_back(clause);
  }

  void read_requirement(Cursor& cursor) {
    const std::size_t start = cursor.offset();
    const std::string word = cursor.word();
    if (word != "assume" && word != "guarantee")
      cursor.fail_at(start, "syntax", "expected 'assume:' or 'guarantee:'",
                     util::suggestion(word, {"assume", "guarantee"}));
    cursor.expect(":", "after '" + word + "'");
    auto& list = word == "assume" ? requirements_.assumptions : requirements_.guarantees;
    list.push_back({cursor.formula()});
    list.back().text = logic::to_string(list.back().formula);
  }

  const util::SourceText& source_;
  const util::Limits& limits_;
  Gr1 spec_;
  Requirements requirements_;
  std::string section_;
  std::set<std::string> options_, updated_;
  std::vector<std::pair<std::size_t, std::size_t>> updates_;
};

}  // namespace

Gr1 read_gr1(const util::SourceText& source, const util::Limits& limits) {
  return Reader(source, limits).read();
}

}  // namespace heed::spec
