#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace gradmesh {

/// Reads numbers of some bits each, the highest bit first, from the data of a PDF's stream.
class BitReader {
 public:
  /// Begins at a bit, from 0 on.
  explicit BitReader(std::string_view bytes, std::size_t first = 0) : bytes_(bytes), at_(first) {}

  /// Returns the number in the next `bits` bits, 1 to 32; nothing if there are not as many, and
  /// then nothing is read.
  std::optional<std::uint32_t> read(int bits);
  /// Goes to the beginning of a byte.
  void align() { at_ = (at_ + 7) & ~std::size_t(7); }
  /// Returns how many bits are left.
  std::size_t left() const { return at_ < 8 * bytes_.size() ? 8 * bytes_.size() - at_ : 0; }

 private:
  std::string_view bytes_;
  /// In bits.
  std::size_t at_;
};

}  // namespace gradmesh
