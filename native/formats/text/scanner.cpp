#include "formats/text/scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace gradmesh {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '-';
}

/// Returns the user units in one `unit`; CSS fixes 96 of them to the inch.
std::optional<double> unit_size(std::string_view unit) {
  if (unit.empty() || unit == "px") return 1.0;
  if (unit == "in") return 96.0;
  if (unit == "cm") return 96.0 / 2.54;
  if (unit == "mm") return 96.0 / 25.4;
  if (unit == "pt") return 96.0 / 72.0;
  if (unit == "pc") return 16.0;
  return std::nullopt;
}

}  // namespace

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return result;
}

void Scanner::skip_blanks() {
  while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
}

bool Scanner::at_end() {
  skip_blanks();
  return rest_.empty();
}

char Scanner::peek() { return at_end() ? '\0' : rest_.front(); }

bool Scanner::accept(char c) {
  if (at_end() || rest_.front() != c) return false;
  rest_.remove_prefix(1);
  return true;
}

std::string_view Scanner::word() {
  skip_blanks();
  const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_word);
  const std::string_view taken = rest_.substr(0, std::size_t(end - rest_.begin()));
  rest_.remove_prefix(taken.size());
  return taken;
}

std::optional<double> Scanner::number() {
  skip_blanks();
  std::string_view digits = rest_;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  const std::size_t first = digits.size() == rest_.size() && digits.starts_with('-') ? 1 : 0;
  if (digits.size() <= first || !(is_digit(digits[first]) || digits[first] == '.'))
    return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    // Too small for a double is as good as 0; too large is refused below.
    const std::string_view text(digits.data(), std::size_t(end - digits.data()));
    const bool tiny = text.find("e-") != text.npos || text.find("E-") != text.npos;
    value = tiny ? 0.0 : HUGE_VAL;
  }
  if (std::abs(value) > max_coordinate) return std::nullopt;
  rest_.remove_prefix(std::size_t(end - rest_.data()));
  return value;
}

std::optional<bool> Scanner::flag() {
  if (accept('0')) return false;
  if (accept('1')) return true;
  return std::nullopt;
}

std::optional<double> parse_opacity(std::string_view text) {
  const auto value = Scanner(text).number();
  return value ? std::optional(std::clamp(*value, 0.0, 1.0)) : std::nullopt;
}

std::optional<double> parse_length(std::string_view text, std::optional<double> whole) {
  Scanner scanner(text);
  const auto value = scanner.number();
  if (!value) return std::nullopt;
  if (scanner.accept('%'))
    return whole && scanner.at_end() ? std::optional(*value / 100.0 * *whole) : std::nullopt;
  const auto size = unit_size(lower(trimmed(scanner.rest())));
  return size ? std::optional(*value * *size) : std::nullopt;
}

}  // namespace gradmesh
