#include "enumeration.h"

#include <algorithm>
#include <bit>

namespace case_study {
namespace {

constexpr unsigned never = cells;

/// One trace from the cell in which each part comes into view.
Trace from_onsets(const mpq_class& probability, const std::vector<std::pair<unsigned, unsigned>>& onsets) {
  Trace trace{probability, {}};
  for (const auto& [bit, onset] : onsets)
    for (unsigned d = onset; d < cells; ++d) trace.seen[d] |= bit;
  return trace;
}

/// One more cell of P1 for the sign's onset \p sign: each part that may come does so with probability 1/2.
void grow(const std::vector<unsigned>& parts, unsigned has, unsigned sign, unsigned d, const Trace& so_far,
          Traces& out) {
  if (d == cells) return out.push_back(so_far);
  const unsigned before = d == 0 ? 0 : so_far.seen[d - 1];
  const unsigned certain = before | (d >= sign ? unsigned{Sign} : 0U);
  if (d + 1 == cells) {
    Trace last = so_far;
    last.seen[d] = certain | has;
    return out.push_back(last);
  }
  unsigned any_part = 0;
  std::vector<unsigned> may_come;
  for (const unsigned part : parts) {
    any_part |= part;
    if ((has & part) != 0 && (before & part) == 0 && d > sign) may_come.push_back(part);
  }
  // The part of which the whole is read belongs to colour and shape only.
  const bool part_seen = (before & any_part & (Colour | Shape)) != 0;
  if ((has & Whole) != 0 && (before & Whole) == 0 && d >= 2 && part_seen) may_come.push_back(Whole);
  for (unsigned choice = 0; choice < 1U << may_come.size(); ++choice) {
    Trace next = so_far;
    next.seen[d] = certain;
    for (std::size_t i = 0; i < may_come.size(); ++i) {
      next.probability /= 2;
      if ((choice >> i & 1U) != 0) next.seen[d] |= may_come[i];
    }
    grow(parts, has, sign, d + 1, next, out);
  }
}

/// The \p last parts are each uniform in {colour ... 5}.
void add_last(const std::vector<unsigned>& last, std::size_t i, unsigned from, const mpq_class& p,
              std::vector<std::pair<unsigned, unsigned>> onsets, Traces& out) {
  if (i == last.size()) return out.push_back(from_onsets(p, onsets));
  for (unsigned onset = from; onset <= never; ++onset) {
    auto more = onsets;
    more.emplace_back(last[i], onset);
    add_last(last, i + 1, from, p / mpq_class(never - from + 1), more, out);
  }
}

}  // namespace

Traces linear_growth(const std::vector<unsigned>& parts, unsigned has) {
  Traces traces;
  for (unsigned sign = 0; sign < cells; ++sign)
    grow(parts, has, sign, 0, Trace{sign == 0 ? mpq_class(1, 2) : mpq_class(1, 8), {}}, traces);
  return traces;
}

Traces closely_consecutive(const std::vector<unsigned>& parts) {
  Traces traces;
  std::vector<unsigned> order = parts;
  std::sort(order.begin(), order.end());
  unsigned permutations = 0;
  do {
    ++permutations;
    for (unsigned sign = 0; sign <= 2; ++sign) {
      std::vector<std::pair<unsigned, unsigned>> onsets{{Sign, sign}};
      unsigned d = sign;
      for (const unsigned part : order) onsets.emplace_back(part, ++d);
      onsets.emplace_back(Whole, d + 1);
      traces.push_back(from_onsets(mpq_class(1, 3), onsets));
    }
  } while (std::next_permutation(order.begin(), order.end()));
  for (Trace& trace : traces) trace.probability /= permutations;
  return traces;
}

Traces loosely_consecutive(const std::vector<unsigned>& last) {
  Traces traces;
  for (unsigned sign = 0; sign <= 3; ++sign)
    for (unsigned shape = sign; shape <= never; ++shape)
      for (unsigned colour = shape; colour <= never; ++colour) {
        const mpq_class p = mpq_class(1, 4) / mpq_class(never - sign + 1) / mpq_class(never - shape + 1);
        add_last(last, 0, colour, p, {{Sign, sign}, {Shape, shape}, {Colour, colour}}, traces);
      }
  return traces;
}

Traces traces_of(const std::string& profile) {
  if (profile == "P1") return linear_growth({Colour, Shape}, Sign | Colour | Shape | Whole);
  if (profile == "P2") return closely_consecutive({Colour, Shape});
  return loosely_consecutive({Whole});
}

std::array<mpq_class, 6> detection(const Traces& traces, unsigned reported, const Detects& detects) {
  std::array<mpq_class, 6> out;
  for (const Trace& trace : traces) {
    unsigned before = 0;
    std::size_t where = 5;
    for (std::size_t d = 0; d < cells && where == 5; ++d) {
      const unsigned now = trace.seen[d] & reported;
      if (detects(now, before)) where = cells - 1 - d;
      before = now;
    }
    out[where] += trace.probability;
  }
  return out;
}

std::vector<std::string> row(const Traces& traces, unsigned reported, const Detects& detects) {
  const auto found = detection(traces, reported, detects);
  std::vector<std::string> out{mpq_class(found[0] + found[5]).get_str()};
  for (std::size_t n = 1; n <= 4; ++n) out.push_back(found[n].get_str());
  return out;
}

bool base_detects(unsigned now, unsigned) {
  return (now & Whole) != 0;
}

bool tree_detects(unsigned now, unsigned before) {
  return (before & Sign) != 0 && (now & Colour) != 0;
}

bool tree_or_full_detects(unsigned now, unsigned before) {
  return tree_detects(now, before) || base_detects(now, before);
}

Detects two_of(unsigned counted) {
  return [counted](unsigned now, unsigned) { return std::popcount(now & counted) >= 2; };
}

}  // namespace case_study
