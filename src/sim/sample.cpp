// Sampling. Each trace walks two tables, cell by cell: [chain state][random] gives what is reported, [machine
// state][letter] the controller's answer. Rejected: alias tables (every draw costs a comparison that branch
// prediction cannot learn; here most draws are decided by the top bits of a word), and tables over whole
// traces or outcomes (that would sample the exact result).
#include <heed/sim/sample.h>
#include <heed/util/random.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>

#include "letters.h"
#include "random_block.h"
#include "sample_tables.h"

namespace heed::sim {
namespace {

constexpr std::uint32_t no_word = UINT32_MAX;

/// Per cell: which of the trace's words decides it; `no_word` where no state leaves a choice.
std::vector<std::uint32_t> words_of_cells(const Chain& chain) {
  std::vector<std::uint32_t> result, layer{0};
  std::uint32_t used = 0;
  for (std::uint32_t cell = 0; cell < chain.cells; ++cell) {
    std::vector<std::uint32_t> next;
    bool choice = false;
    for (const std::uint32_t state : layer) {
      choice |= chain.first[state + 1] - chain.first[state] > 1;
      for (std::uint32_t i = chain.first[state]; i < chain.first[state + 1]; ++i)
        next.push_back(chain.steps[i].next);
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    layer = std::move(next);
    result.push_back(choice ? used++ : no_word);
  }
  return result;
}

/// A trace under way.
struct Walker {
  std::uint32_t chain = 0;  ///< Row of the draw table.
  std::uint32_t machine = 0;
  std::uint32_t event = 0;  ///< As in StepTable::Row: the first category, all flags.

  // Without a branch: whether the event comes now is what cannot be predicted.
  void take(const StepTable::Row& row) {
    const std::uint32_t open = (event & StepTable::category) == 0 ? StepTable::category : 0;
    machine = row.next;
    event |= row.event & (open | StepTable::fallback | StepTable::missing);
  }
};

}  // namespace

SampleOutcome sum(SampleOutcome a, const SampleOutcome& b) {
  for (std::size_t i = 0; i < a.count.size(); ++i) a.count[i] += b.count[i];
  a.undefined += b.undefined;
  a.missing += b.missing;
  a.fallback += b.fallback;
  a.traces += b.traces;
  return a;
}

struct Sampler::Tables {
  Tables(const Run& run, const Letters& letters, util::Budget& budget)
      : draws(run.chain, letters.of_step, budget),
        steps(run, letters.machine, budget),
        word_of_cell(words_of_cells(run.chain)),
        words(static_cast<std::uint32_t>(std::count_if(word_of_cell.begin(), word_of_cell.end(),
                                                       [](std::uint32_t word) { return word != no_word; }))),
        categories(run.judge.categories.size()),
        never(run.judge.never),
        first(run.chain.first) {
    for (const Chain::Step& step : run.chain.steps) {
      next.push_back(step.next);
      seen.push_back(step.seen);
    }
    start.take(steps.rows[0]);
  }

  using Group = std::array<Walker, lanes>;

  /// Moves every walker of the group through one cell.
  void move(Group& group, std::uint64_t seed, std::uint64_t stream, std::uint32_t word,
            const std::array<std::uint32_t, lanes>& drawn) const {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      Walker& walker = group[lane];
      DrawTable::Choice choice = draws.quick(walker.chain, drawn[lane]);
      if (choice.letter == DrawTable::undecided) [[unlikely]]
        choice = draws.careful(walker.chain, drawn[lane],
                               [&] { return word_at(seed, stream + lane, std::uint64_t{words} + word); });
      walker.chain = choice.next;
      walker.take(steps.rows[walker.machine + choice.letter]);
    }
  }

  static std::uint32_t word_at(std::uint64_t seed, std::uint64_t stream, std::uint64_t word) {
    const std::uint64_t block = word / 4;
    return util::philox({static_cast<std::uint32_t>(block), static_cast<std::uint32_t>(block >> 32),
                         static_cast<std::uint32_t>(stream), static_cast<std::uint32_t>(stream >> 32)},
                        {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)})[word % 4];
  }

  Group walk(std::uint64_t seed, std::uint64_t stream) const {
    static constexpr std::array<std::uint32_t, lanes> no_choice{};
    Group group;
    group.fill(start);
    RandomBlock block;
    for (const std::uint32_t word : word_of_cell) {
      if (word != no_word && word % 4 == 0) random_block(seed, stream, word / 4, block);
      move(group, seed, stream, word, word == no_word ? no_choice : block[word % 4]);
    }
    return group;
  }

  /// \param outcome  With category + 1 as index, 0 for a run without one.
  void count(const Walker& walker, SampleOutcome& outcome) const {
    const std::uint32_t category = walker.event & StepTable::category;
    if (walker.event != category) [[unlikely]] {
      const bool missing = (walker.event & StepTable::missing) != 0;
      outcome.fallback += (walker.event & StepTable::fallback) != 0;
      outcome.missing += missing;
      if (missing && category == 0) {
        ++outcome.undefined;
        return;
      }
    }
    ++outcome.count[category];
  }

