#include "extract.h"

#include "cofactors.h"
#include "latch.h"
#include "states.h"
#include "symbolic.h"
#include "walk.h"

#include <heed/spec/gr1.h>

#include <algorithm>
#include <cassert>
#include <unordered_map>

namespace heed::strategy {
namespace {

using bdd::Bdd;
using bdd::Var;
using game::Owner;

/// Functions of a state's future, in this order; the updates of the memories' bits follow.
enum Slot : std::size_t { Legal, Moves, Waits, Met, Updates };

/// How many answers are looked at for one that leads to a state that is there already.
constexpr std::size_t most_answers = 16;

/// Where a bit stands in a valuation.
struct Place {
  std::size_t variable;
  std::int32_t weight;
};

std::vector<Place> places(const game::Game& game, Owner owner) {
  std::vector<Place> result;
  std::size_t index = 0;
  for (const game::Encoded& variable : game.variables) {
    if (variable.owner != owner) continue;
    for (std::size_t i = variable.bits.size(); i-- > 0;)
      result.push_back({index, static_cast<std::int32_t>(std::int64_t{1} << i)});
    ++index;
  }
  return result;
}

model::Valuation lowest(const game::Game& game, Owner owner) {
  model::Valuation values;
  for (const game::Encoded& variable : game.variables)
    if (variable.owner == owner) values.push_back(variable.variable.domain.low);
  return values;
}

/// The system's answer to one next input: the same wherever the rest of the future is the same.
struct Answer {
  std::uint32_t number = 0;  ///< Of all answers.
  std::vector<bool> bits;    ///< Outputs, then memories.
  model::Valuation values;
  bool waits = false;
  bool met = false;
};

/// Lists the machine state by state. A state is the vector of functions that is left of (legal inputs, rule,
/// updates) once the play's current values are put in; its letters are listed by walking that vector, the
/// rules of all goals over the step to come, and the columns, all three along the same input bits at once.
/// \cite ehlers.16.cav
class Extractor {
 public:
  Extractor(const game::Game& game, const game::Region& region, util::Budget& budget, const Options& options)
      : game_(game),
        region_(region),
        budget_(budget),
        options_(options),
        moore_(game.spec->timing == spec::Timing::Moore),
        goals_(game.sys_justice.size()),
        input_places_(places(game, Owner::Input)),
        output_places_(places(game, Owner::Output)),
        memory_places_(places(game, Owner::Memory)),
        input_order_(by_level()),
        state_(key_order()),
        future_(step_order()),
        columns_(step_order()),
        builder_(game.spec->name, game.spec->inputs, spec::controller_outputs(*game.spec)),
        latch_(game.spec->inputs, options.on_violation == OnViolation::Latch),
        letter_(lowest(game, Owner::Input)) {
    prepare_futures();
  }

  Extracted run() {
    StateKey start{initial_future(), 0, 0};
    states_.number(start);
    builder_.add_state();
    for (std::size_t i = 0; i < states_.size(); ++i) expand(static_cast<std::uint32_t>(i));
    add_assumptions();
    if (relies_)
      builder_.add_note(
          "somewhere it makes no progress of its own and waits for what is assumed to happen again and "
          "again");
    return {builder_.finish(), relies_};
  }

 private:
  /// Input bits from the top of the diagrams down, so that a step of the walk touches few nodes.
  [[nodiscard]] std::vector<std::size_t> by_level() const {
    const std::vector<Var> bits = game_.bits(Owner::Input, true);
    std::vector<std::size_t> order(bits.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return game_.manager->level(bits[a]) < game_.manager->level(bits[b]);
    });
    return order;
  }

  [[nodiscard]] std::vector<Var> key_order() const {
    const std::vector<Var> bits = game_.bits(Owner::Input, true);
    std::vector<Var> order;
    order.reserve(bits.size());
    for (const std::size_t i : input_order_) order.push_back(bits[i]);
    return order;
  }

  [[nodiscard]] std::vector<Var> step_order() const {
    const std::vector<Var> bits = game_.bits(Owner::Input, false);
    std::vector<Var> order;
    order.reserve(bits.size());
    for (const std::size_t i : input_order_) order.push_back(bits[i]);
    for (const Owner owner : {Owner::Output, Owner::Memory})
      for (const Var variable : game_.bits(owner, false)) order.push_back(variable);
    return order;
  }

