// Minimal hitting sets by growing depth: all sets of one observation, then of two, and so on. A branch picks
// the first duty that is not met and tries each way to meet it; what contains a set found before is not
// followed. \cite reiter.87.aij
#include "possible.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace heed::awareness {
namespace {

bool hits(const std::vector<Environment>& alternatives, const Environment& set) {
  return std::any_of(alternatives.begin(), alternatives.end(), [&](const Environment& e) {
    return std::includes(set.begin(), set.end(), e.begin(), e.end());
  });
}

class Search {
 public:
  Search(const HittingTask& task, std::size_t& work) : task_(task), work_(work) {}

  /// Every minimal set of at most \p size; \returns whether larger ones may exist.
  bool round(std::size_t size) {
    bool cut = false;
    std::vector<Environment> open{{}};
    std::set<Environment> tried;
    while (!open.empty() && work_ > 0 && found.size() < evidence_cap) {
      const Environment set = std::move(open.back());
      open.pop_back();
      if (!tried.insert(set).second || covered(set)) continue;
      const auto* duty = unmet(set);
      if (duty == nullptr) {
        found.push_back(set);
        continue;
      }
      for (const Environment& way : *duty) {
        Environment next;
        std::set_union(set.begin(), set.end(), way.begin(), way.end(), std::back_inserter(next));
        if (!allowed(next)) continue;
        if (next.size() > size)
          cut = true;
        else
          open.push_back(std::move(next));
      }
    }
    return cut || !open.empty();
  }

  /// What is not minimal: a way of several observations can reach a set that a smaller one makes needless.
  void keep_minimal() {
    std::sort(found.begin(), found.end(), [](const Environment& a, const Environment& b) {
      return a.size() != b.size() ? a.size() < b.size() : a < b;
    });
    std::vector<Environment> kept;
    for (const Environment& set : found) {
      const bool needless = std::any_of(kept.begin(), kept.end(), [&](const Environment& small) {
        return std::includes(set.begin(), set.end(), small.begin(), small.end());
      });
      if (!needless) kept.push_back(set);
    }
    found = std::move(kept);
  }

  std::vector<Environment> found{};

 private:
  void spend(std::size_t steps) { work_ -= std::min(work_, steps); }

  bool covered(const Environment& set) {
    spend(found.size());
    return std::any_of(found.begin(), found.end(), [&](const Environment& small) {
      return std::includes(set.begin(), set.end(), small.begin(), small.end());
    });
  }

  const std::vector<Environment>* unmet(const Environment& set) {
    for (const auto* duty : task_.duties) {
      spend(duty->size());
      if (!hits(*duty, set)) return duty;
    }
    return nullptr;
  }

  bool allowed(const Environment& set) {
    spend(1);
    if (task_.labels->contradictory(set)) return false;
    return std::any_of(task_.inside.begin(), task_.inside.end(),
                       [&](const auto* against) { return spend(against->size()), !hits(*against, set); });
  }

  const HittingTask& task_;
  std::size_t& work_;
};

}  // namespace

std::vector<Environment> minimal_hitting_sets(const HittingTask& task, std::size_t& work, bool& complete) {
  Search search(task, work);
  std::size_t size = 1;
  bool more = true;
  while (more && work > 0 && search.found.size() < evidence_cap) more = search.round(size++);
  search.keep_minimal();
  complete = !more;
  return search.found;
}

}  // namespace heed::awareness
