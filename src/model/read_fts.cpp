#include <fmt/format.h>
#include <heed/model/fts.h>
#include <heed/util/diagnostic.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace heed::model {
namespace {

/// A name and where it stands.
struct Word {
  std::string text;
  std::size_t offset = 0;
};

struct Assignment {
  Word state;
  std::int32_t value = 0;
};

struct Edge {
  Word from, action, to;
};

/// The lines as written; names are looked up once all are known.
struct Lines {
  std::vector<std::vector<Word>> states, initial;
  std::vector<std::pair<Word, std::vector<Word>>> labels;
  std::vector<std::pair<Word, std::vector<Assignment>>> values;
  std::vector<Edge> edges;
};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool is_name_part(char c) {
  return is_letter(c) || (c >= '0' && c <= '9') || c == '.';
}

class LineReader {
 public:
  explicit LineReader(const util::SourceText& source) : source_(source), text_(source.text()) {}

  Lines read() {
    while (at_ < text_.size()) {
      end_ = std::min(text_.find('\n', at_), text_.size());
      const std::size_t next_line = end_ + 1;
      end_ = at_ + std::min(text_.substr(at_, end_ - at_).find('#'), end_ - at_);
      skip_space();
      if (at_ < end_) read_item();
      at_ = next_line;
    }
    return std::move(lines_);
  }

 private:
  void skip_space() {
    while (at_ < end_ && std::string_view(" \t\r\f\v").find(text_[at_]) != std::string_view::npos) ++at_;
  }
  bool accept(std::string_view symbol) {
    skip_space();
    if (text_.substr(at_, symbol.size()) != symbol || at_ + symbol.size() > end_) return false;
    at_ += symbol.size();
    return true;
  }
  [[nodiscard]] bool at_name() {
    skip_space();
    return at_ < end_ && is_letter(text_[at_]);
  }
  [[noreturn]] void fail(const std::string& expected, const std::string& hint = {}) {
    skip_space();
    const std::string found = at_ < end_ ? fmt::format("'{}'", text_.substr(at_, 1)) : "the end of the line";
    throw util::InputError(source_, at_, "syntax", fmt::format("expected {}, found {}", expected, found),
                           hint);
  }
  Word name(const std::string& what) {
    if (!at_name()) fail(what, "names start with a letter or _, then letters, digits, _ and .");
    const std::size_t first = at_;
    while (at_ < end_ && is_name_part(text_[at_])) ++at_;
    return {std::string(text_.substr(first, at_ - first)), first};
  }
  std::vector<Word> names() {
    std::vector<Word> found;
    while (at_name()) found.push_back(name("a state"));
    skip_space();
    if (at_ < end_) fail("a state or the end of the line");
    return found;
  }
  std::int32_t integer();
  std::vector<Assignment> assignments();
  void read_item();
  void read_named(const Word& key, const Word& title);
  void read_edge(Word from);

