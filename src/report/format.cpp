#include "format.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace heed::report {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

struct Decoded {
  char32_t point = 0;
  std::size_t length = 1;
  bool valid = false;
};

/// The code point at \p at; overlong forms, surrogates and cut sequences are invalid and one byte long.
Decoded decode(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(at);
  if (lead < 0x80) return {lead, 1, true};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || at + length > text.size()) return {};
  char32_t point = lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0) != 0x80) return {};
    point = (point << 6) | (byte(at + i) & 0x3F);
  }
  constexpr std::array<char32_t, 5> smallest{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = point >= 0xD800 && point <= 0xDFFF;
  if (point < smallest[length] || point > 0x10FFFF || surrogate) return {};
  return {point, length, true};
}

/// Characters that XML 1.0 refuses or that steer a terminal or the direction of text.
bool steers(char32_t point) {
  if (point == '\n' || point == '\t') return false;
  return point < 0x20 || (point >= 0x7F && point <= 0x9F) || (point >= 0x202A && point <= 0x202E) ||
         (point >= 0x2066 && point <= 0x2069) || point == 0xFFFE || point == 0xFFFF;
}

std::size_t width_of(char32_t point) {
  if ((point >= 0x300 && point <= 0x36F) || point == 0x200B || point == 0x200D) return 0;
  const bool wide = (point >= 0x1100 && point <= 0x115F) || (point >= 0x2E80 && point <= 0xA4CF) ||
                    (point >= 0xAC00 && point <= 0xD7A3) || (point >= 0xF900 && point <= 0xFAFF) ||
                    (point >= 0xFF00 && point <= 0xFF60) || (point >= 0x1F300 && point <= 0x1FAFF);
  return wide ? 2 : 1;
}

}  // namespace

std::string percent_bare(double share) {
  if (!std::isfinite(share)) return "?";
  if (share > 0 && share < 0.0005) return "<0.1";
  if (share < 1 && share > 0.9995 - 1e-9) return ">99.9";
  return compact(100 * share, 1);
}

std::string percent(double share) {
  return percent_bare(share) + " %";
}

std::string shortest(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

std::string fixed(double value, int decimals) {
  // Far above the distance of a double to the decimal that it stands for, far below the last digit shown.
  return fmt::format("{:.{}f}", value + std::copysign(1e-12, value), decimals);
}

std::string compact(double value, int decimals) {
  std::string text = fixed(value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string grouped(std::uint64_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string seconds(double value) {
  if (value >= 1) return fmt::format("{:.2f} s", value);
  if (value >= 1e-3) return fmt::format("{:.1f} ms", value * 1e3);
  return fmt::format("{:.0f} µs", value * 1e6);
}

std::string bytes(std::uint64_t number) {
  const auto value = static_cast<double>(number);
  if (number >= 1'000'000'000) return fmt::format("{:.1f} GB", value / 1e9);
  if (number >= 1'000'000) return fmt::format("{:.1f} MB", value / 1e6);
  if (number >= 1'000) return fmt::format("{:.1f} kB", value / 1e3);
  return fmt::format("{} B", number);
}

std::string plural(std::uint64_t number, std::string_view singular, std::string_view many) {
  if (number == 1) return fmt::format("1 {}", singular);
  if (!many.empty()) return fmt::format("{} {}", grouped(number), many);
  return fmt::format("{} {}s", grouped(number), singular);
}

std::string unbroken(std::string_view text) {
  constexpr std::string_view no_break = "\xC2\xA0";
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ' ' && i + 1 < text.size() && text[i + 1] == '%')
      result += no_break;
    else
      result += text[i];
  }
  return result;
}

std::string join(const std::vector<std::string>& items, std::string_view separator) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) text += separator;
    text += items[i];
  }
  return text;
}

std::string clean(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const Decoded next = decode(text, at);
    result += next.valid && !steers(next.point) ? text.substr(at, next.length) : replacement;
    at += next.length;
  }
  return result;
}

std::size_t columns(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const Decoded next = decode(text, at);
    width += width_of(next.point);
    at += next.length;
  }
  return width;
}

std::string shorten(std::string_view text, std::size_t most) {
  if (columns(text) <= most) return std::string(text);
  std::size_t width = 0, at = 0;
  while (at < text.size()) {
    const Decoded next = decode(text, at);
    if (width + width_of(next.point) + 1 > most) break;
    width += width_of(next.point);
    at += next.length;
  }
  return std::string(text.substr(0, at)) + "…";
}

}  // namespace heed::report
