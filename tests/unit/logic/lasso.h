#pragma once

// A naive evaluator of LTL with past on ultimately periodic words, and of GR(1) parts with their monitors. It
// shares nothing with the library but the formula type.

#include <heed/logic/lower.h>
#include <heed/util/random.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace heed::logic::test {

/// Letters are bit sets over a, b, c; after `letters` the word goes on at `loop` for ever.
struct Lasso {
  std::vector<unsigned> letters;
  std::size_t loop = 0;
};

inline bool letter_has(unsigned letter, const std::string& name) {
  return ((letter >> static_cast<unsigned>(name[0] - 'a')) & 1U) != 0;
}

/// The same word with its loop written out \p copies times, the last of them looping.
inline Lasso unroll(const Lasso& word, std::size_t copies) {
  Lasso out = word;
  const std::size_t period = word.letters.size() - word.loop;
  for (std::size_t i = 1; i < copies; ++i)
    for (std::size_t k = 0; k < period; ++k) out.letters.push_back(word.letters[word.loop + k]);
  out.loop = out.letters.size() - period;
  return out;
}

using Values = std::vector<bool>;

inline Values future_values(const Formula& f, const std::vector<Values>& v, const Lasso& word) {
  const std::size_t n = word.letters.size();
  const auto after = [&](std::size_t i) { return i + 1 < n ? i + 1 : word.loop; };
  if (f.op() == Op::Next) {
    Values out(n);
    for (std::size_t i = 0; i < n; ++i) out[i] = v[0][after(i)];
    return out;
  }
  const bool greatest = f.op() == Op::Always || f.op() == Op::WeakUntil || f.op() == Op::Release;
  Values out(n, greatest);
  for (std::size_t round = 0; round <= n; ++round) {
    for (std::size_t i = n; i-- > 0;) {
      const bool later = out[after(i)];
      if (f.op() == Op::Always) out[i] = v[0][i] && later;
      if (f.op() == Op::Eventually) out[i] = v[0][i] || later;
      if (f.op() == Op::Until || f.op() == Op::WeakUntil) out[i] = v[1][i] || (v[0][i] && later);
      if (f.op() == Op::Release) out[i] = v[1][i] && (v[0][i] || later);
    }
  }
  return out;
}

inline bool past_value(const Formula& f, const std::vector<Values>& v, const Values& out, std::size_t i) {
  const bool initial = f.op() == Op::Historically;
  const bool before = i > 0 ? out[i - 1] : initial;
  switch (f.op()) {
    case Op::Previous:
      return i > 0 && v[0][i - 1];
    case Op::Once:
      return v[0][i] || before;
    case Op::Historically:
      return v[0][i] && before;
    default:
      return v[1][i] || (v[0][i] && before);
  }
}

inline bool boolean_value(const Formula& f, const std::vector<Values>& v, std::size_t i) {
  bool all = true, any = false;
  for (const Values& operand : v) {
    all = all && operand[i];
    any = any || operand[i];
  }
  switch (f.op()) {
    case Op::True:
      return true;
    case Op::Not:
      return !v[0][i];
    case Op::And:
      return all;
    case Op::Or:
      return any;
    case Op::Implies:
      return !v[0][i] || v[1][i];
    case Op::Iff:
      return v[0][i] == v[1][i];
    default:
      return false;
  }
}

/// Truth at every position of the unrolled word.
inline Values values(const Formula& f, const Lasso& word) {
  std::vector<Values> operands;
  for (const Formula& operand : f.operands()) operands.push_back(values(operand, word));
  if (f.op() >= Op::Next && f.op() <= Op::Release) return future_values(f, operands, word);
  Values out(word.letters.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (f.op() == Op::Name)
      out[i] = letter_has(word.letters[i], f.name());
    else
      out[i] = f.op() >= Op::Previous ? past_value(f, operands, out, i) : boolean_value(f, operands, i);
  }
  return out;
}

/// Past operators settle within as many periods as they nest; `copies` is far above that for the formulas
/// here.
inline bool satisfies(const Formula& f, const Lasso& word, std::size_t copies = 10) {
  return values(f, unroll(word, copies))[0];
}

using Memory = std::map<std::string, bool>;

