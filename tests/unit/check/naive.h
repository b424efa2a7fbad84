#pragma once

#include <heed/logic/formula.h>
#include <heed/spec/gr1.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>

namespace naive {

/// The values of all names in one step: the plainest thing that could be evaluated over.
using Step = std::map<std::string, std::int64_t>;

/// A recursive evaluator over maps, written for the tests alone.
class Evaluator {
 public:
  explicit Evaluator(const heed::spec::Gr1& spec) {
    for (const auto& v : spec.inputs) domains_[v.name] = v.domain;
    for (const auto& v : spec.outputs) domains_[v.variable.name] = v.variable.domain;
    for (const auto& v : spec.memories) domains_[v.variable.name] = v.variable.domain;
    for (const auto& v : spec.definitions) domains_[v.name] = heed::model::Domain::boolean();
  }
  void declare(const std::string& name, heed::model::Domain domain) { domains_[name] = std::move(domain); }

  [[nodiscard]] std::int64_t operator()(const heed::logic::Formula& f, const Step& now,
                                        const Step& next) const {
    using heed::logic::Op;
    switch (f.op()) {
      case Op::True:
        return 1;
      case Op::False:
        return 0;
      case Op::Name:
        return now.at(f.name());
      case Op::Number:
        return f.number();
      case Op::Not:
        return (*this)(f[0], now, next) == 0;
      case Op::And:
        return std::all_of(f.operands().begin(), f.operands().end(),
                           [&](auto& g) { return (*this)(g, now, next) != 0; });
      case Op::Or:
        return std::any_of(f.operands().begin(), f.operands().end(),
                           [&](auto& g) { return (*this)(g, now, next) != 0; });
      case Op::Implies:
        return (*this)(f[0], now, next) == 0 || (*this)(f[1], now, next) != 0;
      case Op::Iff:
        return ((*this)(f[0], now, next) != 0) == ((*this)(f[1], now, next) != 0);
      case Op::Next:
        return (*this)(f[0], next, next);
      default:
        return binary(f.op(), side(f, 0, now, next), side(f, 1, now, next));
    }
  }

 private:
  [[nodiscard]] const heed::model::Domain* domain(const heed::logic::Formula& term) const {
    if (term.op() == heed::logic::Op::Next) return domain(term[0]);
    if (term.op() != heed::logic::Op::Name) return nullptr;
    const auto found = domains_.find(term.name());
    return found == domains_.end() ? nullptr : &found->second;
  }
  [[nodiscard]] std::int64_t side(const heed::logic::Formula& f, std::size_t k, const Step& now,
                                  const Step& next) const {
    const auto* other = domain(f[1 - k]);
    const heed::logic::Formula& bare = f[k].op() == heed::logic::Op::Next ? f[k][0] : f[k];
    if (other && bare.op() == heed::logic::Op::Name) {
      const auto at = std::find(other->values.begin(), other->values.end(), bare.name());
      if (at != other->values.end()) return at - other->values.begin();
    }
    return (*this)(f[k], now, next);
  }
  static std::int64_t binary(heed::logic::Op op, std::int64_t a, std::int64_t b) {
    using heed::logic::Op;
    switch (op) {
      case Op::Eq:
        return a == b;
      case Op::Ne:
        return a != b;
      case Op::Lt:
        return a < b;
      case Op::Le:
        return a <= b;
      case Op::Gt:
        return a > b;
      case Op::Ge:
        return a >= b;
      case Op::Add:
        return a + b;
      case Op::Sub:
        return a - b;
      case Op::Mul:
        return a * b;
      default:
        std::abort();
    }
  }
  std::map<std::string, heed::model::Domain> domains_;
};

}  // namespace naive
