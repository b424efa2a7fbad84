#pragma once

#include <heed/logic/formula.h>
#include <heed/model/mealy.h>

#include <memory>
#include <string>
#include <vector>

namespace heed::job {

/// Formulas without temporal operators over the names of a machine's inputs and columns, for single steps.
class LetterFormulas {
 public:
  /// \param machine  Its variables count, and they must outlive this. \param replaced  As for
  /// hold_at_transitions(). \throws util::InputError  as hold_at_transitions() does
  LetterFormulas(const std::vector<logic::Formula>& formulas, const model::Mealy& machine,
                 const std::vector<std::string>& replaced);
  ~LetterFormulas();
  LetterFormulas(const LetterFormulas&) = delete;
  LetterFormulas& operator=(const LetterFormulas&) = delete;

  [[nodiscard]] bool holds(std::size_t formula, const model::Valuation& input,
                           const model::Valuation& output);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace heed::job
