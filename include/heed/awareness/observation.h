#pragma once

#include <heed/awareness/catalogue.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace heed::awareness {

/// What is seen of one thing at one moment; the rest is unknown.
struct Observation {
  std::vector<std::size_t> seen{};      ///< Features that it has.
  std::vector<std::size_t> whole{};     ///< Entities as which it is read whole.
  std::vector<std::size_t> excluded{};  ///< Features that it does not have.
};

struct JudgeOptions {
  bool closed = false;                  ///< The catalogue is complete: candidates are its leaves.
  std::vector<std::size_t> fallback{};  ///< Behaviours when nothing fits.
};

/// What follows from an observation; entities and behaviours ascending.
struct Judgement {
  std::vector<std::size_t> recognised;  ///< Entailed by what is seen.
  /// Leaves that are consistent with it and have nothing that is excluded; open, also groups without a
  /// possible member. All of them when nothing is seen.
  std::vector<std::size_t> candidates;
  std::vector<std::size_t> identified;  ///< All candidates are this or below it; empty when nothing is seen.
  bool something_seen = false;          ///< Else there need not be a thing, and nothing is prescribed.
  bool conflict = false;                ///< What is seen contradicts itself or what is excluded.
  bool unknown = false;                 ///< Something is seen, without conflict, and there is no candidate.
  std::vector<std::size_t>
      cautious;  ///< What recognised entities prescribe, and the fallback when nothing fits.
  std::vector<std::size_t> common;  ///< What follows for every candidate; without any as cautious.
  std::vector<std::size_t> brave;   ///< What follows for some candidate; without any as cautious.
};

/// Judges observations one by one by forward chaining over the catalogue's implications; the reference for
/// what compile_policy() compiles. Immutable. \cite dowling.84.jlp
class Judge {
 public:
  /// \param catalogue  outlives this object
  explicit Judge(const Catalogue& catalogue, JudgeOptions options = {});
  ~Judge();
  Judge(Judge&&) noexcept;
  Judge& operator=(Judge&&) noexcept;

  /// O(candidates * size of the catalogue) in the worst case.
  [[nodiscard]] Judgement operator()(const Observation& observation) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace heed::awareness
