#include "extract.h"

#include "latch.h"
#include "routes.h"
#include "states.h"
#include "steps.h"
#include "symbolic.h"

#include <heed/spec/gr1.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <span>

namespace heed::strategy {
namespace {

using bdd::Bdd;
using bdd::Var;
using game::Owner;

/// How many answers are looked at for one that leads to a state that is there already.
constexpr std::size_t most_answers = 16;

constexpr std::size_t rows_per_check = 256;

/// Most machines have fewer rows.
constexpr std::size_t usual_rows = std::size_t{1} << 16;

/// The mode of the first step, which no later one shares.
constexpr std::uint32_t no_mode = UINT32_MAX;

model::Valuation lowest(const game::Game& game, Owner owner) {
  model::Valuation values;
  for (const game::Encoded& variable : game.variables)
    if (variable.owner == owner) values.push_back(variable.variable.domain.low);
  return values;
}

/// Lists the machine state by state. A state is what is left of the legal inputs and of the vector of
/// functions (rule, updates) once the play's current values are put in. Its letters are listed by following
/// the routes of the legal inputs with its rule; the routes also lead to what is left of the rules of all
/// goals over the step to come with the columns, into which an answer's bits are then put at once. What
/// follows from equal rests is looked up. \cite ehlers.16.cav
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
        steps_(game, region, budget),
        legal_(steps_.legal()),
        rules_(steps_.rules()),
        letters_(steps_.futures(), steps_.root()),
        output_bits_(game.bits(Owner::Output, true)),
        memory_bits_(game.bits(Owner::Memory, true)),
        place_of_output_(game.manager->variable_count(), output_bits_.size()),
        valid_inputs_(game.valid.exists(game.outputs & game.memories).next()),
        assignment_(game.manager->variable_count()),
        choices_(output_places_.size()),
        builder_(game.spec->name, game.spec->inputs, spec::controller_outputs(*game.spec)),
        latch_(game.spec->inputs, options.on_violation == OnViolation::Latch),
        routes_(legal_, letters_, input_route(game), lowest(game, Owner::Input), builder_),
        lowest_(lowest(game, Owner::Output)),
        outputs_(lowest_.size()),
        steps_before_(game.manager->statistics().steps),
        lefts_(input_places_.size() + 1) {
    const model::Valuation memories = lowest(game, Owner::Memory);
    lowest_.insert(lowest_.end(), memories.begin(), memories.end());
    for (std::size_t i = 0; i < output_bits_.size(); ++i) place_of_output_[output_bits_[i]] = i;
  }

  Extracted run() {
    const Future start = initial_future();
    states_.number({start.legal, start.rule, 0, 0});
    builder_.reserve(usual_rows);
    reactions_.reserve(usual_rows);
    builder_.add_state();
    for (std::uint32_t i = 0; i < states_.size(); ++i) expand(i);
    add_assumptions();
    if (relies_)
      builder_.add_note(
          "somewhere it makes no progress of its own and waits for what is assumed to happen again and "
          "again");
    budget_.reserve(builder_.bytes_to_finish());
    return {builder_.finish(), relies_};
  }

 private:
  /// The first step as if it came from a state before it: inputs and answers are those of theta.
  Future initial_future() {
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
    const std::vector<Bdd> first{legal.next()};
    std::vector<Bdd> roots{answers.next(), never, never};
    roots.resize(rules_.width(), never);
    return {legal_.root(first), rules_.root(roots)};
  }

