#include "play_parts.h"

#include <heed/sim/rational.h>
#include <heed/util/diagnostic.h>
#include <heed/util/random.h>

#include <fmt/format.h>

#include <map>

namespace heed::job {
namespace {

constexpr std::size_t draw_limit = 4096, sampled_ways = 64;

std::vector<std::size_t> features_in(std::uint64_t seen, std::size_t features) {
  std::vector<std::size_t> list;
  for (std::size_t f = 0; f < features; ++f)
    if (((seen >> f) & 1) != 0) list.push_back(f);
  return list;
}

report::PlayChain whole_chain(const sim::Chain& chain) {
  report::PlayChain states(chain.state_count());
  for (std::uint32_t s = 0; s < chain.state_count(); ++s)
    for (std::uint32_t i = chain.first[s]; i < chain.first[s + 1]; ++i) {
      const sim::Chain::Step& step = chain.steps[i];
      states[s].push_back(
          {sim::fraction(step.probability), step.next, features_in(step.seen, chain.features.size())});
    }
  return states;
}

const sim::Chain::Step& draw(const sim::Chain& chain, std::uint32_t state, util::CounterRandom& random) {
  double rest = random.uniform();
  for (std::uint32_t i = chain.first[state]; i + 1 < chain.first[state + 1]; ++i) {
    rest -= sim::to_double(chain.steps[i].probability);
    if (rest < 0) return chain.steps[i];
  }
  return chain.steps[chain.first[state + 1] - 1];
}

/// As many equally probable ways through \p chain, in the same form.
report::PlayChain sampled_chain(const sim::Chain& chain, std::uint64_t seed) {
  report::PlayChain states(1);
  for (std::size_t way = 0; way < sampled_ways; ++way) {
    util::CounterRandom random(seed, way);
    std::uint32_t at = 0;
    for (std::uint32_t cell = 0; cell < chain.cells; ++cell) {
      const sim::Chain::Step& step = draw(chain, at, random);
      const std::string probability = cell == 0 ? fmt::format("1/{}", sampled_ways) : "1";
      auto& from = cell == 0 ? states.front() : states.back();
      from.push_back({probability, 0, features_in(step.seen, chain.features.size())});
      from.back().next = states.size();
      states.emplace_back();
      at = step.next;
    }
  }
  return states;
}

std::size_t symbol_of(const report::Play& play, const sim::Binding::Wire& wire) {
  for (std::size_t s = 0; s < play.symbols.size(); ++s)
    if (play.symbols[s].input == wire.input && play.symbols[s].value == wire.value) return s;
  return 0;  // every value that a wire sets is a meaning of its input
}

/// Text that tells chains apart.
std::string key_of(const report::PlayChain& chain) {
  std::string key;
  for (const auto& draws : chain) {
    for (const report::PlayDraw& one : draws) {
      key += fmt::format("{}>{}", one.probability, one.next);
      for (const std::size_t seen : one.seen) key += fmt::format(",{}", seen);
      key += ' ';
    }
    key += '\n';
  }
  return key;
}

class ProfileWriter {
 public:
  ProfileWriter(const report::Play& play, const ProfilePart& part, const World& world,
                const model::Mealy& machine, util::Budget& budget)
      : play_(play), part_(part), world_(world), machine_(machine), budget_(budget) {}

  report::PlayProfile write() {
    out_.name = part_.spec.name;
    out_.title = part_.title;
    out_.cells = part_.spec.cells;
    out_.lines = part_.description;
    for (const std::size_t leaf : play_leaves(world_.knowledge.catalogue)) add(leaf);
    add(std::nullopt);
    return std::move(out_);
  }

 private:
  void add(Thing thing) {
    const auto [known, fresh] =
        by_appearance_.emplace(appearance(part_, world_, thing), out_.approaches.size());
    out_.of.push_back(known->second);
    if (!fresh) return;
    const Approach way = approach(part_, world_, machine_, thing, budget_);
    report::PlayApproach written;
    written.sampled = way.chain.steps.size() > draw_limit;
    report::PlayChain chain = written.sampled ? sampled_chain(way.chain, play_.seed) : whole_chain(way.chain);
    const auto [place, unseen] = by_chain_.emplace(key_of(chain), out_.chains.size());
    written.chain = place->second;
    if (unseen) out_.chains.push_back(std::move(chain));
    written.symbols.assign(way.chain.features.size(), 0);
    for (const sim::Binding::Wire& wire : way.binding.wires)
      written.symbols[wire.feature] = symbol_of(play_, wire);
    out_.approaches.push_back(std::move(written));
  }

  const report::Play& play_;
  const ProfilePart& part_;
  const World& world_;
  const model::Mealy& machine_;
  util::Budget& budget_;
  report::PlayProfile out_;
  std::map<std::string, std::size_t> by_appearance_, by_chain_;
};

}  // namespace

void fill_play_profiles(report::Play& play, const Scenario& scenario, const World& world,
                        const model::Mealy& machine, util::Budget& budget) {
  for (const ProfilePart& part : scenario.profiles)
    play.profiles.push_back(ProfileWriter(play, part, world, machine, budget).write());
}

}  // namespace heed::job