/// A propositional formula with primes, on a step.
inline bool on_step(const Formula& f, unsigned now, unsigned next, const Memory& memory) {
  const auto operand = [&](std::size_t i) { return on_step(f[i], now, next, memory); };
  switch (f.op()) {
    case Op::True:
      return true;
    case Op::Name: {
      const auto found = memory.find(f.name());
      return found != memory.end() ? found->second : letter_has(now, f.name());
    }
    case Op::Not:
      return !operand(0);
    case Op::Next:
      return on_step(f[0], next, next, {});
    case Op::Implies:
      return !operand(0) || operand(1);
    case Op::Iff:
      return operand(0) == operand(1);
    default:
      break;
  }
  bool all = true, any = false;
  for (std::size_t i = 0; i < f.operands().size(); ++i) {
    all = all && operand(i);
    any = any || operand(i);
  }
  return f.op() == Op::And ? all : any;
}

/// init, G safety and GF justice along the word, monitors run along until (position, monitors) repeats.
inline bool satisfies(const Lowered& lowered, const Lasso& word) {
  Memory memory;
  for (const Monitor& monitor : lowered.monitors) memory[monitor.name] = monitor.initial;
  for (const Formula& f : lowered.init)
    if (!on_step(f, word.letters[0], word.letters[0], memory)) return false;
  std::map<std::pair<std::size_t, Memory>, std::size_t> seen;
  std::vector<std::vector<bool>> justice;
  std::size_t position = 0;
  while (seen.emplace(std::pair{position, memory}, justice.size()).second) {
    const std::size_t after = position + 1 < word.letters.size() ? position + 1 : word.loop;
    const unsigned now = word.letters[position], next = word.letters[after];
    for (const Formula& f : lowered.safety)
      if (!on_step(f, now, next, memory)) return false;
    justice.emplace_back();
    for (const Formula& f : lowered.justice) justice.back().push_back(on_step(f, now, next, memory));
    Memory updated;
    for (const Monitor& monitor : lowered.monitors)
      updated[monitor.name] = on_step(monitor.update, now, next, memory);
    memory = std::move(updated);
    position = after;
  }
  const std::size_t cycle = seen.at({position, memory});
  for (std::size_t j = 0; j < lowered.justice.size(); ++j) {
    bool met = false;
    for (std::size_t i = cycle; i < justice.size(); ++i) met = met || justice[i][j];
    if (!met) return false;
  }
  return true;
}

/// All words with a prefix of 0 ... \p prefix and a loop of 1 ... \p period letters over \p propositions.
inline std::vector<Lasso> all_words(unsigned propositions, std::size_t prefix, std::size_t period) {
  const std::size_t letters = std::size_t{1} << propositions;
  std::vector<Lasso> words;
  for (std::size_t before = 0; before <= prefix; ++before)
    for (std::size_t loop = 1; loop <= period; ++loop) {
      std::size_t count = 1;
      for (std::size_t i = 0; i < before + loop; ++i) count *= letters;
      for (std::size_t code = 0; code < count; ++code) {
        Lasso word{{}, before};
        for (std::size_t rest = code, i = 0; i < before + loop; ++i, rest /= letters)
          word.letters.push_back(static_cast<unsigned>(rest % letters));
        words.push_back(std::move(word));
      }
    }
  return words;
}

inline Lasso random_word(util::CounterRandom& random, unsigned propositions) {
  Lasso word;
  word.loop = random.below(6);
  const std::size_t size = word.loop + 1 + random.below(5);
  for (std::size_t i = 0; i < size; ++i) word.letters.push_back(random.below(1U << propositions));
  return word;
}

/// A random formula; \p operators is drawn from at every inner node.
inline Formula random_formula(util::CounterRandom& random, int depth, unsigned propositions,
                              const std::vector<Op>& operators) {
  if (depth == 0 || random.below(6) == 0) {
    if (random.below(12) == 0) return truth(random.below(2) == 0);
    return name(std::string(1, static_cast<char>('a' + random.below(propositions))));
  }
  const Op op = operators[random.below(static_cast<std::uint32_t>(operators.size()))];
  const auto part = [&] { return random_formula(random, depth - 1, propositions, operators); };
  const bool binary =
      (op >= Op::And && op <= Op::Iff) || (op >= Op::Until && op <= Op::Release) || op == Op::Since;
  std::vector<Formula> operands{part()};
  if (binary) operands.push_back(part());
  if ((op == Op::And || op == Op::Or) && random.below(4) == 0) operands.push_back(part());
  return Formula::make(op, std::move(operands));
}

}  // namespace heed::logic::test