  void expand(std::uint32_t state) {
    budget_.check();
    count_steps();
    from_ = state;
    key_ = states_[state];
    first_step_ = state == 0;
    latch_.clear();
    if (moore_ && !first_step_) {
      const Bdd moves = rules_.function(key_.future, Moves);
      choice_ = moves.is_false() ? std::vector<bool>(output_bits_.size()) : moves.pick(output_bits_);
      mode_ = modes_.number(std::array{key_.goal, choices_.number(choice_)}).first;
    } else {
      mode_ = first_step_ ? no_mode : key_.goal;
    }
    lefts_[0] = key_.future;
    if (!legal_.is_false(key_.legal, 0))
      routes_.each(key_.legal, [this](const Routes::Branch& branch) { follow(branch); });
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

  void follow(const Routes::Branch& branch) {
    if (branch.depth != 0) lefts_[branch.depth] = rules_.step(lefts_[branch.depth - 1], branch.value);
    if (branch.letter != Routes::none) step(letters_.leaf(branch.letter), lefts_[branch.depth]);
  }

  void step(const Letters::Leaf& letter, CofactorTable::Id left) {
    const Situation at{left, letter.future, mode_};
    const auto [number, fresh] = situations_.number(at.word());
    if (fresh) reactions_.push_back(react(at));
    Reaction& reaction = reactions_[number];
    relies_ = relies_ || reaction.waits;
    count_row();
    const bool latching = options_.on_violation == OnViolation::Latch;
    if (latching) letter_ = builder_.input_valuation(letter.number);
    if (latching || reaction.next == Reaction::unknown) reaction.next = next_state(reaction);
    builder_.add(from_, {letter.number, reaction.output, reaction.next, false});
    if (latching) latch_.add(letter_, {reaction.output, reaction.next});
  }

  [[nodiscard]] Reaction react(const Situation& at) {
    const auto [answer, end] = choose(at);
    return {step_letters_[end.step], steps_.leads_to(end), end.goal, answer.waits, Reaction::unknown};
  }

  /// An answer and where it leads, but for what is left of the rules there.
  struct Choice {
    Answer answer;
    End end{};
  };
  [[nodiscard]] Choice leading(const Situation& at, const Answer& answer) {
    const auto [step, added] = steps_.number(at.future, answer.bits);
    if (added) add_letter(step, answer.bits);
    return {answer, {step, steps_.goal_after(step, answer.met ? (key_.goal + 1) % goals_ : key_.goal)}};
  }

  void add_letter(std::uint32_t step, std::uint32_t bits) {
    const std::uint32_t columns = steps_.columns(step);
    const auto [number, added] = output_letters_.number(std::array{bits, columns});
    if (added) builders_letters_.push_back(builder_.output_letter(output_of(bits, columns)));
    step_letters_.push_back(builders_letters_[number]);
  }

  [[nodiscard]] model::Valuation output_of(std::uint32_t bits, std::uint32_t columns) const {
    model::Valuation output = values_of(bits);
    for (std::size_t i = 0; i < game_.definitions.size(); ++i)
      output.push_back(steps_.column(columns, i) ? 1 : 0);
    return output;
  }

  static StateKey key_of(const Future& future, std::uint32_t goal) {
    return {future.legal, future.rule, goal, 0};
  }

  [[nodiscard]] std::uint32_t next_state(const Reaction& reaction) {
    StateKey key = key_of(reaction.future, reaction.goal);
    if (options_.on_violation == OnViolation::Latch && !valid_inputs_.entails(legal_.function(key.legal, 0)))
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
    if (++rows_ % rows_per_check == 0) ask_for_more();
    if (options_.max_rows != 0 && rows_ > options_.max_rows)
      throw util::LimitExceeded(util::LimitExceeded::Kind::Size, "the strategy has too many rows to list");
  }

  void count_steps() const {
    if (options_.max_steps != 0 && game_.manager->statistics().steps - steps_before_ > options_.max_steps)
      throw util::LimitExceeded(util::LimitExceeded::Kind::Size, "the strategy takes too long to list");
  }

  /// What the next rows may make grow.
  void ask_for_more() {
    budget_.check();
    count_steps();
    const std::size_t vectors = rows_per_check * (input_places_.size() + 1);
    const std::size_t bytes = builder_.bytes_to_grow(rows_per_check) + states_.bytes_to_grow(rows_per_check) +
                              situations_.bytes_to_grow(rows_per_check) +
                              util::bytes_to_grow(reactions_, rows_per_check) +
                              legal_.bytes_to_grow(vectors) + rules_.bytes_to_grow(vectors);
    if (bytes != 0) budget_.reserve(bytes);
  }

  /// An answer that leads to a state that is there already, the one found first, keeps the machine small.
  /// Where none does, the least is taken: in the same situation always the same.
  [[nodiscard]] Choice choose(const Situation& at) {
    if (first_step_) return leading(at, first_answer(at.left));
    if (moore_) return leading(at, later_answer(at.left, choice_));
    if (answers_.size() <= at.left) answers_.resize(at.left + 1);
    if (answers_[at.left].count == 0) answers_[at.left] = list_answers(at.left);
    const std::span<const Answer> known{&answer_list_[answers_[at.left].first], answers_[at.left].count};
    return known.size() == 1 ? leading(at, known[0]) : best_of(at, known);
  }

  /// Steps that were followed before are asked first: most often one of them does.
  [[nodiscard]] Choice best_of(const Situation& at, std::span<const Answer> answers) {
    Choice best;
    std::uint32_t least = States::none;
    for (const bool followed : {true, false}) {
      for (const Answer& answer : answers) {
        const Choice choice = leading(at, answer);
        if (followed && !steps_.is_known(choice.end)) continue;
        const std::uint32_t state = states_.find(key_of(steps_.leads_to(choice.end), choice.end.goal));
        if (state < least) best = choice, least = state;
      }
      if (least != States::none) return best;
    }
    return leading(at, answers[0]);
  }

  /// In ascending order. Where a state may also depend on the observation, the first alone.
  [[nodiscard]] Answers list_answers(CofactorTable::Id state) {
    const std::size_t most = options_.on_violation == OnViolation::Latch ? 1 : most_answers;
    const auto first = static_cast<std::uint32_t>(answer_list_.size());
    if (rules_.literals(state, Moves, literals_) && fills_outputs(literals_)) {
      answer_list_.push_back(later_answer(state, sole_));
      return {first, 1};
    }
    std::vector<bdd::Literal> memories;
    for (std::size_t i = 0; i < memory_bits_.size(); ++i)
      memories.push_back({memory_bits_[i], rules_.is_true(state, Updates + i)});
    bdd::Assignments moves(rules_.function(state, Moves).cofactor(game_.manager->cube(memories)),
                           output_bits_);
    while (answer_list_.size() < first + most && moves.next())
      answer_list_.push_back(later_answer(state, {moves.values().begin(), moves.values().end()}));
    assert(answer_list_.size() > first);
    return {first, static_cast<std::uint32_t>(answer_list_.size() - first)};
  }

  /// Whether \p literals leave no choice of outputs; that answer is then sole_.
  [[nodiscard]] bool fills_outputs(const std::vector<bdd::Literal>& literals) {
    std::size_t filled = 0;
    sole_.resize(output_bits_.size());
    for (const auto& [variable, value] : literals) {
      const std::size_t place = place_of_output_[variable];
      if (place == output_bits_.size()) continue;
      sole_[place] = value;
      ++filled;
    }
    return filled == output_bits_.size();
  }

  /// Initial memories are chosen along, before the outputs.
  [[nodiscard]] Answer first_answer(CofactorTable::Id state) {
    std::vector<Var> bits = memory_bits_;
    bits.insert(bits.end(), output_bits_.begin(), output_bits_.end());
    std::vector<bool> picked = rules_.function(state, Moves).pick(bits);
    std::rotate(picked.begin(), picked.begin() + static_cast<std::ptrdiff_t>(memory_bits_.size()),
                picked.end());
    return {steps_.number_answer(picked), false, false};
  }

  [[nodiscard]] Answer later_answer(CofactorTable::Id state, std::vector<bool> bits) {
    for (std::size_t i = 0; i < output_bits_.size(); ++i) assignment_[output_bits_[i]] = bits[i];
    for (std::size_t i = 0; i < memory_bits_.size(); ++i) {
      bits.push_back(rules_.is_true(state, Updates + i));
      assignment_[memory_bits_[i]] = bits.back();
    }
    const bool waits = rules_.evaluate(state, Waits, assignment_),
               met = rules_.evaluate(state, Met, assignment_);
    return {steps_.number_answer(bits), waits, met};
  }

  /// \param bits  Outputs, then memories.
  [[nodiscard]] model::Valuation values_of(std::uint32_t bits) const {
    model::Valuation values = lowest_;
    for (std::size_t i = 0; i < steps_.answers().bits(); ++i) {
      if (!steps_.answers().bit(bits, i)) continue;
      const bool output = i < output_places_.size();
      const Place& place = output ? output_places_[i] : memory_places_[i - output_places_.size()];
      values[place.variable + (output ? 0 : outputs_)] += place.weight;
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
  Steps steps_;
  CofactorTable& legal_;  ///< Of steps_: legal inputs,
  CofactorTable& rules_;  ///< and all else of the future of one state.
  Letters letters_;
  std::vector<Var> output_bits_, memory_bits_;  ///< Next.
  std::vector<std::size_t> place_of_output_;    ///< By variable: in output_bits_, or its size.
  std::vector<bdd::Literal> literals_;          ///< Of the diagram that is looked at.
  std::vector<bool> sole_;                      ///< The outputs of an answer without choice.
  Bdd valid_inputs_;
  std::vector<bool> assignment_;             ///< By variable, for evaluation.
  BitWords choices_;                         ///< Moore's outputs.
  std::vector<std::uint32_t> step_letters_;  ///< The builder's, by step.
  std::vector<Answers> answers_;             ///< By what is left of a state.
  std::vector<Answer> answer_list_;
  util::WordTable modes_{2};       ///< Moore: goals and outputs that are chosen before the observation comes.
  util::WordTable situations_{3};  ///< Situations, and by number:
  std::vector<Reaction> reactions_;
  States states_;
  util::WordTable output_letters_{2};  ///< An answer and the columns that go with it, and by number:
  std::vector<std::uint32_t> builders_letters_;
  model::MealyBuilder builder_;
  LatchRows latch_;
  Routes routes_;
  model::Valuation lowest_;  ///< Of outputs, then memories,
  std::size_t outputs_;      ///< of which this many are outputs.
  std::uint64_t rows_ = 0;
  std::uint64_t steps_before_;  ///< Of the diagrams.
  bool relies_ = false;

  // The state being expanded.
  std::uint32_t from_ = 0;
  StateKey key_;
  bool first_step_ = true;
  std::vector<bool> choice_;  ///< Moore: its answer.
  std::uint32_t mode_ = 0;    ///< Its number in modes_; where no output is chosen before, the goal.
  std::vector<CofactorTable::Id> lefts_;  ///< What is left of its rules, by depth of the branch.
  model::Valuation letter_;               ///< Where the next state may depend on it.
};

}  // namespace

Extracted extract(const game::Game& game, const game::Region& region, util::Budget& budget,
                  const Options& options) {
  game.manager->set_automatic_reordering(false);
  return Extractor(game, region, budget, options).run();
}

}  // namespace heed::strategy
