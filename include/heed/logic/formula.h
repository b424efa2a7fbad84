#pragma once

#include <heed/util/source.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace heed::logic {

/// What stands at a node of a formula. `Name` is a Boolean variable where a truth value is expected and an
/// integer or enumerated variable, or an enumeration's value, below a comparison. `Next` applies to formulas
/// and to terms: `x'`.
enum class Op : std::uint8_t {
  True,
  False,
  Name,
  Number,
  Not,
  And,
  Or,
  Implies,
  Iff,  // And, Or: two or more operands
  Eq,
  Ne,
  Lt,
  Le,
  Gt,
  Ge,  // comparisons of two terms
  Add,
  Sub,
  Mul,  // integer terms
  Next,
  Always,
  Eventually,
  Until,
  WeakUntil,
  Release,
  Previous,
  Once,
  Historically,
  Since  // Previous is false at the first step
};

/// An immutable formula of linear temporal logic with past, or a term below a comparison; a value that shares
/// its parts. Equality is structural and fast: pointers first, then hashes. Depth may be 10,000 and more:
/// every pass over a formula is a loop over postorder(), never a recursion.
class Formula {
 public:
  struct Node;
  /// `true`.
  Formula();

  [[nodiscard]] Op op() const;
  [[nodiscard]] const std::string& name() const;  ///< \pre op() == Op::Name
  [[nodiscard]] std::int64_t number() const;      ///< \pre op() == Op::Number
  [[nodiscard]] std::span<const Formula> operands() const;
  [[nodiscard]] const Formula& operator[](std::size_t i) const { return operands()[i]; }
  [[nodiscard]] std::uint64_t hash() const;                           ///< The same in every run.
  [[nodiscard]] const void* identity() const { return node_.get(); }  ///< For memo tables within one pass.
  /// Where it was read, for messages; takes no part in equality. Line 0 when built by a program.
  [[nodiscard]] const util::Location& location() const;

  /// Whether a Next stands at it or below it. Constant time.
  [[nodiscard]] bool has_next() const;

  [[nodiscard]] bool is_true() const { return op() == Op::True; }
  [[nodiscard]] bool is_false() const { return op() == Op::False; }
  friend bool operator==(const Formula& a, const Formula& b);

  /// The general constructor; the functions below are the usual way. No simplification.
  static Formula make(Op op, std::vector<Formula> operands, util::Location location = {});
  static Formula make_name(std::string name, util::Location location = {});
  static Formula make_number(std::int64_t number, util::Location location = {});

 private:
  explicit Formula(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  std::shared_ptr<const Node> node_;
};

// Builders that simplify constants, flatten And/Or, drop duplicate neighbours and double negation; nothing
// else.
[[nodiscard]] Formula truth(bool value);
[[nodiscard]] Formula name(std::string name);
[[nodiscard]] Formula number(std::int64_t value);
[[nodiscard]] Formula operator!(const Formula& a);
[[nodiscard]] Formula operator&&(const Formula& a, const Formula& b);
[[nodiscard]] Formula operator||(const Formula& a, const Formula& b);
[[nodiscard]] Formula implies(const Formula& a, const Formula& b);
[[nodiscard]] Formula iff(const Formula& a, const Formula& b);
[[nodiscard]] Formula all_of(std::vector<Formula> parts);  ///< `true` when empty
[[nodiscard]] Formula any_of(std::vector<Formula> parts);  ///< `false` when empty
[[nodiscard]] Formula compare(Op comparison, const Formula& left, const Formula& right);
[[nodiscard]] Formula next(const Formula& a);
[[nodiscard]] Formula always(const Formula& a);
[[nodiscard]] Formula eventually(const Formula& a);

/// Every distinct node (by identity) of \p root, operands before what uses them; \p root comes last.
/// O(nodes).
[[nodiscard]] std::vector<Formula> postorder(const Formula& root);

struct FormulaHash {
  std::size_t operator()(const Formula& f) const { return static_cast<std::size_t>(f.hash()); }
};

}  // namespace heed::logic