  void prepare_futures() {
    const Bdd never = game_.manager->constant(false);
    std::vector<Bdd> roots{legal_inputs(game_)};
    roots.insert(roots.end(), game_.updates.begin(), game_.updates.end());
    std::vector<Bdd> columns = game_.definitions;
    const std::vector<Rule> rules = make_rules(game_, region_, budget_);
    for (std::size_t goal = 0; goal < goals_; ++goal) {
      const game::Justice& justice = game_.sys_justice[goal];
      roots.insert(roots.end(),
                   {rules[goal].moves, rules[goal].waits, justice.step ? justice.relation : never});
      columns.push_back(justice.step ? never : justice.relation);
    }
    future_root_ = future_.root(std::move(roots));
    columns_root_ = columns_.root(std::move(columns));
    const std::vector<Var> outputs = game_.bits(Owner::Output, true);
    const std::vector<Var> memories = game_.bits(Owner::Memory, true);
    output_bits_ = outputs;
    memory_bits_ = memories;
    valid_inputs_ = game_.valid.exists(game_.outputs & game_.memories).next();
  }

  /// The first step as if it came from a state before it: inputs and answers are those of theta.
  Cofactors::Id initial_future() {
    Bdd legal = game_.initial_inputs();
    Bdd answers = game_.initial_answer() & region_.winning;
    const Bdd chosen = game_.outputs & game_.memories;
    if (game_.spec->initial == spec::InitialQuantifiers::ExistsForall) {
      const Bdd always = legal.implies(answers).forall(game_.inputs);
      std::vector<Var> bits = game_.bits(Owner::Memory, false);
      for (const Var variable : game_.bits(Owner::Output, false)) bits.push_back(variable);
      answers &= always.pick_cube(bits);
    } else if (game_.spec->initial == spec::InitialQuantifiers::ExistsExists) {
      legal &= answers.exists(chosen);
    }
    const Bdd never = game_.manager->constant(false);
    std::vector<Bdd> roots{legal.next(), answers.next(), never, never};
    return state_.root(std::move(roots));
  }

  /// What is left of the rules of one goal after a step: the key of the state that the step leads to.
  Cofactors::Id future_of(Cofactors::Id end, std::size_t goal) {
    const std::uint64_t memo = std::uint64_t{end} * goals_ + goal;
    const auto found = keys_.find(memo);
    if (found != keys_.end()) return found->second;
    const std::vector<Bdd>& left = future_.functions(end);
    const std::size_t updates = game_.updates.size();
    const std::size_t base = 1 + updates + 3 * goal;
    std::vector<Bdd> roots{left[0], left[base], left[base + 1], left[base + 2]};
    roots.insert(roots.end(), left.begin() + 1, left.begin() + 1 + static_cast<std::ptrdiff_t>(updates));
    const Cofactors::Id id = state_.root(std::move(roots));
    keys_.emplace(memo, id);
    return id;
  }

  void expand(std::uint32_t state) {
    budget_.check();
    from_ = state;
    key_ = states_[state];
    first_step_ = state == 0;
    latch_.clear();
    if (moore_ && !first_step_) {
      const Bdd& moves = state_.functions(key_.future)[Moves];
      choice_ = moves.is_false() ? std::vector<bool>(output_bits_.size()) : moves.pick(output_bits_);
    }
    walk({0, 0, key_.future, future_root_, columns_root_});
    if (options_.on_violation == OnViolation::Latch)
      latch_.fill(key_.observation, [&](const model::Valuation& letter, const LegalRow& row) {
        count_row();
        if (first_step_ && is_left_out(letter)) return;
        builder_.add(from_, {builder_.input_letter(letter), row.output, row.next, true});
      });
  }

  /// Whether the play could begin with \p letter, but the system, which may choose how it begins, does not
  /// want that: no assumption is broken then, so that no fallback may answer.
  [[nodiscard]] bool is_left_out(const model::Valuation& letter) const {
    if (game_.spec->initial != spec::InitialQuantifiers::ExistsExists) return false;
    const std::vector<Var> bits = game_.bits(Owner::Input, false);
    const model::Valuation low = lowest(game_, Owner::Input);
    return game_.initial_inputs().evaluate([&](Var variable) {
      const auto bit = static_cast<std::size_t>(std::find(bits.begin(), bits.end(), variable) - bits.begin());
      const Place& place = input_places_[bit];
      return ((letter[place.variable] - low[place.variable]) / place.weight) % 2 == 1;
    });
  }

  /// A place in the walk over one state's letters.
  struct Walk {
    std::size_t depth;
    LetterPaths::Id path;
    Cofactors::Id state, future, columns;
  };

  void walk(const Walk& at) {
    if (state_.functions(at.state)[Legal].is_false()) return;
    if (at.depth == input_order_.size()) {
      step(at);
      return;
    }
    const Place& place = input_places_[input_order_[at.depth]];
    for (const bool value : {false, true}) {
      if (value) letter_[place.variable] += place.weight;
      walk({at.depth + 1, paths_.step(at.path, value), state_.step(at.state, value),
            future_.step(at.future, value), columns_.step(at.columns, value)});
      if (value) letter_[place.variable] -= place.weight;
    }
  }

