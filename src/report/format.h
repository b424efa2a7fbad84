#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace heed::report {

/// Per cent with at most one decimal: "0 %", "62.5 %", "50 %". What is not exactly 0 or 1 is never shown as
/// such: "<0.1 %", ">99.9 %".
[[nodiscard]] std::string percent(double share);

/// The same without the sign, for tables that say it once.
[[nodiscard]] std::string percent_bare(double share);

/// Shortest text that reads back as the same double, such as "0.296875"; "null" for what JSON cannot say.
[[nodiscard]] std::string shortest(double value);

/// Fixed decimals without trailing zeros: compact(2.50, 2) == "2.5".
[[nodiscard]] std::string compact(double value, int decimals);

/// Fixed decimals, halves upwards as people round: fixed(0.78875, 4) == "0.7888" though the double lies a
/// little below.
[[nodiscard]] std::string fixed(double value, int decimals);

/// "10,000".
[[nodiscard]] std::string grouped(std::uint64_t number);

/// "1.20 s", "12.3 ms", "850 µs".
[[nodiscard]] std::string seconds(double value);

/// "48.2 MB" (powers of ten).
[[nodiscard]] std::string bytes(std::uint64_t number);

/// "1 sign", "3 signs".
[[nodiscard]] std::string plural(std::uint64_t number, std::string_view singular, std::string_view many = {});

/// The same text with "12 %" kept on one line.
[[nodiscard]] std::string unbroken(std::string_view text);

[[nodiscard]] std::string join(const std::vector<std::string>& items, std::string_view separator);

/// Valid UTF-8 without control characters: what is neither becomes U+FFFD, tabs and line feeds stay.
[[nodiscard]] std::string clean(std::string_view text);

/// Columns that \p text takes in a terminal: combining marks none, wide East Asian ones two. \pre clean
[[nodiscard]] std::size_t columns(std::string_view text);

/// At most \p most columns, the last one an ellipsis where something was cut. \pre clean, most >= 1
[[nodiscard]] std::string shorten(std::string_view text, std::size_t most);

}  // namespace heed::report
