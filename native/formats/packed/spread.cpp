#include "formats/packed/spread.h"

#include <algorithm>
#include <bit>

namespace gradmesh {

std::int64_t Spread::code(RangeCoder& coder, std::int64_t number) {
  const std::int64_t known = std::clamp(number, -INT64_MAX, INT64_MAX);
  const auto size = std::uint64_t(known < 0 ? -known : known);
  const auto width = unsigned(std::bit_width(size));
  unsigned bits = 0;
  while (bits < most_bits && coder.code(bits < width, more_[bits])) ++bits;
  if (bits == 0) return 0;
  const bool is_negative = coder.code(number < 0);
  std::uint64_t coded = 1;
  for (unsigned i = 1; i < bits; ++i) {
    const bool bit = size >> (bits - 1 - i) & 1;
    coded =
        coded << 1 | (i <= known_bits ? coder.code(bit, highest_[bits][coded]) : coder.code(bit));
  }
  return is_negative ? -std::int64_t(coded) : std::int64_t(coded);
}

}  // namespace gradmesh
