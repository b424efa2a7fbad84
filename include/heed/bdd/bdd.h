#pragma once

#include <heed/util/limits.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Decision diagrams as values: reduced, ordered, with complement edges. \cite bryant.86.tc brace.90.dac
///
/// A Manager owns the nodes; a Bdd is a handle to one function in it. Equal functions of one manager are
/// equal handles. There are no globals: several managers can live in several threads, one manager belongs to
/// one thread at a time. Every operation may collect garbage and, where the manager allows it, reorder its
/// variables; handles stay valid. Every operation that builds nodes throws util::LimitExceeded when the
/// manager's budget says so or its own bounds are reached; all handles are valid afterwards and the manager
/// is usable. Mixing managers is a broken invariant (asserted).
namespace heed::bdd {

class Kernel;
class Manager;
struct Serialised;

/// A variable's number: the order of creation, from 0. It never changes; its level may.
using Var = std::uint32_t;

/// A state variable now and one step later; they stand on adjacent levels, current above next, whatever is
/// reordered.
struct Pair {
  Var current;
  Var next;
};

struct Literal {
  Var variable;
  bool value;
  bool operator==(const Literal&) const = default;
};

/// A handle to a Boolean function. Copying and moving cost a counter; the manager must outlive it (asserted).
class Bdd {
 public:
  /// Belongs to no manager; only assignment, destruction, `valid` and `==` may be used.
  Bdd() noexcept = default;
  Bdd(const Bdd& other) noexcept;
  Bdd(Bdd&& other) noexcept;
  Bdd& operator=(const Bdd& other) noexcept;
  Bdd& operator=(Bdd&& other) noexcept;
  ~Bdd();

  [[nodiscard]] bool valid() const noexcept { return kernel_ != nullptr; }
  [[nodiscard]] bool is_true() const noexcept { return valid() && edge_ == 0; }
  [[nodiscard]] bool is_false() const noexcept { return valid() && edge_ == 1; }
  [[nodiscard]] bool is_constant() const noexcept { return valid() && edge_ <= 1; }
  /// Same function of the same manager; constant time.
  [[nodiscard]] bool operator==(const Bdd& other) const noexcept {
    return kernel_ == other.kernel_ && edge_ == other.edge_;
  }
  /// For hashing and sorting: equal functions have equal ids while a handle to them lives. `f` and `!f`
  /// differ in bit 0.
  [[nodiscard]] std::uint32_t id() const noexcept { return edge_; }
  [[nodiscard]] Manager& manager() const;

  [[nodiscard]] Bdd operator!() const;
  [[nodiscard]] Bdd operator&(const Bdd& other) const;
  [[nodiscard]] Bdd operator|(const Bdd& other) const;
  [[nodiscard]] Bdd operator^(const Bdd& other) const;
  Bdd& operator&=(const Bdd& other) { return *this = *this & other; }
  Bdd& operator|=(const Bdd& other) { return *this = *this | other; }
  Bdd& operator^=(const Bdd& other) { return *this = *this ^ other; }
  [[nodiscard]] Bdd iff(const Bdd& other) const { return !(*this ^ other); }
  [[nodiscard]] Bdd implies(const Bdd& other) const { return !(*this & !other); }
  /// this & !other
  [[nodiscard]] Bdd minus(const Bdd& other) const { return *this & !other; }
  [[nodiscard]] Bdd ite(const Bdd& then, const Bdd& otherwise) const;

  /// Whether this -> other is valid. Builds no node.
  [[nodiscard]] bool entails(const Bdd& other) const;
  /// Whether this & other is satisfiable. Builds no node.
  [[nodiscard]] bool intersects(const Bdd& other) const { return !entails(!other); }

