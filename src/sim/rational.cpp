#include <heed/sim/rational.h>
#include <heed/util/diagnostic.h>

#include <algorithm>
#include <charconv>
#include <string_view>

namespace heed::sim {
namespace {

constexpr std::size_t most_digits = 1'000;

/// A cursor over the text; `position` is where an error is shown.
struct Reader {
  const util::SourceText& source;
  std::string_view text;
  std::size_t position = 0;

  [[noreturn]] void fail(const std::string& message) const {
    throw util::InputError(source, position, "bad-number", message,
                           "write a probability as 1, 0.5, 1e-9 or 1/2");
  }
  [[nodiscard]] bool at_digit() const {
    return position < text.size() && text[position] >= '0' && text[position] <= '9';
  }
  [[nodiscard]] bool take(char wanted) {
    if (position >= text.size() || text[position] != wanted) return false;
    ++position;
    return true;
  }
  std::string digits() {
    const std::size_t begin = position;
    while (at_digit()) ++position;
    if (position - begin > most_digits) {
      position = begin;
      fail("a number of more than 1,000 digits");
    }
    return std::string(text.substr(begin, position - begin));
  }
  void spaces() {
    while (position < text.size() && (text[position] == ' ' || text[position] == '\t')) ++position;
  }
};

mpz_class power_of_ten(unsigned exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), 10, exponent);
  return result;
}

int read_exponent(Reader& reader) {
  const bool negative = reader.take('-');
  if (!negative) (void)reader.take('+');
  const std::string digits = reader.digits();
  if (digits.empty() || digits.size() > 3) reader.fail("an exponent has one to three digits");
  int value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return negative ? -value : value;
}

/// After the whole part: "[.digits][e[+-]digits]".
Rational read_decimal(Reader& reader, const std::string& whole) {
  std::string fractional;
  if (reader.take('.')) fractional = reader.digits();
  if (whole.empty() && fractional.empty()) reader.fail("expected a number");
  int exponent = -static_cast<int>(fractional.size());
  if (reader.take('e') || reader.take('E')) exponent += read_exponent(reader);
  Rational value(mpz_class("0" + whole + fractional, 10));
  const mpz_class scale = power_of_ten(static_cast<unsigned>(std::abs(exponent)));
  value = exponent < 0 ? Rational(value / scale) : Rational(value * scale);
  return value;
}

Rational read_quotient(Reader& reader, const std::string& numerator) {
  reader.spaces();
  const std::size_t begin = reader.position;
  const std::string denominator = reader.digits();
  if (denominator.empty()) reader.fail("expected digits after '/'");
  Rational value(mpz_class(numerator, 10), mpz_class(denominator, 10));
  if (value.get_den() == 0) {
    reader.position = begin;
    reader.fail("division by zero");
  }
  value.canonicalize();
  return value;
}

}  // namespace

Rational parse_rational(const util::SourceText& source) {
  Reader reader{source, source.text()};
  reader.spaces();
  const std::string whole = reader.digits();
  Rational value;
  const std::size_t after = reader.position;
  reader.spaces();
  if (!whole.empty() && reader.take('/')) {
    value = read_quotient(reader, whole);
  } else {
    reader.position = after;
    value = read_decimal(reader, whole);
  }
  reader.spaces();
  if (reader.position != reader.text.size()) reader.fail("unexpected text after the number");
  return value;
}

std::string fraction(const Rational& value) {
  return value.get_str();
}

std::string decimal(const Rational& value, unsigned digits) {
  const mpz_class scaled = abs(value.get_num()) * power_of_ten(digits);
  mpz_class quotient, remainder;
  mpz_fdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), scaled.get_mpz_t(), value.get_den_mpz_t());
  const int half = cmp(mpz_class(2 * remainder), value.get_den());
  if (half > 0 || (half == 0 && mpz_odd_p(quotient.get_mpz_t()))) ++quotient;
  std::string text = quotient.get_str();
  if (text.size() <= digits) text.insert(0, digits + 1 - text.size(), '0');
  if (digits > 0) text.insert(text.size() - digits, 1, '.');
  return (sgn(value) < 0 && quotient != 0 ? "-" : "") + text;
}

double to_double(const Rational& value) {
  return value.get_d();
}

}  // namespace heed::sim
