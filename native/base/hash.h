#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace gradmesh {

/// The 64-bit hash FNV-1a (draft-eastlake-fnv), which tells contents apart and is the same on every
/// machine. It is no protection against malice.
class Hash {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) add_byte(std::uint8_t(byte));
  }
  void add(std::uint64_t word) {
    for (int i = 0; i < 64; i += 8) add_byte(std::uint8_t(word >> i));
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x)); }
  void add(int x) { add(std::uint64_t(std::uint32_t(x))); }
  std::uint64_t value() const { return value_; }

 private:
  void add_byte(std::uint8_t byte) { value_ = (value_ ^ byte) * 0x100000001b3; }

  std::uint64_t value_ = 0xcbf29ce484222325;
};

}  // namespace gradmesh
