#include <heed/dl/konclude.h>

#include "process.h"

#include <heed/owl/print.h>
#include <heed/owl/read.h>
#include <heed/owl/vocabulary.h>
#include <heed/util/file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

// Konclude 0.7 needs guarding. Without `-w 2` it may wait forever; a missing or broken file is an empty,
// consistent ontology to it, with exit code 0, and only its log tells; it fetches imports from the network.

namespace heed::dl {
namespace {

namespace v = owl::vocabulary;

/// A folder that goes when this does.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "heed-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw util::InputError(util::Location{}, "cannot-write",
                             fmt::format("no folder can be made as '{}'", name));
    path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

[[noreturn]] void fail(std::string message) {
  throw util::InputError(util::Location{}, "reasoner-failed", std::move(message),
                         "leave --reasoner out: what heed's own reasoner answers does not hang on it");
}

/// The classes and the logical axioms: what Konclude cannot misread.
std::string document(const owl::Ontology& ontology) {
  std::string out = "Ontology(\n";
  for (const owl::Iri iri : ontology.entities(owl::EntityKind::Class))
    out += fmt::format("Declaration(Class(<{}>))\n", ontology.text(iri));
  for (const owl::Axiom& axiom : ontology.axioms())
    if (owl::is_logical(axiom)) out += owl::to_functional(axiom, ontology) + '\n';
  return out + ")\n";
}

/// Lines of the log that begin with \p mark, without it and the time.
std::vector<std::string> lines_of(const std::string& log, std::string_view mark) {
  std::vector<std::string> out;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(mark)) continue;
    line.erase(line.find_last_not_of(" \r") + 1);
    const std::size_t text = line.find(">> ");
    out.push_back(text == std::string::npos ? line : line.substr(text + 3));
  }
  return out;
}

/// Its hierarchy in the names of our ontology.
class Hierarchy {
 public:
  Hierarchy(const owl::Ontology& answer, const owl::Ontology& ours) : answer_(answer), ours_(ours) {
    up_.resize(ours.iri_count());
    known_.resize(ours.iri_count());
    for (const owl::Axiom& axiom : answer.axioms()) {
      if (const auto* sub = axiom.as<owl::SubClassOf>()) add(sub->sub, sub->super);
      if (const auto* same = axiom.as<owl::EquivalentClasses>())
        for (std::size_t i = 0; i < same->classes.size(); ++i)
          add(same->classes[i], same->classes[(i + 1) % same->classes.size()]);
      if (const auto* declared = axiom.as<owl::Declaration>())
        if (const auto iri = ours.find(answer.text(declared->entity))) known_[iri->id] = true;
    }
    known_[v::owl_thing.id] = known_[v::owl_nothing.id] = true;
  }

  [[nodiscard]] bool has(owl::Iri iri) const { return known_[iri.id]; }
  [[nodiscard]] const std::vector<owl::Iri>& direct(owl::Iri iri) const { return up_[iri.id]; }

  /// All above, itself included, as marks that stand until the next call.
  const std::vector<bool>& above(owl::Iri iri) {
    marked_.assign(up_.size(), false);
    marked_[iri.id] = true;
    std::vector<owl::Iri> open = {iri};
    while (!open.empty()) {
      const owl::Iri next = open.back();
      open.pop_back();
      for (const owl::Iri super : up_[next.id]) {
        if (marked_[super.id]) continue;
        marked_[super.id] = true;
        open.push_back(super);
      }
    }
    return marked_;
  }

 private:
  void add(const owl::ClassExpression& sub, const owl::ClassExpression& super) {
    if (!sub.is_named() || !super.is_named()) return;
    const auto a = ours_.find(answer_.text(sub.iri()));
    const auto b = ours_.find(answer_.text(super.iri()));
    if (a && b) up_[a->id].push_back(*b);
  }

  const owl::Ontology& answer_;
  const owl::Ontology& ours_;
  std::vector<std::vector<owl::Iri>> up_;
  std::vector<bool> known_, marked_;
};

void compare(Hierarchy& theirs, const Reasoner& ours, util::Budget& budget, KoncludeAnswer& out) {
  for (const owl::Iri sub : ours.ontology().entities(owl::EntityKind::Class)) {
    budget.check();
    const std::vector<bool>& above = theirs.above(sub);
    if (above[v::owl_nothing.id]) {
      if (ours.satisfiable(sub)) out.added.push_back({sub, v::owl_nothing});
      continue;
    }
    for (const owl::Iri super : theirs.direct(sub))
      if (!ours.subsumes(super, sub)) out.added.push_back({sub, super});
    if (!ours.satisfiable(sub)) {
      out.missing.push_back({sub, v::owl_nothing});
      continue;
    }
    for (const owl::Iri super : ours.superclasses(sub))
      if (!above[super.id]) out.missing.push_back({sub, super});
  }
  std::sort(out.added.begin(), out.added.end());
}

/// What it says when its log is to be believed. An inconsistent ontology makes its own steps fail, which the
/// log calls errors as well.
KoncludeAnswer judged(const Finished& finished, const owl::Ontology& answer, const Reasoner& ours,
                      util::Budget& budget) {
  KoncludeAnswer out;
  out.remarks = lines_of(finished.log, "{warning}");
  Hierarchy theirs(answer, ours.ontology());
  out.consistent = !theirs.above(v::owl_thing)[v::owl_nothing.id];
  for (const std::string& error : lines_of(finished.log, "{error}"))
    if (out.consistent || !error.ends_with("processing step failed."))
      fail(fmt::format("Konclude reports: {}", error));
  for (const owl::Iri iri : ours.ontology().entities(owl::EntityKind::Class))
    if (!theirs.has(iri))
      fail(fmt::format("the answer of Konclude lacks the class '{}'", ours.ontology().text(iri)));
  if (out.consistent) compare(theirs, ours, budget, out);
  return out;
}

}  // namespace

KoncludeAnswer ask_konclude(const Reasoner& ours, const KoncludeOptions& options, util::Budget& budget) {
  const ScratchFolder folder;
  const std::string input = folder.file("ontology.ofn");
  const std::string output = folder.file("answer.owx");
  util::write_file(input, document(ours.ontology()));
  const Finished finished = run({{options.program, "classification", "-w", "2", "-i", input, "-o", output},
                                 options.seconds,
                                 options.memory_bytes},
                                budget);
  if (!finished.found)
    throw util::InputError(util::Location{}, "no-reasoner",
                           fmt::format("the reasoner '{}' cannot be started", options.program),
                           "install Konclude (Debian: apt install konclude)");
  if (finished.signal != 0) fail(fmt::format("Konclude was ended by signal {}", finished.signal));
  if (finished.exit_code != 0) fail(fmt::format("Konclude ended with exit code {}", finished.exit_code));
  if (!std::filesystem::exists(output)) {
    const auto errors = lines_of(finished.log, "{error}");
    fail(errors.empty() ? "Konclude left no answer" : fmt::format("Konclude reports: {}", errors.front()));
  }
  util::Diagnostics ignored;
  util::Limits limits;
  limits.input_bytes = 0;
  const owl::Ontology answer = owl::read(util::read_file(output, limits), limits, ignored);
  return judged(finished, answer, ours, budget);
}

}  // namespace heed::dl