  /// Where an answer leads from a place in the walk.
  struct Step {
    Cofactors::Id future, columns;
    std::size_t goal;
  };

  [[nodiscard]] Step follow(const Walk& at, const Answer& answer) {
    Step step{at.future, at.columns, 0};
    for (const bool bit : answer.bits) {
      step.future = future_.step(step.future, bit);
      step.columns = columns_.step(step.columns, bit);
    }
    step.goal =
        next_goal(answer.met ? (key_.goal + 1) % goals_ : key_.goal, columns_.functions(step.columns));
    step.future = future_of(step.future, step.goal);
    return step;
  }

  void step(const Walk& at) {
    const Answer& answer = answer_to(at);
    const Step reached = follow(at, answer);
    relies_ = relies_ || answer.waits;
    const auto [letter, added] =
        output_letters_.try_emplace((std::uint64_t{answer.number} << 32) | reached.columns, 0U);
    if (added)
      letter->second = builder_.output_letter(output_of(answer, columns_.functions(reached.columns)));
    add_row({paths_.letter(at.path, letter_, builder_), letter->second, reached.future, false}, reached.goal);
  }

  [[nodiscard]] model::Valuation output_of(const Answer& answer, const std::vector<Bdd>& shown) const {
    model::Valuation output = answer.values;
    for (std::size_t i = 0; i < game_.definitions.size(); ++i) output.push_back(shown[i].is_true() ? 1 : 0);
    return output;
  }

  /// Goals that the new state meets are done; one that all states meet is as good as any.
  [[nodiscard]] std::size_t next_goal(std::size_t goal, const std::vector<Bdd>& shown) const {
    for (std::size_t i = 0; i < goals_; ++i) {
      const std::size_t candidate = (goal + i) % goals_;
      if (!shown[game_.definitions.size() + candidate].is_true()) return candidate;
    }
    return goal;
  }

  /// \param row  Its `next` is the future that it leads to, not yet a state.
  void add_row(model::Mealy::Transition row, std::size_t goal) {
    count_row();
    StateKey key{row.next, static_cast<std::uint32_t>(goal), 0};
    const bool latching = options_.on_violation == OnViolation::Latch;
    if (latching && !valid_inputs_.entails(state_.functions(row.next)[Legal]))
      key.observation = latch_.number(letter_);
    const auto [next, added] = states_.number(key);
    if (added) {
      if (states_.size() > options_.max_states)
        throw util::LimitExceeded(util::LimitExceeded::Kind::Size,
                                  "the strategy has too many states to list");
      builder_.add_state();
    }
    row.next = next;
    builder_.add(from_, row);
    if (latching) latch_.add(letter_, {row.output, next});
  }

  void count_row() {
    if ((++rows_ & 0xff) == 0) budget_.check();
    if (options_.max_rows != 0 && rows_ > options_.max_rows)
      throw util::LimitExceeded(util::LimitExceeded::Kind::Size, "the strategy has too many rows to list");
  }

  /// An answer that leads to a state that is there already, the one found first, keeps the machine small.
  /// Where none does, the least is taken: in the same situation always the same.
  const Answer& answer_to(const Walk& at) {
    std::vector<Answer>& known = answers_[at.state];
    if (moore_ || first_step_) {
      for (const Answer& answer : known)
        if (first_step_ || std::equal(choice_.begin(), choice_.end(), answer.bits.begin())) return answer;
      known.push_back(first_step_ ? first_answer(at.state) : later_answer(at.state, choice_));
      known.back().number = answer_count_++;
      return known.back();
    }
    if (known.empty()) list_answers(at.state, known);
    if (known.size() == 1) return known.front();
    const auto [choice, fresh] = choices_.try_emplace({at.state, at.future, key_.goal}, 0U);
    if (fresh) choice->second = best_of(at, known);
    return known[choice->second];
  }

  [[nodiscard]] std::uint32_t best_of(const Walk& at, const std::vector<Answer>& answers) {
    std::uint32_t best = 0, least = UINT32_MAX;
    for (std::uint32_t i = 0; i < answers.size(); ++i) {
      const Step reached = follow(at, answers[i]);
      const auto state = states_.find({reached.future, static_cast<std::uint32_t>(reached.goal), 0});
      if (!state || *state >= least) continue;
      best = i;
      least = *state;
    }
    return best;
  }

