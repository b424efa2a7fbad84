#include <heed/sim/rare.h>
#include <heed/util/random.h>

#include "letters.h"
#include "sample_tables.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <functional>
#include <numeric>

namespace heed::sim {
namespace {

/// Keeps these draws apart from those of sample(), whose streams are trace numbers.
constexpr std::uint32_t tag = 0x72617265;

struct Particle {
  std::uint32_t chain = 0;    ///< Row of the draw table.
  std::uint32_t machine = 0;  ///< Row of the step table.
  std::uint32_t event = 0;    ///< First category + 1, 0 for none; StepTable::missing.
};

class Splitting {
 public:
  Splitting(const Run& run, const RareOptions& options, util::Budget& budget)
      : run_(run),
        options_(options),
        budget_(budget),
        letters_(run),
        draws_(run.chain, letters_.of_step, budget),
        steps_(run, letters_.machine, budget) {}

  RareEstimate estimate() {
    RareEstimate result;
    std::vector<double> products, reached(run_.chain.cells);
    result.survival.resize(run_.chain.cells);
    for (const std::vector<double>& shares : replicates()) {
      for (std::size_t cell = 0; cell < shares.size(); ++cell) {
        result.survival[cell] += shares[cell];
        ++reached[cell];
      }
      products.push_back(std::accumulate(shares.begin(), shares.end(), 1.0, std::multiplies<>()));
      result.extinct += products.back() == 0;
    }
    for (std::size_t cell = 0; cell < reached.size(); ++cell)
      if (reached[cell] > 0) result.survival[cell] /= reached[cell];
    summarise(products, result);
    return result;
  }

 private:
  /// The shares of each repetition, whoever of the team does it.
  std::vector<std::vector<double>> replicates() {
    const unsigned size = options_.team == nullptr ? 1 : options_.team->size();
    const unsigned rank = options_.team == nullptr ? 0 : options_.team->rank();
    std::vector<std::vector<double>> found(options_.replicates);
    for (std::uint32_t r = rank; r < options_.replicates; r += size) found[r] = replicate(r);
    if (options_.team != nullptr) gather(found);
    return found;
  }

  /// What each member has found, to all: as bits, so that none is lost in adding zeros.
  void gather(std::vector<std::vector<double>>& found) const {
    const std::size_t row = std::size_t{1} + run_.chain.cells;
    std::vector<std::uint64_t> bits(found.size() * row);
    for (std::size_t r = 0; r < found.size(); ++r) {
      bits[r * row] = found[r].size();
      for (std::size_t cell = 0; cell < found[r].size(); ++cell)
        bits[r * row + 1 + cell] = std::bit_cast<std::uint64_t>(found[r][cell]);
    }
    options_.team->sum(bits);
    for (std::size_t r = 0; r < found.size(); ++r) {
      found[r].resize(bits[r * row]);
      for (std::size_t cell = 0; cell < found[r].size(); ++cell)
        found[r][cell] = std::bit_cast<double>(bits[r * row + 1 + cell]);
    }
  }

  /// The share that survives each cell; ends with the cell that nobody survives.
  std::vector<double> replicate(std::uint32_t number) {
    Particle start;
    take(start, 0);
    std::vector<double> shares;
    std::vector<Particle> particles(options_.particles, start), survivors;
    for (std::uint32_t cell = 0; cell < run_.chain.cells; ++cell) {
      budget_.check();
      survivors.clear();
      const bool last = cell + 1 == run_.chain.cells;
      for (std::uint32_t i = 0; i < options_.particles; ++i) {
        move(particles[i], {cell, number, i, tag});
        if (survives(particles[i], last)) survivors.push_back(particles[i]);
      }
      shares.push_back(static_cast<double>(survivors.size()) / options_.particles);
      if (survivors.empty()) break;
      if (!last) multiply(survivors, number, cell, particles);
    }
    return shares;
  }

  void move(Particle& particle, const std::array<std::uint32_t, 4>& counter) const {
    const auto words = util::philox(counter, key());
    const auto choice = draws_.careful(particle.chain, words[0], [&] { return words[1]; });
    particle.chain = choice.next;
    take(particle, choice.letter);
  }

  void take(Particle& particle, std::uint32_t letter) const {
    const StepTable::Row& row = steps_.rows[particle.machine + letter];
    particle.machine = row.next;
    if ((particle.event & StepTable::category) == 0) particle.event |= row.event & StepTable::category;
    particle.event |= row.event & StepTable::missing;
  }

  [[nodiscard]] bool survives(const Particle& particle, bool last) const {
    const std::uint32_t category = particle.event & StepTable::category;
    if (category != 0) return category == options_.category + 1;
    if ((particle.event & StepTable::missing) != 0) return false;
    return !last || run_.judge.never == options_.category;
  }

  /// As many as before, evenly spread over the survivors from a random beginning: each expects the same
  /// number of successors.
  void multiply(const std::vector<Particle>& survivors, std::uint32_t number, std::uint32_t cell,
                std::vector<Particle>& particles) const {
    if (survivors.size() == particles.size()) return;
    const std::uint64_t count = particles.size(), from = survivors.size();
    const std::uint64_t offset = util::philox({cell, number, UINT32_MAX, tag}, key())[0] % from;
    for (std::uint64_t i = 0; i < count; ++i) particles[i] = survivors[(i * from + offset) / count];
  }

  [[nodiscard]] std::array<std::uint32_t, 2> key() const {
    return {static_cast<std::uint32_t>(options_.seed), static_cast<std::uint32_t>(options_.seed >> 32)};
  }

  void summarise(const std::vector<double>& products, RareEstimate& result) const {
    const auto n = static_cast<double>(products.size());
    result.probability = std::accumulate(products.begin(), products.end(), 0.0) / n;
    double squares = 0;
    for (const double p : products) squares += (p - result.probability) * (p - result.probability);
    result.standard_error = std::sqrt(squares / (n - 1) / n);
    const double half =
        student_quantile(options_.confidence, options_.replicates - 1) * result.standard_error;
    result.interval = {std::max(0.0, result.probability - half), std::min(1.0, result.probability + half)};
  }

  const Run& run_;
  const RareOptions& options_;
  util::Budget& budget_;
  Letters letters_;
  DrawTable draws_;
  StepTable steps_;
};

}  // namespace

RareEstimate estimate_rare(const Run& run, const RareOptions& options, util::Budget& budget) {
  assert_fits(run);
  assert(options.category < run.judge.categories.size());
  assert(options.particles > 0 && options.replicates >= 2);
  return Splitting(run, options, budget).estimate();
}

}  // namespace heed::sim
