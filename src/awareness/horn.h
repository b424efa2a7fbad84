#pragma once

#include <heed/awareness/catalogue.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace heed::awareness {

/// A catalogue as propositional Horn rules over one thing: it has a feature, is an entity, calls for a
/// behaviour, or lacks a feature. `nothing` stands for a contradiction, which proves nothing else.
class HornBase {
 public:
  using Prop = std::uint32_t;
  struct Rule {
    std::vector<Prop> body;  ///< Ascending, not empty.
    Prop head;
    const std::vector<owl::AxiomId>* axioms;  ///< Of the catalogue.
  };

  /// \param catalogue  outlives this object
  explicit HornBase(const Catalogue& catalogue);

  [[nodiscard]] Prop feature(std::size_t f) const { return static_cast<Prop>(f); }
  [[nodiscard]] Prop entity(std::size_t e) const { return static_cast<Prop>(features_ + e); }
  [[nodiscard]] Prop behaviour(std::size_t b) const { return static_cast<Prop>(features_ + entities_ + b); }
  [[nodiscard]] Prop excluded(std::size_t f) const {
    return static_cast<Prop>(features_ + entities_ + behaviours_ + f);
  }
  [[nodiscard]] Prop nothing() const { return static_cast<Prop>(2 * features_ + entities_ + behaviours_); }
  [[nodiscard]] std::size_t size() const { return nothing() + std::size_t{1}; }
  [[nodiscard]] const std::vector<Rule>& rules() const { return rules_; }
  /// Rules with \p prop among their conditions, by index; those that lead to a contradiction first.
  [[nodiscard]] const std::vector<std::uint32_t>& rules_with(Prop prop) const { return rules_with_[prop]; }

  /// One flag per proposition: what follows from \p facts. Linear in the rules. \cite dowling.84.jlp
  [[nodiscard]] std::vector<char> closure(const std::vector<Prop>& facts) const;
  /// Axioms of one derivation of \p goal from \p facts, of which none can be left out; nothing when there is
  /// none.
  [[nodiscard]] std::optional<std::vector<owl::AxiomId>> why(const std::vector<Prop>& facts, Prop goal) const;

 private:
  void add_rule(std::vector<Prop> body, Prop head, const std::vector<owl::AxiomId>& axioms);
  void add_entities(const Catalogue& catalogue);
  void add_features(const Catalogue& catalogue);
  void add_implications(const Catalogue& catalogue);
  /// Marks what follows; \p by gets, per derived proposition, the rule that derived it.
  void leave_out(std::vector<owl::AxiomId>& axioms, const std::vector<Prop>& facts, Prop goal) const;
  [[nodiscard]] std::vector<char> chain(const std::vector<Prop>& facts, std::vector<std::uint32_t>* by) const;

  std::size_t features_, entities_, behaviours_;
  std::vector<Rule> rules_;
  std::vector<std::vector<std::uint32_t>> rules_with_;
};

}  // namespace heed::awareness