  /// In ascending order. Where a state may also depend on the observation, the first alone.
  void list_answers(Cofactors::Id state, std::vector<Answer>& answers) {
    const std::size_t most = options_.on_violation == OnViolation::Latch ? 1 : most_answers;
    const std::vector<Bdd>& left = state_.functions(state);
    std::vector<bdd::Literal> memories;
    for (std::size_t i = 0; i < memory_bits_.size(); ++i)
      memories.push_back({memory_bits_[i], left[Updates + i].is_true()});
    bdd::Assignments moves(left[Moves].cofactor(game_.manager->cube(memories)), output_bits_);
    while (answers.size() < most && moves.next()) {
      answers.push_back(later_answer(state, {moves.values().begin(), moves.values().end()}));
      answers.back().number = answer_count_++;
    }
    assert(!answers.empty());
  }

  /// Initial memories are chosen along, before the outputs.
  [[nodiscard]] Answer first_answer(Cofactors::Id state) const {
    std::vector<Var> bits = memory_bits_;
    bits.insert(bits.end(), output_bits_.begin(), output_bits_.end());
    std::vector<bool> picked = state_.functions(state)[Moves].pick(bits);
    std::rotate(picked.begin(), picked.begin() + static_cast<std::ptrdiff_t>(memory_bits_.size()),
                picked.end());
    return with_values({0, std::move(picked), {}, false, false});
  }

  [[nodiscard]] Answer later_answer(Cofactors::Id state, std::vector<bool> outputs) const {
    const std::vector<Bdd>& left = state_.functions(state);
    std::vector<bdd::Literal> literals;
    Answer answer;
    answer.bits = std::move(outputs);
    for (std::size_t i = 0; i < output_bits_.size(); ++i)
      literals.push_back({output_bits_[i], answer.bits[i]});
    for (std::size_t i = 0; i < memory_bits_.size(); ++i) {
      answer.bits.push_back(left[Updates + i].is_true());
      literals.push_back({memory_bits_[i], answer.bits.back()});
    }
    const Bdd step = game_.manager->cube(literals);
    answer.waits = !left[Waits].cofactor(step).is_false();
    answer.met = !left[Met].cofactor(step).is_false();
    return with_values(std::move(answer));
  }

  [[nodiscard]] Answer with_values(Answer answer) const {
    answer.values = lowest(game_, Owner::Output);
    const std::size_t outputs = answer.values.size();
    const model::Valuation memories = lowest(game_, Owner::Memory);
    answer.values.insert(answer.values.end(), memories.begin(), memories.end());
    for (std::size_t i = 0; i < answer.bits.size(); ++i) {
      if (!answer.bits[i]) continue;
      const bool output = i < output_places_.size();
      const Place& place = output ? output_places_[i] : memory_places_[i - output_places_.size()];
      answer.values[place.variable + (output ? 0 : outputs)] += place.weight;
    }
    return answer;
  }

  void add_assumptions() {
    for (std::string& text : assumption_texts(*game_.spec)) builder_.add_assumption(std::move(text));
  }

  const game::Game& game_;
  const game::Region& region_;
  util::Budget& budget_;
  const Options& options_;
  bool moore_;
  std::size_t goals_;
  std::vector<Place> input_places_, output_places_, memory_places_;
  std::vector<std::size_t> input_order_;
  Cofactors state_;    ///< Over X': the future of one state.
  Cofactors future_;   ///< Over X, Y, M: the futures, for all goals.
  Cofactors columns_;  ///< Over X, Y, M: definitions, then goals without Next.
  Cofactors::Id future_root_ = 0, columns_root_ = 0;
  std::vector<Var> output_bits_, memory_bits_;  ///< Next.
  Bdd valid_inputs_;
  std::unordered_map<std::uint64_t, Cofactors::Id> keys_;
  std::unordered_map<Cofactors::Id, std::vector<Answer>> answers_;
  std::unordered_map<Situation, std::uint32_t, SituationHash> choices_;  ///< Among the answers of its state.
  States states_;
  std::uint32_t answer_count_ = 0;
  /// The builder's number for an answer and the columns that go with it.
  std::unordered_map<std::uint64_t, std::uint32_t> output_letters_;
  LetterPaths paths_;
  model::MealyBuilder builder_;
  LatchRows latch_;
  std::uint64_t rows_ = 0;
  bool relies_ = false;

  // The state being expanded.
  std::uint32_t from_ = 0;
  StateKey key_;
  bool first_step_ = true;
  std::vector<bool> choice_;  ///< Moore: its answer.
  model::Valuation letter_;
};

}  // namespace

Extracted extract(const game::Game& game, const game::Region& region, util::Budget& budget,
                  const Options& options) {
  game.manager->set_automatic_reordering(false);
  return Extractor(game, region, budget, options).run();
}

}  // namespace heed::strategy
