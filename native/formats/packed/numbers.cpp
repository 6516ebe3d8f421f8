#include "formats/packed/numbers.h"

#include <algorithm>

namespace gradmesh {
namespace {

constexpr unsigned more = 0x80;

void append(std::string& bytes, std::uint64_t bits) {
  for (; bits >= more; bits >>= 7) bytes += char(bits | more);
  bytes += char(bits);
}

std::uint64_t take(std::string_view& bytes) {
  std::uint64_t bits = 0;
  for (unsigned shift = 0; !bytes.empty(); shift += 7) {
    const auto byte = std::uint8_t(bytes.front());
    bytes.remove_prefix(1);
    if (shift < 64) bits |= std::uint64_t(byte & ~more) << shift;
    if (byte < more) break;
  }
  return bits;
}

}  // namespace

Numbers Numbers::take_from(std::string_view& bytes) {
  Numbers numbers;
  numbers.is_read_ = true;
  const std::uint64_t length = take(bytes);
  numbers.has_sufficed_ = length <= bytes.size();
  numbers.rest_ = bytes.substr(0, length);
  bytes.remove_prefix(numbers.rest_.size());
  return numbers;
}

void Numbers::append_to(std::string& bytes) const {
  append(bytes, written_.size());
  bytes += written_;
}

std::int64_t Numbers::code(std::int64_t number) {
  if (!is_read_) {
    append(written_, std::uint64_t(number) << 1 ^ (number < 0 ? ~std::uint64_t(0) : 0));
    return number;
  }
  has_sufficed_ = has_sufficed_ && !rest_.empty();
  const std::uint64_t bits = take(rest_);
  return std::int64_t(bits >> 1 ^ (bits & 1 ? ~std::uint64_t(0) : 0));
}

}  // namespace gradmesh