  /// \param cube  Conjunction of the variables to quantify (see Manager::cube).
  [[nodiscard]] Bdd exists(const Bdd& cube) const;
  [[nodiscard]] Bdd forall(const Bdd& cube) const;
  /// exists cube . this & other, in one pass. \cite burch.94.tcad
  [[nodiscard]] Bdd and_exists(const Bdd& other, const Bdd& cube) const;
  /// forall cube . this & other
  [[nodiscard]] Bdd and_forall(const Bdd& other, const Bdd& cube) const;
  /// forall cube . this | other, in one pass
  [[nodiscard]] Bdd or_forall(const Bdd& other, const Bdd& cube) const;
  /// forall cube . this -> other, in one pass
  [[nodiscard]] Bdd implies_forall(const Bdd& other, const Bdd& cube) const;

  /// Every current variable replaced by its next one. Unpaired variables stay.
  /// \pre No next variable of a pair whose current one is in the support (asserted where it shows).
  [[nodiscard]] Bdd next() const;
  /// Every next variable replaced by its current one; \pre as for next(), mirrored.
  [[nodiscard]] Bdd current() const;
  /// exists cube . this & other.next(), the shift made on the way; \p other as for next().
  [[nodiscard]] Bdd and_exists_next(const Bdd& other, const Bdd& cube) const;
  /// forall cube . this -> other.next(), the shift made on the way.
  [[nodiscard]] Bdd implies_forall_next(const Bdd& other, const Bdd& cube) const;
  /// this & other.next(), the shift made on the way.
  [[nodiscard]] Bdd and_next(const Bdd& other) const;

  /// The function with the literals of \p cube (a conjunction of literals) put in. \pre cube is not false
  [[nodiscard]] Bdd cofactor(const Bdd& cube) const;
  [[nodiscard]] Bdd cofactor(Var variable, bool value) const;
  /// A function that equals this one where \p care holds, often with fewer nodes, never with variables of \p
  /// care alone. \p care false gives false. \cite coudert.90.iccad
  [[nodiscard]] Bdd restrict(const Bdd& care) const;
  /// The generalised cofactor: this one at the point of \p care nearest in the order. \p care false gives
  /// false.
  [[nodiscard]] Bdd constrain(const Bdd& care) const;
  /// restrict(care) if that has fewer nodes, otherwise this.
  [[nodiscard]] Bdd minimise(const Bdd& care) const;
  /// All \p substitution at once: each variable replaced by its function; a variable is named at most once.
  [[nodiscard]] Bdd compose(std::span<const std::pair<Var, Bdd>> substitution) const;
  [[nodiscard]] Bdd compose(Var variable, const Bdd& function) const;

  /// Conjunction of the variables it depends on.
  [[nodiscard]] Bdd support() const;
  /// The variables it depends on, ascending by number.
  [[nodiscard]] std::vector<Var> support_variables() const;
  [[nodiscard]] bool depends_on(Var variable) const;

  /// Some satisfying cube: the literals on one path, by level; a choice that both ways could go takes false.
  /// \pre not false
  [[nodiscard]] std::vector<Literal> pick_path() const;
  /// The lexicographically least satisfying assignment of \p variables (the first is the most significant,
  /// false before true); the same whatever the variable order. Other variables are those of some extension.
  /// \pre not false
  [[nodiscard]] std::vector<bool> pick(std::span<const Var> variables) const;
  /// The same as a conjunction of literals.
  [[nodiscard]] Bdd pick_cube(std::span<const Var> variables) const;

  /// Satisfying assignments of \p variables many variables. \pre variables >= size of the support
  [[nodiscard]] double count(std::size_t variables) const;
  /// The exact number as little-endian words without leading zero words; empty means 0.
  [[nodiscard]] std::vector<std::uint64_t> count_words(std::size_t variables) const;
  /// The exact number in decimal.
  [[nodiscard]] std::string count_decimal(std::size_t variables) const;

  /// Nodes of this diagram, the terminal included.
  [[nodiscard]] std::size_t node_count() const;

  /// The value under an assignment indexed by variable number. \pre covers the support
  [[nodiscard]] bool evaluate(const std::vector<bool>& assignment) const;
  [[nodiscard]] bool evaluate(const std::function<bool(Var)>& assignment) const;

