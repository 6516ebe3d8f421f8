#include "formats/pdf/bits/bit_reader.h"

#include <algorithm>

namespace gradmesh {

std::optional<std::uint32_t> BitReader::read(int bits) {
  if (left() < std::size_t(bits)) return {};
  std::uint64_t value = 0;
  for (int missing = bits; missing > 0;) {
    const auto byte = static_cast<unsigned char>(bytes_[at_ / 8]);
    const int unread = 8 - int(at_ % 8), taken = std::min(unread, missing);
    value = (value << taken) | ((unsigned(byte) >> (unread - taken)) & ((1U << taken) - 1));
    at_ += std::size_t(taken);
    missing -= taken;
  }
  return static_cast<std::uint32_t>(value);
}

}  // namespace gradmesh
