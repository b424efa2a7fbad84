#pragma once

#include <heed/logic/formula.h>

#include <cstddef>
#include <string>
#include <vector>

namespace heed::logic {

/// A Boolean memory that a requirement needs: what it is at the first step, and how the next value follows
/// from the step that is now. Deterministic and total, so that adding it never restricts either player.
struct Monitor {
  std::string name;
  bool initial = false;
  /// The value at the next step. Over current names and current monitors; a name is primed only where the
  /// requirement compares a term with its own next value (`x' = x + 1`) and looks back at that.
  Formula update;
  std::string remembers;  ///< For people: the formula whose last value it keeps (cut when huge).
};

/// A requirement as the parts of a GR(1) specification.
struct Lowered {
  std::vector<Formula> init;  ///< Holds at the first step. Neither Next nor monitors.
  std::vector<Formula>
      safety;  ///< Holds at every step, the first included; at most one level of Next, on names.
  std::vector<Formula> justice;  ///< Holds again and again; at most one level of Next, on names.
  std::vector<Monitor>
      monitors;  ///< Each uses only names of the requirement and other monitors; never primed.
};

struct LowerOptions {
  /// Monitors are called prefix + "1", prefix + "2", ...: choose what no name of the specification starts
  /// with.
  std::string prefix = "memory_";
  /// Parts that case distinctions may multiply to before the requirement is refused.
  std::size_t parts = 4096;
};

/// Compiles an LTL requirement (of the environment or of the system) into GR(1) parts: a word satisfies \p
/// requirement iff it satisfies init, G of each safety and GF of each justice, with the monitors run along.
///
/// "Local" below is anything made of X and past operators: what is known a fixed number of steps later. X to
/// any depth is looked back at from where it is known; Y O H S become one monitor each.
///
/// | requirement                                     | becomes                                        |
/// |-------------------------------------------------|------------------------------------------------|
/// | conjunctions, at the top and below G            | their parts                                    |
/// | local                                           | init, or safety once it is known               |
/// | G local                                         | safety                                         |
/// | GF local, F local                               | justice                                        |
/// | G (a -> F b)                                    | justice: no request is pending                 |
/// | G (a -> b W c), U, R, G inside                  | safety (and justice for the c of U)            |
/// | F (a & F b), F (a U b) at one point of time     | justice over O, S                              |
/// | disjunctions at one point of time               | H of safeties, disjunctions of justices        |
/// | G (a & F r -> (b U r)) and the other patterns   | safety at r, looking back                      |
///   of absence, existence, universality, response and precedence \cite dwyer.99.icse
///
/// \throws util::InputError  code "not-gr1" with the position and text of the subformula that has no
/// deterministic monitor
///                           (`F G p`, `GF a -> GF b`, a future operator below a past one, ...). Never drops
///                           anything.
/// \cite manna.90.podc
[[nodiscard]] Lowered lower(const Formula& requirement, const LowerOptions& options = {});

}  // namespace heed::logic
