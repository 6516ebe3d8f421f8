#include "files/base64.h"

#include <cstdint>

namespace gradmesh {
namespace {

/// Returns each `bytes_in_group` bytes as one digit more; the last group, which may be shorter, has
/// one digit more than bytes, and then as many of `padding` as are missing.
template <std::size_t bytes_in_group, std::size_t base>
std::string in_digits(std::string_view bytes, std::string_view digits, std::string_view padding) {
  static_assert(bytes_in_group <= 4);
  std::string text;
  text.reserve((bytes.size() / bytes_in_group + 1) * (bytes_in_group + 1));
  for (std::size_t i = 0; i < bytes.size(); i += bytes_in_group) {
    const std::string_view group = bytes.substr(i, bytes_in_group);
    std::uint32_t number = 0;
    for (std::size_t k = 0; k < bytes_in_group; ++k)
      number = number << 8 | (k < group.size() ? std::uint8_t(group[k]) : 0u);
    char last_first[bytes_in_group + 1];
    for (char& digit : last_first) {
      digit = digits[number % base];
      number /= base;
    }
    for (std::size_t k = 0; k <= bytes_in_group; ++k)
      if (k <= group.size())
        text += last_first[bytes_in_group - k];
      else
        text += padding;
  }
  return text;
}

constexpr std::string_view digits_of_64 =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::string_view digits_of_85 =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#%()*+,-./:;=?@[]^_{|}";

}  // namespace

std::string base64(std::string_view bytes) { return in_digits<3, 64>(bytes, digits_of_64, "="); }

std::optional<std::string> base64_bytes(std::string_view text) {
  if (text.size() % 4 != 0) return std::nullopt;
  const std::size_t padding = text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t digit = i < text.size() - padding ? digits_of_64.find(text[i]) : 0;
    if (digit == digits_of_64.npos) return std::nullopt;
    bits = bits << 6 | std::uint32_t(digit);
    if (i % 4 != 3) continue;
    for (const int shift : {16, 8, 0}) bytes += char(std::uint8_t(bits >> shift));
  }
  bytes.resize(bytes.size() - padding);
  return bytes;
}

std::string base85(std::string_view bytes) { return in_digits<4, 85>(bytes, digits_of_85, ""); }

std::optional<std::string> base85_bytes(std::string_view text) {
  constexpr std::size_t bytes_in_group = 4, digits_in_group = 5;
  constexpr std::string_view digits = digits_of_85;
  std::string bytes;
  bytes.reserve((text.size() / digits_in_group + 1) * bytes_in_group);
  for (std::size_t i = 0; i < text.size(); i += digits_in_group) {
    const std::string_view group = text.substr(i, digits_in_group);
    if (group.size() == 1) return std::nullopt;
    std::uint64_t number = 0;
    for (std::size_t k = 0; k < digits_in_group; ++k) {
      // What is cut off at the end was the rest of a division: the largest digit makes up for it.
      const std::size_t digit = k < group.size() ? digits.find(group[k]) : digits.size() - 1;
      if (digit == digits.npos) return std::nullopt;
      number = number * digits.size() + digit;
    }
    if (number >> 32) {
      if (group.size() == digits_in_group) return std::nullopt;
      number = UINT32_MAX;
    }
    for (std::size_t k = 0; k + 1 < group.size(); ++k) bytes += char(number >> (24 - 8 * k));
  }
  // One text for the same bytes, so that no digit can be another.
  if (base85(bytes) != text) return std::nullopt;
  return bytes;
}

}  // namespace gradmesh
