#include "formats/packed/range_coder.h"

#include <algorithm>
#include <bit>

namespace gradmesh {
namespace {

constexpr std::uint32_t all_shares = 1 << 16, half = all_shares / 2;

}  // namespace

void Chance::learn(bool bit) {
  // About the mean of all bits and one of either kind; of the last ones once there are many.
  constexpr std::uint32_t many = 30, least = all_shares >> 11;
  seen_ = std::min(seen_ + 1, many);
  const std::uint32_t weight = 2 * seen_ + 3;
  share_ = bit ? share_ + 2 * (all_shares - share_) / weight : share_ - 2 * share_ / weight;
  share_ = std::clamp(share_, least, all_shares - least);
}

RangeCoder::RangeCoder(std::string_view bytes) : rest_(bytes), is_read_(true) {
  for (int i = 0; i < 4; ++i) take_byte();
}

bool RangeCoder::code(bool bit, Chance& chance) {
  const bool coded = narrow(bit, chance.of_one());
  chance.learn(coded);
  return coded;
}

bool RangeCoder::code(bool bit) { return narrow(bit, half); }

std::string RangeCoder::finish() {
  for (int i = 0; i < 5; ++i) put_byte();
  return written_.substr(1);  // The byte before the first, which no carry reaches.
}

/// Narrows the range to the part of the bit, and goes on by a byte where it is small.
bool RangeCoder::narrow(bool bit, std::uint32_t share_of_one) {
  constexpr std::uint32_t small = 1 << 24;
  const auto ones = std::uint32_t(std::uint64_t(range_) * share_of_one / all_shares);
  if (is_read_) bit = place_ < ones;
  if (bit) {
    range_ = ones;
  } else {
    low_ += ones;
    place_ -= ones;
    range_ -= ones;
  }
  for (; range_ < small; range_ <<= 8) is_read_ ? take_byte() : put_byte();
  return bit;
}

void RangeCoder::put_byte() {
  const bool carries = low_ >> 32 != 0;
  const auto next = std::uint8_t(low_ >> 24);
  if (next == UINT8_MAX && !carries) {
    ++full_bytes_;
  } else {
    written_ += char(std::uint8_t(byte_ + carries));
    written_.append(full_bytes_, char(std::uint8_t(UINT8_MAX + carries)));
    full_bytes_ = 0;
    byte_ = next;
  }
  low_ = (low_ & 0xffffff) << 8;
}

void RangeCoder::take_byte() {
  has_sufficed_ = has_sufficed_ && !rest_.empty();
  place_ = place_ << 8 | (rest_.empty() ? 0u : std::uint8_t(rest_.front()));
  if (!rest_.empty()) rest_.remove_prefix(1);
}

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
