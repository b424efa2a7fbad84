#pragma once

#include "atoms.h"
#include "evidence.h"
#include "horn.h"
#include "possible.h"

#include <heed/awareness/policy.h>

#include <map>
#include <optional>
#include <vector>

namespace heed::awareness {

/// Compiles one policy: what each target entity needs on its own (target_rules.cpp, tree.cpp), then groups
/// through their members and behaviours through what prescribes them (policy.cpp).
class PolicyCompiler {
 public:
  PolicyCompiler(const Catalogue& catalogue, const Perception& perception, const PolicyOptions& options)
      : catalogue_(catalogue), perception_(perception), options_(options) {}
  [[nodiscard]] Recognition compile();

 private:
  // target_rules.cpp
  [[nodiscard]] std::vector<std::size_t> targets();
  [[nodiscard]] std::vector<std::size_t> default_targets();
  [[nodiscard]] bool fully_perceivable(std::size_t entity) const;
  [[nodiscard]] std::optional<std::size_t> impostor(std::size_t entity) const;
  [[nodiscard]] Rule rule_for(std::size_t entity);
  [[nodiscard]] Rule whole_rule(std::size_t entity) const;
  [[nodiscard]] Rule definition_rule(std::size_t entity);
  [[nodiscard]] Rule defined_rule(std::size_t entity, Rule rule);
  [[nodiscard]] Rule at_least_rule(std::size_t entity);
  [[nodiscard]] Reason reason(const Entailed& has) const;
  void note_words();

  // selection.cpp
  struct Item {
    bool is_role = false;
    std::size_t feature = 0;
    std::string role{};  ///< role_atom
    std::string text{};
  };
  [[nodiscard]] std::vector<Item> resolve_items(const std::vector<Name>& names) const;
  [[nodiscard]] std::vector<Entailed> select(std::size_t entity, const Item& item) const;
  void check_options() const;

  // tree.cpp
  [[nodiscard]] Rule tree_rule(std::size_t entity);
  [[nodiscard]] std::optional<std::vector<Reason>> levels(std::size_t entity);
  [[nodiscard]] std::string memory_name(const std::vector<Reason>& levels, std::size_t count);
  void remember(const std::vector<Reason>& levels, std::size_t count, const logic::Formula& reached);

  // policy.cpp
  void add_entities(const std::map<std::size_t, Rule>& own);
  void add_entity(std::size_t entity, const std::map<std::size_t, Rule>& own);
  void add_behaviours();

  // acting.cpp
  [[nodiscard]] bool asks_for_candidates() const;
  [[nodiscard]] Rule identifying_rule(std::size_t entity);
  void act();
  [[nodiscard]] logic::Formula acting_formula(std::size_t behaviour, const logic::Formula& cautious) const;
  void note_acting_words();
  void note_wide_symbols();
  void note(std::string code, std::string message, std::string hint = {});

  const Catalogue& catalogue_;
  const Perception& perception_;
  const PolicyOptions& options_;
  std::vector<Item> over_, order_;
  std::map<std::vector<std::string>, std::string> memory_names_;  ///< Of the tree, by path.
  AtomTable memory_atoms_;
  std::optional<Possibilities> possible_;
  std::optional<HornBase> horn_{};         ///< Where a policy asks why a description suffices.
  std::size_t evidence_work_ = 2'000'000;  ///< Steps that may be spent on listing evidence.
  Recognition result_;
};

}  // namespace heed::awareness