  /// The variable of the topmost node and the two cofactors by it. \pre not constant
  [[nodiscard]] Var top() const;
  [[nodiscard]] Bdd low() const;
  [[nodiscard]] Bdd high() const;

 private:
  friend class Manager;
  friend class Kernel;
  friend class CofactorTable;
  friend Serialised serialise(std::span<const Bdd> diagrams);
  Bdd(Kernel* kernel, std::uint32_t edge);

  Kernel* kernel_ = nullptr;
  std::uint32_t edge_ = 0;
  std::uint32_t slot_ = 0;
};

/// Bounds and policies of a manager. None of them depends on the clock.
struct ManagerOptions {
  std::size_t max_nodes = std::size_t{1} << 28;      ///< Also the greatest possible value.
  std::size_t initial_nodes = std::size_t{1} << 16;  ///< Nodes before the first collection.
  /// Of the computed cache, before it grows with the work.
  std::size_t initial_cache_bytes = std::size_t{1} << 16;
  std::size_t max_cache_bytes = std::size_t{1} << 29;  ///< Of the computed cache.
  bool automatic_reordering = true;                    ///< Sift when the live nodes have grown enough.
  std::size_t first_reordering = 20'000;  ///< Live nodes that set off the first automatic reordering.
  /// Recursion steps per live node since the last sifting that set off another one: small diagrams that are
  /// worked on for long deserve a better order too. 0: never.
  std::uint32_t steps_per_reordering = 150;
};

/// How far one call of sifting may go.
struct SiftOptions {
  double max_growth = 1.2;  ///< A group stops moving where the diagram is this much larger than at its best.
  std::size_t max_groups = 1000;   ///< Groups moved, those with most nodes first.
  std::size_t max_node_swaps = 0;  ///< Nodes visited by swaps; 0: bounded by a multiple of the live nodes.
  bool until_no_gain = false;      ///< Repeat while a pass gains one part in fifty.
};

/// What a manager did so far; counted, not timed.
struct Statistics {
  std::size_t live_nodes = 0;  ///< In the tables now, garbage included.
  std::size_t peak_nodes = 0;
  std::size_t memory_bytes = 0;     ///< Nodes, tables and cache.
  std::uint64_t steps = 0;          ///< Recursion steps that the computed cache could not answer.
  std::uint64_t cache_lookups = 0;  ///< Counted only when built with HEED_BDD_STATISTICS, else 0.
  std::uint64_t cache_hits = 0;
  std::uint64_t collections = 0;
  std::uint64_t reorderings = 0;
  std::uint64_t node_swaps = 0;
};

/// Owns variables and nodes. Not copied, not moved; outlives its handles.
class Manager {
 public:
  /// \param budget  Asked during long operations and before tables grow; may be null; must outlive the
  /// manager or be
  ///                replaced by set_budget.
  explicit Manager(const ManagerOptions& options = {}, util::Budget* budget = nullptr);
  Manager(const Manager&) = delete;
  Manager& operator=(const Manager&) = delete;
  ~Manager();

  void set_budget(util::Budget* budget);

  /// Variables are created at the bottom of the order.
  Var new_variable();
  Pair new_pair();
  /// \p size variables with consecutive numbers that stay adjacent in this order when groups are moved.
  /// \returns the first. \pre size > 0
  Var new_group(std::size_t size);
  [[nodiscard]] std::size_t variable_count() const;
  [[nodiscard]] bool is_paired(Var variable) const;
  /// The other variable of its pair. \pre is_paired(variable)
  [[nodiscard]] Var partner(Var variable) const;

  [[nodiscard]] Bdd constant(bool value);
  [[nodiscard]] Bdd variable(Var variable);
  [[nodiscard]] Bdd literal(Var variable, bool value);
  /// Conjunction of \p variables, for quantification. In any order; a repeated one counts once.
  [[nodiscard]] Bdd cube(std::span<const Var> variables);
  /// Conjunction of \p literals; false if two contradict.
  [[nodiscard]] Bdd cube(std::span<const Literal> literals);
  /// Conjunction and disjunction of many, combined in a balanced tree.
  [[nodiscard]] Bdd conjunction(std::span<const Bdd> operands);
  [[nodiscard]] Bdd disjunction(std::span<const Bdd> operands);
  /// exists cube . conjunction, each variable quantified as soon as no later conjunct has it.
  [[nodiscard]] Bdd conjunction_exists(std::span<const Bdd> operands, const Bdd& cube);