  const util::SourceText& source_;
  std::string_view text_;
  std::size_t at_ = 0, end_ = 0;
  Lines lines_;
};

std::int32_t LineReader::integer() {
  skip_space();
  std::int32_t value = 0;
  const auto [stop, error] = std::from_chars(text_.data() + at_, text_.data() + end_, value);
  const auto after = static_cast<std::size_t>(stop - text_.data());
  if (error != std::errc() || (after < end_ && is_name_part(text_[after])))
    throw util::InputError(source_, at_, "number", "expected an integer from -2147483648 to 2147483647");
  at_ = after;
  return value;
}

std::vector<Assignment> LineReader::assignments() {
  std::vector<Assignment> found;
  while (at_name()) {
    Word state = name("a state");
    if (!accept("=")) fail("'=' and the value", "write M4=4");
    found.push_back({std::move(state), integer()});
  }
  skip_space();
  if (at_ < end_) fail("a state or the end of the line");
  return found;
}

void LineReader::read_item() {
  Word first = name("a state or one of states, initial, label, value");
  if (accept(":")) {
    if (first.text == "states") return lines_.states.push_back(names());
    if (first.text == "initial") return lines_.initial.push_back(names());
    const bool named = first.text == "label" || first.text == "value";
    throw util::InputError(
        source_, first.offset, named ? "syntax" : "unknown-key",
        named ? fmt::format("'{}' needs a name", first.text) : fmt::format("unknown key '{}'", first.text),
        named ? fmt::format("write {} name: ...", first.text)
              : util::suggestion(first.text, {"states", "initial", "label", "value"}));
  }
  if (at_name()) {
    const Word title = name("a name");
    if (accept(":")) return read_named(first, title);
    fail("':'", "transitions are written M4 -go-> M3");
  }
  read_edge(std::move(first));
}

void LineReader::read_named(const Word& key, const Word& title) {
  if (key.text == "label")
    lines_.labels.emplace_back(title, names());
  else if (key.text == "value")
    lines_.values.emplace_back(title, assignments());
  else
    throw util::InputError(source_, key.offset, "unknown-key", fmt::format("unknown key '{}'", key.text),
                           util::suggestion(key.text, {"label", "value"}));
}

void LineReader::read_edge(Word from) {
  const std::string hint = "transitions are written M4 -go-> M3";
  if (accept("->")) {
    at_ -= 2;
    fail("an action between '-' and '->'", hint);
  }
  if (!accept("-")) fail("'-', ':' or a name", hint);
  Word action = name("an action");
  if (!accept("->")) fail("'->'", hint);
  Word to = name("a state");
  skip_space();
  if (at_ < end_) fail("the end of the line", "one transition a line");
  lines_.edges.push_back({std::move(from), std::move(action), std::move(to)});
}

/// Looks names up and checks what the lines only mean together.
class Builder {
 public:
  Builder(const util::SourceText& source, const Lines& lines) : source_(source), lines_(lines) {}

  Fts build() {
    fts_.name = source_.name();
    add_states();
    add_initial();
    for (const auto& [title, states] : lines_.labels) add_label(title, states);
    for (const auto& [title, assignments] : lines_.values) add_value(title, assignments);
    for (const Edge& edge : lines_.edges) add_transition(edge);
    refuse_dead_ends();
    return std::move(fts_);
  }

 private:
  [[noreturn]] void fail(std::size_t offset, const char* code, std::string message,
                         std::string hint = {}) const {
    throw util::InputError(source_, offset, code, std::move(message), std::move(hint));
  }
  void require_one(const std::vector<std::vector<Word>>& lines, const char* key) const;
  [[nodiscard]] std::uint32_t state(const Word& word) const;
  void claim(const Word& title);
  void add_states();
  void add_initial();
  void add_label(const Word& title, const std::vector<Word>& states);
  void add_value(const Word& title, const std::vector<Assignment>& assignments);
  void add_transition(const Edge& edge);
  void refuse_dead_ends() const;