  /// Traces first ... end-1. \param go_on  Asked now and then.
  template <typename GoOn>
  SampleOutcome run(std::uint64_t seed, std::uint64_t begin, std::uint64_t end, const GoOn& go_on) const {
    SampleOutcome outcome;
    outcome.count.resize(categories + 1);
    for (std::uint64_t trace = begin, group = 0; trace < end && (group % 256 != 0 || go_on());
         trace += lanes, ++group) {
      const Group walkers = walk(seed, trace);
      const std::size_t used = std::min<std::uint64_t>(lanes, end - trace);
      for (std::size_t lane = 0; lane < used; ++lane) count(walkers[lane], outcome);
    }
    outcome.count[never + 1] += outcome.count[0];
    outcome.count.erase(outcome.count.begin());
    outcome.traces = end - begin;
    return outcome;
  }

  DrawTable draws;
  StepTable steps;
  std::vector<std::uint32_t> word_of_cell;
  std::uint32_t words;  ///< Cells that leave a choice.
  std::size_t categories;
  std::uint32_t never;
  std::vector<std::uint32_t> first, next;
  std::vector<std::uint64_t> seen;
  Walker start;  ///< After the blank observation.
};

Sampler::Sampler(const Run& run, util::Budget& budget) {
  assert_fits(run);
  tables_ = std::make_unique<const Tables>(run, Letters(run), budget);
}
Sampler::~Sampler() = default;
Sampler::Sampler(Sampler&&) noexcept = default;
Sampler& Sampler::operator=(Sampler&&) noexcept = default;

namespace {

/// The traces of \p options that fall to this member of its team.
SampleOptions share_of(SampleOptions options) {
  const std::uint64_t size = options.team->size(), rank = options.team->rank();
  const std::uint64_t each = options.traces / size, more = options.traces % size;
  options.first += each * rank + std::min(rank, more);
  options.traces = each + (rank < more ? 1 : 0);
  return options;
}

void add_up(SampleOutcome& outcome, Team& team) {
  std::vector<std::uint64_t> numbers = outcome.count;
  numbers.insert(numbers.end(), {outcome.undefined, outcome.missing, outcome.fallback, outcome.traces});
  team.sum(numbers);
  const auto rest = numbers.begin() + static_cast<std::ptrdiff_t>(outcome.count.size());
  outcome = {{numbers.begin(), rest}, rest[0], rest[1], rest[2], rest[3]};
}

}  // namespace

SampleOutcome Sampler::sample(const SampleOptions& options, util::Budget& budget) const {
  if (options.team == nullptr) return draw(options, budget);
  SampleOutcome outcome = draw(share_of(options), budget);
  add_up(outcome, *options.team);
  return outcome;
}

// The calling thread does the first part and alone asks the budget, which is not made for several; when it
// gives up, the others see the flag.
SampleOutcome Sampler::draw(const SampleOptions& options, util::Budget& budget) const {
  const unsigned wanted =
      options.threads == 0 ? std::max(1U, std::thread::hardware_concurrency()) : options.threads;
  const auto parts = static_cast<unsigned>(std::clamp<std::uint64_t>(options.traces / 4096, 1, wanted));
  const auto begin_of = [&](unsigned part) {
    return options.first + options.traces / parts * part +
           std::min<std::uint64_t>(part, options.traces % parts);
  };
  std::atomic<bool> stop{false};
  std::vector<SampleOutcome> outcomes(parts);
  {
    std::vector<std::jthread> threads;
    for (unsigned part = 1; part < parts; ++part)
      threads.emplace_back([&, part] {
        outcomes[part] =
            tables_->run(options.seed, begin_of(part), begin_of(part + 1), [&] { return !stop.load(); });
      });
    try {
      outcomes[0] = tables_->run(options.seed, begin_of(0), begin_of(1), [&] {
        budget.check();
        return true;
      });
      while (!threads.empty()) {
        threads.back().join();
        threads.pop_back();
        budget.check();
      }
    } catch (...) {
      stop = true;
      throw;
    }
  }
  SampleOutcome together = std::move(outcomes[0]);
  for (unsigned part = 1; part < parts; ++part) together = sum(std::move(together), outcomes[part]);
  return together;
}

std::vector<std::uint64_t> Sampler::trace(std::uint64_t seed, std::uint64_t index) const {
  util::CounterRandom random(seed, index);
  std::vector<std::uint64_t> drawn(std::size_t{2} * tables_->words);
  for (std::uint64_t& word : drawn) word = random();
  std::vector<std::uint64_t> result;
  std::uint32_t state = 0;
  for (const std::uint32_t word : tables_->word_of_cell) {
    const std::uint64_t draw = word == no_word ? 0 : drawn[word] << 32 | drawn[tables_->words + word];
    const std::uint32_t step = tables_->draws.step_index(state, draw);
    result.push_back(tables_->seen[step]);
    state = tables_->next[step];
  }
  return result;
}

}  // namespace heed::sim
