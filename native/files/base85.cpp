#include "files/base85.h"

#include <cstdint>

namespace gradmesh {
namespace {

constexpr std::string_view digits =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#%()*+,-./:;=?@[]^_{|}";
constexpr std::size_t bytes_in_group = 4, digits_in_group = 5;
static_assert(digits.size() == 85);

}  // namespace

std::string base85(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() / bytes_in_group + 1) * digits_in_group);
  for (std::size_t i = 0; i < bytes.size(); i += bytes_in_group) {
    const std::string_view group = bytes.substr(i, bytes_in_group);
    std::uint32_t number = 0;
    for (std::size_t k = 0; k < bytes_in_group; ++k)
      number = number << 8 | (k < group.size() ? std::uint8_t(group[k]) : 0u);
    char last_first[digits_in_group];
    for (char& digit : last_first) {
      digit = digits[number % digits.size()];
      number /= std::uint32_t(digits.size());
    }
    // The last group has one digit more than bytes.
    for (std::size_t k = 0; k <= group.size(); ++k) text += last_first[digits_in_group - 1 - k];
  }
  return text;
}

std::optional<std::string> base85_bytes(std::string_view text) {
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
