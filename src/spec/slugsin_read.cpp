#include <heed/spec/slugsin.h>
#include <heed/util/diagnostic.h>

#include "peer.h"
#include "prefix.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

namespace heed::spec {
namespace {

using logic::Formula;

struct Known {
  Formula now, next;
  bool input = false;
};

class Reader {
 public:
  Reader(const util::SourceText& source, const util::Limits& limits)
      : source_(source), prefix_(source, limits, [this](std::string_view word, std::size_t begin) {
          return name(word, begin);
        }) {}

  Gr1 read() {
    spec_.name = stem_of(source_.name());
    for_each_line(source_, [this](std::size_t begin, std::size_t end) { read_line(begin, end); });
    return std::move(spec_);
  }

 private:
  void read_line(std::size_t begin, std::size_t end) {
    const std::string_view line = std::string_view(source_.text()).substr(begin, end - begin);
    if (line[0] == '[') {
      section_ = find_section(source_, begin, line);
    } else if (section_ == nullptr) {
      fail(begin, "no-section", "a line outside any section", "begin with a section such as [INPUT]");
    } else if (section_->clauses == nullptr) {
      declare(begin, std::string(line));
    } else {
      add_clauses(spec_, source_, *section_, prefix_.read(begin, end), end, prefix_.conjuncts());
    }
  }

  void declare(std::size_t begin, std::string name) {
    if (name.find_first_of(" \t\v\f\r") != std::string::npos)
      fail(begin, "name", fmt::format("'{}' is no name: it has blanks in it", name), "one variable a line");
    const bool reserved = name.size() == 1 && std::string_view("&|^!$?01").find(name[0]) != std::string::npos;
    if (reserved || name.ends_with('\''))
      fail(begin, "name", fmt::format("'{}' cannot stand as a name", name),
           "operators, 0 and 1 are reserved, and a prime means the next value");
    const auto [place, fresh] = known_.try_emplace(name);
    if (!fresh) fail(begin, "duplicate-name", fmt::format("the name '{}' is declared twice", name));
    place->second = {logic::name(name), logic::next(logic::name(name)), section_->input};
    names_.push_back(name);
    add_variable(spec_, section_->input, {std::move(name), model::Domain::boolean(), {}, source_.at(begin)});
  }

  [[nodiscard]] Read name(std::string_view word, std::size_t begin) const {
    const bool primed = word.ends_with('\'');
    const auto found = known_.find(std::string(word.substr(0, word.size() - (primed ? 1 : 0))));
    if (found == known_.end())
      fail(begin, "unknown-name",
           fmt::format("'{}' is neither an operator nor a variable declared before", word),
           util::suggestion(word, names_));
    const Known& known = found->second;
    check_place(source_, begin, *section_, word, known.input, primed);
    return {primed ? known.next : known.now, begin, primed};
  }

  [[noreturn]] void fail(std::size_t offset, std::string code, std::string message,
                         std::string hint = {}) const {
    throw util::InputError(source_, offset, std::move(code), std::move(message), std::move(hint));
  }

  const util::SourceText& source_;
  PrefixReader prefix_;
  Gr1 spec_;
  const SlugsSection* section_ = nullptr;
  std::unordered_map<std::string, Known> known_;
  std::vector<std::string> names_;
};

}  // namespace

Gr1 read_slugsin(const util::SourceText& source, const util::Limits& limits) {
  check_size(source, limits);
  return Reader(source, limits).read();
}

}  // namespace heed::spec
