#pragma once

#include <heed/sim/team.h>

#include <barrier>
#include <functional>
#include <thread>
#include <vector>

namespace heed::sim {

/// A team whose members are threads: what processes under mpirun do, without MPI.
class ThreadTeam {
 public:
  explicit ThreadTeam(unsigned size) : size_(size), meeting_(size), counts_(size) {}

  /// \param work  Called for each member.
  void run(const std::function<void(Team&)>& work) {
    std::vector<std::jthread> threads;
    for (unsigned rank = 0; rank < size_; ++rank)
      threads.emplace_back([this, rank, &work] {
        Member member(*this, rank);
        work(member);
      });
  }

 private:
  class Member final : public Team {
   public:
    Member(ThreadTeam& team, unsigned rank) : team_(team), rank_(rank) {}
    [[nodiscard]] unsigned rank() const override { return rank_; }
    [[nodiscard]] unsigned size() const override { return team_.size_; }
    void sum(std::span<std::uint64_t> counts) override {
      team_.counts_[rank_] = {counts.begin(), counts.end()};
      team_.meeting_.arrive_and_wait();
      for (std::size_t i = 0; i < counts.size(); ++i) {
        counts[i] = 0;
        for (const auto& one : team_.counts_) counts[i] += one.at(i);
      }
      team_.meeting_.arrive_and_wait();
    }

   private:
    ThreadTeam& team_;
    unsigned rank_;
  };

  unsigned size_;
  std::barrier<> meeting_;
  std::vector<std::vector<std::uint64_t>> counts_;
};

}  // namespace heed::sim
