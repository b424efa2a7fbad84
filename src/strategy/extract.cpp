#include "extract.h"

#include "cofactors.h"
#include "latch.h"
#include "states.h"
#include "symbolic.h"
#include "walk.h"

#include <heed/spec/gr1.h>

#include <algorithm>
#include <cassert>
#include <optional>
#include <span>
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

/// Lists the machine state by state. A state is the vector of functions that is left of (legal inputs, rule,
/// updates) once the play's current values are put in. Its letters are listed by walking that vector and,
/// along the same input bits, the rules of all goals over the step to come with the columns; an answer's bits
/// are then put in at once. What follows from equal rests is looked up. \cite ehlers.16.cav
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
        updates_(game.updates.size()),
        columns_at_(1 + updates_ + 3 * goals_),
        state_(*game.manager, ordered_inputs(true), Updates + updates_),
        future_(*game.manager, ordered_inputs(false), columns_at_ + game.definitions.size() + goals_),
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

  [[nodiscard]] std::vector<Var> ordered_inputs(bool next) const {
    const std::vector<Var> bits = game_.bits(Owner::Input, next);
    std::vector<Var> order;
    order.reserve(bits.size());
    for (const std::size_t i : input_order_) order.push_back(bits[i]);
    return order;
  }

  void prepare_futures() {
    const Bdd never = game_.manager->constant(false);
    std::vector<Bdd> roots{legal_inputs(game_)}, columns = game_.definitions;
    roots.insert(roots.end(), game_.updates.begin(), game_.updates.end());
    const std::vector<Rule> rules = make_rules(game_, region_, budget_);
    for (std::size_t goal = 0; goal < goals_; ++goal) {
      const game::Justice& justice = game_.sys_justice[goal];
      roots.insert(roots.end(),
                   {rules[goal].moves, rules[goal].waits, justice.step ? justice.relation : never});
      columns.push_back(justice.step ? never : justice.relation);
    }
    roots.insert(roots.end(), columns.begin(), columns.end());
    letters_.emplace(future_, future_.root(roots));
    output_bits_ = game_.bits(Owner::Output, true);
    memory_bits_ = game_.bits(Owner::Memory, true);
    for (const Owner owner : {Owner::Output, Owner::Memory})
      for (const Var variable : game_.bits(owner, false)) answer_bits_.push_back(variable);
    assignment_.resize(game_.manager->variable_count());
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
    roots.resize(Updates + updates_, never);
    return state_.root(roots);
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
      choice_number_ = choices_.number(choice_);
    }
    walk(0, Letters::root, key_.future);
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

  void walk(std::size_t depth, Letters::Id path, Cofactors::Id state) {
    if (state_.functions(state)[Legal].is_false()) return;
    if (depth == input_order_.size()) {
      step(letters_->leaf(path, letter_, builder_), state);
      return;
    }
    const Place& place = input_places_[input_order_[depth]];
    for (const bool value : {false, true}) {
      if (value) letter_[place.variable] += place.weight;
      walk(depth + 1, letters_->step(path, value), state_.step(state, value));
      if (value) letter_[place.variable] -= place.weight;
    }
  }

  void step(const Letters::Leaf& letter, Cofactors::Id left) {
    const Situation at{left, letter.future, static_cast<std::uint32_t>(key_.goal), choice_number_};
    const auto [known, fresh] = reactions_.try_emplace(at);
    if (fresh) known->second = react(at);
    Reaction& reaction = known->second;
    relies_ = relies_ || reaction.waits;
    count_row();
    const bool latching = options_.on_violation == OnViolation::Latch;
    if (latching || reaction.next == Reaction::unknown) reaction.next = next_state(reaction);
    builder_.add(from_, {letter.number, reaction.output, reaction.next, false});
    if (latching) latch_.add(letter_, {reaction.output, reaction.next});
  }

  [[nodiscard]] Reaction react(const Situation& at) {
    const Answer answer = answer_to(at);
    const Step reached = follow(at, answer);
    const auto [letter, added] =
        output_letters_.try_emplace((std::uint64_t{answer.bits} << 32) | reached.columns, 0U);
    if (added) letter->second = builder_.output_letter(output_of(answer.bits, columns_[reached.columns]));
    return {letter->second, reached.future, reached.goal, answer.waits, Reaction::unknown};
  }

  /// Where an answer leads.
  struct Step {
    Cofactors::Id future;
    std::uint32_t columns, goal;
  };

  [[nodiscard]] std::uint32_t columns_of(Cofactors::Id future, std::uint32_t bits) {
    const auto [known, fresh] = columns_of_.try_emplace((std::uint64_t{future} << 32) | bits, 0U);
    if (fresh) known->second = evaluate_columns(future, bits);
    return known->second;
  }

  [[nodiscard]] End end_of(const Situation& at, const Answer& answer) {
    const std::vector<bool>& shown = columns_[columns_of(at.future, answer.bits)];
    const std::size_t goal = next_goal(answer.met ? (at.goal + 1) % goals_ : at.goal, shown);
    return {at.future, answer.bits, static_cast<std::uint32_t>(goal)};
  }

  [[nodiscard]] Step follow(const Situation& at, const Answer& answer) {
    const End end = end_of(at, answer);
    return {future_of(end), columns_of(at.future, answer.bits), end.goal};
  }

  [[nodiscard]] std::uint32_t evaluate_columns(Cofactors::Id future, std::uint32_t bits) {
    const std::vector<bool>& values = bits_[bits];
    for (std::size_t i = 0; i < values.size(); ++i) assignment_[answer_bits_[i]] = values[i];
    const std::span<const Bdd> columns = future_.functions(future).subspan(columns_at_);
    std::vector<bool> shown(columns.size());
    for (std::size_t i = 0; i < shown.size(); ++i) shown[i] = columns[i].evaluate(assignment_);
    return columns_.number(std::move(shown));
  }

  /// What is left of the rules of one goal after a step: the key of the state that the step leads to.
  Cofactors::Id future_of(const End& end) {
    const std::size_t goal = end.goal;
    const auto [known, fresh] = keys_.try_emplace(end, Cofactors::none);
    if (!fresh) return known->second;
    const std::span<const Bdd> all = future_.functions(end.future);
    const Bdd& cube = cube_of(end.bits);
    std::vector<Bdd> left;
    left.reserve(Updates + updates_);
    const auto put_in = [&](std::span<const Bdd> functions) {
      for (const Bdd& function : functions)
        left.push_back(function.is_constant() ? function : function.cofactor(cube));
    };
    put_in(all.first(1));
    put_in(all.subspan(1 + updates_ + 3 * goal, 3));
    put_in(all.subspan(1, updates_));
    return known->second = state_.root(left);
  }

  [[nodiscard]] const Bdd& cube_of(std::uint32_t bits) {
    for (std::size_t i = cubes_.size(); i < bits_.size(); ++i) {
      std::vector<bdd::Literal> literals;
      for (std::size_t k = 0; k < answer_bits_.size(); ++k)
        literals.push_back({answer_bits_[k], bits_[static_cast<std::uint32_t>(i)][k]});
      cubes_.push_back(game_.manager->cube(literals));
    }
    return cubes_[bits];
  }

  [[nodiscard]] model::Valuation output_of(std::uint32_t bits, const std::vector<bool>& shown) const {
    model::Valuation output = values_of(bits_[bits]);
    for (std::size_t i = 0; i < game_.definitions.size(); ++i) output.push_back(shown[i] ? 1 : 0);
    return output;
  }

  /// Goals that the new state meets are done; one that all states meet is as good as any.
  [[nodiscard]] std::size_t next_goal(std::size_t goal, const std::vector<bool>& shown) const {
    for (std::size_t i = 0; i < goals_; ++i) {
      const std::size_t candidate = (goal + i) % goals_;
      if (!shown[game_.definitions.size() + candidate]) return candidate;
    }
    return goal;
  }

  [[nodiscard]] std::uint32_t next_state(const Reaction& reaction) {
    StateKey key{reaction.future, reaction.goal, 0};
    if (options_.on_violation == OnViolation::Latch &&
        !valid_inputs_.entails(state_.functions(key.future)[Legal]))
      key.observation = latch_.number(letter_);
    const auto [next, added] = states_.number(key);
    if (added) {
      if (states_.size() > options_.max_states)
        throw util::LimitExceeded(util::LimitExceeded::Kind::Size,
                                  "the strategy has too many states to list");
      builder_.add_state();
    }
    return next;
  }

  void count_row() {
    if ((++rows_ & 0xff) == 0) budget_.check();
    if (options_.max_rows != 0 && rows_ > options_.max_rows)
      throw util::LimitExceeded(util::LimitExceeded::Kind::Size, "the strategy has too many rows to list");
  }

  /// An answer that leads to a state that is there already, the one found first, keeps the machine small.
  /// Where none does, the least is taken: in the same situation always the same.
  [[nodiscard]] Answer answer_to(const Situation& at) {
    if (first_step_) return first_answer(at.left);
    if (moore_) return later_answer(at.left, choice_);
    std::vector<Answer>& known = answers_[at.left];
    if (known.empty()) list_answers(at.left, known);
    return known[known.size() == 1 ? 0 : best_of(at, known)];
  }

  /// Steps that were followed before are asked first: most often one of them does.
  [[nodiscard]] std::uint32_t best_of(const Situation& at, const std::vector<Answer>& answers) {
    std::uint32_t best = 0, least = UINT32_MAX;
    for (const bool known : {true, false}) {
      for (std::uint32_t i = 0; i < answers.size(); ++i) {
        if (known && !keys_.contains(end_of(at, answers[i]))) continue;
        const Step reached = follow(at, answers[i]);
        const auto state = states_.find({reached.future, reached.goal, 0});
        if (!state || *state >= least) continue;
        best = i;
        least = *state;
      }
      if (least != UINT32_MAX) break;
    }
    return best;
  }

  /// In ascending order. Where a state may also depend on the observation, the first alone.
  void list_answers(Cofactors::Id state, std::vector<Answer>& answers) {
    const std::size_t most = options_.on_violation == OnViolation::Latch ? 1 : most_answers;
    const std::span<const Bdd> left = state_.functions(state);
    std::vector<bdd::Literal> memories;
    for (std::size_t i = 0; i < memory_bits_.size(); ++i)
      memories.push_back({memory_bits_[i], left[Updates + i].is_true()});
    bdd::Assignments moves(left[Moves].cofactor(game_.manager->cube(memories)), output_bits_);
    while (answers.size() < most && moves.next())
      answers.push_back(later_answer(state, {moves.values().begin(), moves.values().end()}));
    assert(!answers.empty());
  }

  /// Initial memories are chosen along, before the outputs.
  [[nodiscard]] Answer first_answer(Cofactors::Id state) {
    std::vector<Var> bits = memory_bits_;
    bits.insert(bits.end(), output_bits_.begin(), output_bits_.end());
    std::vector<bool> picked = state_.functions(state)[Moves].pick(bits);
    std::rotate(picked.begin(), picked.begin() + static_cast<std::ptrdiff_t>(memory_bits_.size()),
                picked.end());
    return {bits_.number(std::move(picked)), false, false};
  }

  [[nodiscard]] Answer later_answer(Cofactors::Id state, std::vector<bool> bits) {
    const std::span<const Bdd> left = state_.functions(state);
    for (std::size_t i = 0; i < output_bits_.size(); ++i) assignment_[output_bits_[i]] = bits[i];
    for (std::size_t i = 0; i < memory_bits_.size(); ++i) {
      bits.push_back(left[Updates + i].is_true());
      assignment_[memory_bits_[i]] = bits.back();
    }
    const bool waits = left[Waits].evaluate(assignment_), met = left[Met].evaluate(assignment_);
    return {bits_.number(std::move(bits)), waits, met};
  }

  /// \param bits  Outputs, then memories.
  [[nodiscard]] model::Valuation values_of(const std::vector<bool>& bits) const {
    model::Valuation values = lowest(game_, Owner::Output);
    const std::size_t outputs = values.size();
    const model::Valuation memories = lowest(game_, Owner::Memory);
    values.insert(values.end(), memories.begin(), memories.end());
    for (std::size_t i = 0; i < bits.size(); ++i) {
      if (!bits[i]) continue;
      const bool output = i < output_places_.size();
      const Place& place = output ? output_places_[i] : memory_places_[i - output_places_.size()];
      values[place.variable + (output ? 0 : outputs)] += place.weight;
    }
    return values;
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
  std::size_t updates_;
  std::size_t columns_at_;  ///< In the vectors of future_.
  Cofactors state_;         ///< Over X': the future of one state.
  Cofactors future_;        ///< Over X: the futures of all goals, then definitions and goals without Next.
  std::optional<Letters> letters_;
  std::vector<Var> output_bits_, memory_bits_;  ///< Next.
  std::vector<Var> answer_bits_;                ///< Current: outputs, then memories.
  Bdd valid_inputs_;
  std::vector<bool> assignment_;    ///< By variable, for evaluation.
  Words bits_, columns_, choices_;  ///< Of answers; of definitions and goals; of Moore's outputs.
  std::vector<Bdd> cubes_;          ///< By the number of an answer's bits.
  std::unordered_map<std::uint64_t, std::uint32_t> columns_of_;  ///< After a future's inputs and an answer.
  std::unordered_map<End, Cofactors::Id, EndHash> keys_;
  std::unordered_map<Cofactors::Id, std::vector<Answer>> answers_;
  std::unordered_map<Situation, Reaction, SituationHash> reactions_;
  States states_;
  /// The builder's number for an answer and the columns that go with it.
  std::unordered_map<std::uint64_t, std::uint32_t> output_letters_;
  model::MealyBuilder builder_;
  LatchRows latch_;
  std::uint64_t rows_ = 0;
  bool relies_ = false;

  // The state being expanded.
  std::uint32_t from_ = 0;
  StateKey key_;
  bool first_step_ = true;
  std::vector<bool> choice_;  ///< Moore: its answer.
  std::uint32_t choice_number_ = 0;
  model::Valuation letter_;
};

}  // namespace

Extracted extract(const game::Game& game, const game::Region& region, util::Budget& budget,
                  const Options& options) {
  game.manager->set_automatic_reordering(false);
  return Extractor(game, region, budget, options).run();
}

}  // namespace heed::strategy
