#include "long_run.h"

namespace heed::sim {
namespace {

using Reach = std::vector<std::vector<bool>>;

Reach reachable(const TransitionMatrix& matrix) {
  const std::size_t n = matrix.size();
  Reach reach(n, std::vector<bool>(n, false));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) reach[i][j] = i == j || matrix[i][j] != 0;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      if (reach[i][k])
        for (std::size_t j = 0; j < n; ++j) reach[i][j] = reach[i][j] || reach[k][j];
  return reach;
}

bool recurrent(const Reach& reach, std::size_t state) {
  for (std::size_t j = 0; j < reach.size(); ++j)
    if (reach[state][j] && !reach[j][state]) return false;
  return true;
}

/// The chain watched only outside \p state: who goes there goes on to where one leaves it for. \pre it is
/// left
void censor(TransitionMatrix& matrix, std::size_t state) {
  const Rational leave = 1 - matrix[state][state];
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    if (i == state || matrix[i][state] == 0) continue;
    const Rational share = matrix[i][state] / leave;
    for (std::size_t j = 0; j < matrix.size(); ++j)
      if (j != state && matrix[state][j] != 0) matrix[i][j] += share * matrix[state][j];
    matrix[i][state] = 0;
  }
}

/// The stationary distribution over \p members, which only lead to each other: state reduction, then back.
std::vector<Rational> stationary(TransitionMatrix matrix, const std::vector<std::size_t>& members,
                                 util::Budget& budget) {
  const std::size_t n = members.size();
  const auto at = [&](std::size_t i, std::size_t j) -> Rational& { return matrix[members[i]][members[j]]; };
  for (std::size_t k = n; k-- > 1;) {
    budget.check();
    Rational out = 0;
    for (std::size_t j = 0; j < k; ++j) out += at(k, j);
    for (std::size_t i = 0; i < k; ++i) at(i, k) /= out;
    for (std::size_t i = 0; i < k; ++i)
      for (std::size_t j = 0; j < k; ++j) at(i, j) += at(i, k) * at(k, j);
  }
  std::vector<Rational> weight(n, 0);
  weight[0] = 1;
  Rational sum = 1;
  for (std::size_t k = 1; k < n; ++k) {
    for (std::size_t i = 0; i < k; ++i) weight[k] += weight[i] * at(i, k);
    sum += weight[k];
  }
  for (Rational& w : weight) w /= sum;
  return weight;
}

}  // namespace

std::vector<Rational> long_run_shares(TransitionMatrix matrix, util::Budget& budget) {
  const std::size_t n = matrix.size();
  const Reach reach = reachable(matrix);
  const TransitionMatrix whole = matrix;
  for (std::size_t s = 1; s < n; ++s) {
    budget.check();
    if (reach[0][s] && !recurrent(reach, s)) censor(matrix, s);
  }
  // Where state 0 ends up: itself if it is recurrent, else by its censored row.
  std::vector<Rational> enters(n, 0), shares(n, 0);
  if (recurrent(reach, 0))
    enters[0] = 1;
  else
    for (std::size_t s = 1; s < n; ++s)
      if (recurrent(reach, s)) enters[s] = matrix[0][s] / (1 - matrix[0][0]);
  std::vector<bool> done(n, false);
  for (std::size_t s = 0; s < n; ++s) {
    if (done[s] || !reach[0][s] || !recurrent(reach, s)) continue;
    std::vector<std::size_t> members;
    Rational probability = 0;
    for (std::size_t t = 0; t < n; ++t) {
      if (!reach[s][t]) continue;
      members.push_back(t);
      probability += enters[t];
      done[t] = true;
    }
    const std::vector<Rational> weight = stationary(whole, members, budget);
    for (std::size_t i = 0; i < members.size(); ++i) shares[members[i]] = probability * weight[i];
  }
  return shares;
}

}  // namespace heed::sim