  /// Nodes of several diagrams together, shared ones once, the terminal included.
  [[nodiscard]] std::size_t node_count(std::span<const Bdd> diagrams) const;

  /// A function of another manager rebuilt here. \p map gives for each variable there the variable here;
  /// empty: the same numbers. \pre every variable of the support exists here
  [[nodiscard]] Bdd transfer(const Bdd& source, std::span<const Var> map = {});

  [[nodiscard]] std::size_t level(Var variable) const;
  /// All variables, top first.
  [[nodiscard]] std::vector<Var> order() const;
  /// \pre a permutation of all variables in which every group stands together in its own order
  void set_order(std::span<const Var> order);
  /// Sift groups now. \cite rudell.93.iccad panda.95.iccad
  void sift(const SiftOptions& options = {});
  void set_automatic_reordering(bool on);
  /// ManagerOptions::steps_per_reordering from now on.
  void set_steps_per_reordering(std::uint32_t steps);
  [[nodiscard]] bool automatic_reordering() const;
  /// The options that automatic reordering uses.
  void set_sift_options(const SiftOptions& options);

  /// Drop every node that no handle reaches. Called by the manager itself when due.
  void collect_garbage();
  [[nodiscard]] Statistics statistics() const;
  /// Whether every structural invariant holds (canonicity, tables, order); for tests, linear in the nodes.
  [[nodiscard]] bool consistent() const;

 private:
  friend class Bdd;
  friend class Assignments;
  friend class CofactorTable;
  std::unique_ptr<Kernel> kernel_;
};

/// Walks through all satisfying assignments of \p variables in ascending order: the first variable is the
/// most significant, false before true. Linear in the output times the number of variables when these follow
/// the level order.
///
///     for (Assignments a(f, vars); a.next();) use(a.values());
class Assignments {
 public:
  /// \pre the support of \p function lies in \p variables
  Assignments(const Bdd& function, std::span<const Var> variables);
  /// Step to the first or next one. \returns false at the end
  bool next();
  /// One per variable, 0 or 1, in the order given.
  [[nodiscard]] const std::vector<std::uint8_t>& values() const { return values_; }

 private:
  bool descend(std::size_t depth);

  std::vector<Var> variables_;
  std::vector<Bdd> rest_;
  std::vector<std::uint8_t> values_;
  bool started_ = false;
};

/// Diagrams as plain data: what goes to another manager, thread or file.
struct Serialised {
  struct Node {
    Var variable;
    std::uint32_t
        low;  ///< Reference: 2 * index + complement; index 0 is `true`, index i > 0 is nodes[i - 1].
    std::uint32_t high;  ///< As low; never complemented.
    bool operator==(const Node&) const = default;
  };
  std::vector<Var> order;            ///< Variables of the diagrams, top first.
  std::vector<Node> nodes;           ///< Children before parents.
  std::vector<std::uint32_t> roots;  ///< References.
  bool operator==(const Serialised&) const = default;
};

/// Deterministic: equal functions under equal orders give equal data. \pre all of one manager
[[nodiscard]] Serialised serialise(std::span<const Bdd> diagrams);
/// \param map  As for Manager::transfer.
/// \throws util::InputError  A reference or variable that does not exist.
[[nodiscard]] std::vector<Bdd> deserialise(Manager& manager, const Serialised& data,
                                           std::span<const Var> map = {});

}  // namespace heed::bdd

template <>
struct std::hash<heed::bdd::Bdd> {
  std::size_t operator()(const heed::bdd::Bdd& function) const noexcept { return function.id(); }
};
