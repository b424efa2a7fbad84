#pragma once

#include "output.h"

#include <heed/job/knowledge.h>

#include <cstddef>
#include <string>

namespace heed::cli {

/// The incompleteness report: axioms that the reasoner did not use in full, why, which classes and
/// individuals they speak of, and which entities of the catalogue that touches: those and everything below
/// them. More may follow for these, never less.
class LeftOut {
 public:
  explicit LeftOut(const job::Knowledge& knowledge) : knowledge_(knowledge) {}
  [[nodiscard]] std::string text() const;
  [[nodiscard]] Json json() const;
  [[nodiscard]] Json json(std::size_t entity) const;  ///< Ids of the axioms that touch it.

 private:
  [[nodiscard]] std::vector<std::string> touched(const dl::Dropped& dropped) const;
  [[nodiscard]] std::vector<owl::AxiomId> touching(std::size_t entity) const;

  const job::Knowledge& knowledge_;
};

}  // namespace heed::cli