  const util::SourceText& source_;
  const Lines& lines_;
  Fts fts_;
  std::unordered_map<std::string, std::uint32_t> states_, actions_;
  std::set<std::string> titles_;
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> edges_;
};

void Builder::require_one(const std::vector<std::vector<Word>>& lines, const char* key) const {
  if (lines.empty())
    throw util::InputError(source_.at(0), "missing", fmt::format("there is no '{}:' line", key),
                           fmt::format("add {}: M0 ...", key));
  if (lines.front().empty())
    throw util::InputError(source_.at(0), "missing", fmt::format("the '{}:' line names no state", key));
  if (lines.size() > 1 && lines[1].empty())
    throw util::InputError(source_.at(0), "duplicate", fmt::format("there is a second '{}:' line", key));
  if (lines.size() > 1)
    fail(lines[1].front().offset, "duplicate", fmt::format("there is a second '{}:' line", key),
         "name all states on one line");
}

std::uint32_t Builder::state(const Word& word) const {
  const auto found = states_.find(word.text);
  if (found == states_.end())
    fail(word.offset, "unknown-state", fmt::format("there is no state '{}'", word.text),
         util::suggestion(word.text, fts_.states));
  return found->second;
}

void Builder::claim(const Word& title) {
  if (!titles_.insert(title.text).second)
    fail(title.offset, "duplicate", fmt::format("'{}' is already a label or value", title.text));
}

void Builder::add_states() {
  require_one(lines_.states, "states");
  for (const Word& word : lines_.states.front()) {
    if (!states_.emplace(word.text, static_cast<std::uint32_t>(fts_.states.size())).second)
      fail(word.offset, "duplicate", fmt::format("the state '{}' is listed twice", word.text));
    fts_.states.push_back(word.text);
  }
}

void Builder::add_initial() {
  require_one(lines_.initial, "initial");
  std::set<std::uint32_t> seen;
  for (const Word& word : lines_.initial.front()) {
    if (!seen.insert(state(word)).second)
      fail(word.offset, "duplicate", fmt::format("the state '{}' is listed twice", word.text));
    fts_.initial.push_back(state(word));
  }
}

void Builder::add_label(const Word& title, const std::vector<Word>& states) {
  claim(title);
  std::vector<bool> holds(fts_.states.size());
  for (const Word& word : states) {
    if (holds[state(word)])
      fail(word.offset, "duplicate", fmt::format("the state '{}' is listed twice", word.text));
    holds[state(word)] = true;
  }
  fts_.labels.emplace_back(title.text, std::move(holds));
}

void Builder::add_value(const Word& title, const std::vector<Assignment>& assignments) {
  claim(title);
  std::vector<std::int32_t> numbers(fts_.states.size());
  std::vector<bool> given(fts_.states.size());
  for (const Assignment& assignment : assignments) {
    const std::uint32_t index = state(assignment.state);
    if (given[index])
      fail(assignment.state.offset, "duplicate",
           fmt::format("the state '{}' is given two values", assignment.state.text));
    given[index] = true;
    numbers[index] = assignment.value;
  }
  for (std::size_t i = 0; i < given.size(); ++i)
    if (!given[i])
      fail(title.offset, "missing", fmt::format("the state '{}' has no {}", fts_.states[i], title.text),
           fmt::format("add {}=...", fts_.states[i]));
  fts_.values.emplace_back(title.text, std::move(numbers));
}

void Builder::add_transition(const Edge& edge) {
  const auto [action, added] =
      actions_.emplace(edge.action.text, static_cast<std::uint32_t>(fts_.actions.size()));
  if (added) fts_.actions.push_back(edge.action.text);
  const std::uint32_t from = state(edge.from), to = state(edge.to);
  if (!edges_.emplace(from, action->second, to).second)
    fail(edge.from.offset, "duplicate", "this transition is given twice");
  fts_.transitions.push_back({from, action->second, to, source_.at(edge.from.offset)});
}

void Builder::refuse_dead_ends() const {
  std::vector<bool> leaves(fts_.states.size());
  for (const Fts::Transition& transition : fts_.transitions) leaves[transition.from] = true;
  for (std::size_t i = 0; i < leaves.size(); ++i)
    if (!leaves[i])
      fail(lines_.states.front()[i].offset, "dead-end",
           fmt::format("the state '{}' has no outgoing transition", fts_.states[i]),
           fmt::format("add {} -action-> ..., or {} -wait-> {} if it may stay", fts_.states[i],
                       fts_.states[i], fts_.states[i]));
}

}  // namespace

Fts read_fts(const util::SourceText& source, const util::Limits& /*limits*/) {
  // Nothing nests here; the size of the file was checked when it was read.
  return Builder(source, LineReader(source).read()).build();
}

}  // namespace heed::model
