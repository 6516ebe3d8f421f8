#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>

namespace gradmesh {

/// Writes numbers of some bits each, the highest bit first, as a PDF's shadings hold them.
class BitWriter {
 public:
  BitWriter& add(std::uint32_t value, int bits) {
    for (int bit = bits - 1; bit >= 0; --bit) {
      if (used_ == 0) bytes_ += '\0';
      if (value >> bit & 1) bytes_.back() = char(bytes_.back() | (0x80 >> used_));
      used_ = (used_ + 1) % 8;
    }
    return *this;
  }
  BitWriter& add(std::initializer_list<std::uint32_t> values, int bits) {
    for (const std::uint32_t value : values) add(value, bits);
    return *this;
  }
  /// Ends a record with a whole byte.
  BitWriter& end() {
    used_ = 0;
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  int used_ = 0;
};

}  // namespace gradmesh
