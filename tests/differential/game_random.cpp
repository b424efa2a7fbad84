#include "game_random.h"

#include <heed/util/random.h>

#include <fmt/format.h>

namespace heed::reference {
namespace {

using logic::Formula;
using logic::Op;

/// What a formula may speak of.
struct Scope {
  std::vector<model::Variable> current, primed;
  std::vector<std::string> definitions;
  bool primed_definitions = false;
};

class Maker {
 public:
  explicit Maker(std::uint64_t seed) : random_(seed, 7) {}

  spec::Gr1 make() {
    declare();
    plant_choice_ = chance(4);
    const std::vector<model::Variable> all = joined({&inputs_, &outputs_, &memories_});
    add_definitions(all);
    add_memories(all);
    const Scope present{all, {}, names_, false};
    const Scope steps{all, all, names_, true};
    const Scope environment{all, inputs_, names_, false};
    clauses(spec_.env_init, {inputs_, {}, {}, false}, random_.below(2));
    if (!plant_choice_)
      clauses(spec_.env_safety,
              chance(2) ? environment : Scope{joined({&inputs_, &memories_}), {}, {}, false},
              random_.below(3));
    clauses(spec_.env_justice, chance(2) ? steps : present, random_.below(3));
    clauses(spec_.sys_init, present, random_.below(2));
    clauses(spec_.sys_safety, steps, random_.below(3));
    if (chance(2)) clauses(spec_.sys_safety, present, 1);
    clauses(spec_.sys_justice, chance(2) ? steps : present, random_.below(3));
    spec_.timing = chance(3) ? spec::Timing::Moore : spec::Timing::Mealy;
    spec_.initial = chance(2) ? spec::InitialQuantifiers::ForallExists
                              : static_cast<spec::InitialQuantifiers>(random_.below(4));
    return std::move(spec_);
  }

 private:
  [[nodiscard]] bool chance(std::uint32_t in) { return random_.below(in) == 0; }

  static std::vector<model::Variable> joined(
      std::initializer_list<const std::vector<model::Variable>*> lists) {
    std::vector<model::Variable> result;
    for (const auto* list : lists) result.insert(result.end(), list->begin(), list->end());
    return result;
  }

  model::Domain domain() {
    if (!chance(5)) return model::Domain::boolean();
    if (chance(2)) return model::Domain::integer(-1, 1);
    return model::Domain::enumeration({"red", "green", "blue"});
  }

  void declare() {
    spec_.name = "random";
    for (std::uint32_t i = 0, n = random_.below(4); i < n; ++i)
      inputs_.push_back({fmt::format("a{}", i), domain(), {}, {}});
    for (std::uint32_t i = 0, n = random_.below(4); i < n; ++i)
      outputs_.push_back({fmt::format("y{}", i), domain(), {}, {}});
    if (inputs_.empty() && outputs_.empty()) outputs_.push_back({"y", model::Domain::boolean(), {}, {}});
    for (std::uint32_t i = 0, n = chance(2) ? 0 : 1 + random_.below(2); i < n; ++i)
      memories_.push_back({fmt::format("m{}", i), domain(), {}, {}});
    spec_.inputs = inputs_;
    for (const auto& v : outputs_) spec_.outputs.push_back({v, model::OutputRole::Output});
  }

  void add_definitions(const std::vector<model::Variable>& all) {
    for (std::uint32_t i = 0, n = chance(2) ? 0 : 1 + random_.below(2); i < n; ++i) {
      const std::string name = fmt::format("d{}", i);
      spec_.definitions.push_back({name, formula({all, {}, names_, false}, 2)});
      names_.push_back(name);
    }
  }

  void add_memories(const std::vector<model::Variable>& all) {
    const Scope scope{all, inputs_, names_, false};
    for (const auto& variable : memories_) {
      spec::Memory memory{variable, {}, {}, {}};
      memory.initial = {variable.domain.low};
      if (plant_choice_) {
        memory.role = model::OutputRole::Plant;
        memory.initial.push_back(variable.domain.high);
      }
      if (variable.domain.kind == model::Domain::Kind::Boolean)
        memory.update = formula(scope, 2);
      else
        for (std::uint32_t i = 0, n = 1 + random_.below(3); i < n; ++i)
          memory.cases.push_back({formula(scope, 2), code(variable.domain)});
      spec_.memories.push_back(std::move(memory));
    }
  }

  std::int32_t code(const model::Domain& domain) {
    return domain.low + static_cast<std::int32_t>(random_.below(static_cast<std::uint32_t>(domain.size())));
  }

  void clauses(std::vector<spec::Clause>& part, const Scope& scope, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) part.push_back({formula(scope, 2 + random_.below(2)), {}, {}});
  }

  Formula formula(const Scope& scope, std::uint32_t depth) {
    if (depth == 0 || chance(6)) return atom(scope);
    const Formula left = formula(scope, depth - 1);
    if (chance(4)) return Formula::make(Op::Not, {left});
    const Formula right = formula(scope, depth - 1);
    constexpr Op ops[] = {Op::And, Op::Or, Op::Or, Op::Implies, Op::Iff};
    return Formula::make(ops[random_.below(5)], {left, right});
  }

  Formula atom(const Scope& scope) {
    if (!scope.definitions.empty() && chance(4)) {
      const Formula d = Formula::make_name(scope.definitions[random_.below(size(scope.definitions))]);
      return scope.primed_definitions && chance(2) ? Formula::make(Op::Next, {d}) : d;
    }
    const bool primed = !scope.primed.empty() && (scope.current.empty() || chance(2));
    const auto& variables = primed ? scope.primed : scope.current;
    if (variables.empty()) return Formula::make(chance(2) ? Op::True : Op::False, {});
    const model::Variable& variable = variables[random_.below(size(variables))];
    return about(variable, variables, primed);
  }

  Formula about(const model::Variable& variable, const std::vector<model::Variable>& others, bool primed) {
    const auto wrapped = [&](const Formula& f) { return primed ? Formula::make(Op::Next, {f}) : f; };
    const Formula name = wrapped(Formula::make_name(variable.name));
    if (variable.domain.kind == model::Domain::Kind::Boolean) return name;
    if (variable.domain.kind == model::Domain::Kind::Enumeration) {
      const Formula value = Formula::make_name(variable.domain.values[random_.below(3)]);
      return Formula::make(chance(2) ? Op::Eq : Op::Ne, {name, value});
    }
    constexpr Op comparisons[] = {Op::Eq, Op::Ne, Op::Lt, Op::Le, Op::Gt, Op::Ge};
    Formula right = Formula::make_number(static_cast<std::int64_t>(random_.below(3)) - 1);
    for (const model::Variable& other : others)
      if (other.domain.kind == model::Domain::Kind::Integer && chance(2)) {
        constexpr Op arithmetic[] = {Op::Add, Op::Sub, Op::Mul};
        right = Formula::make(arithmetic[random_.below(3)], {wrapped(Formula::make_name(other.name)), right});
      }
    return Formula::make(comparisons[random_.below(6)], {name, right});
  }

  template <typename T>
  static std::uint32_t size(const std::vector<T>& list) {
    return static_cast<std::uint32_t>(list.size());
  }

  util::CounterRandom random_;
  spec::Gr1 spec_;
  std::vector<model::Variable> inputs_, outputs_, memories_;
  std::vector<std::string> names_;
  /// Plants whose initial state the system chooses; then no assumption speaks of that choice.
  bool plant_choice_ = false;
};

}  // namespace

spec::Gr1 random_spec(std::uint64_t seed) {
  return Maker(seed).make();
}

}  // namespace heed::reference
