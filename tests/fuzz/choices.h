#pragma once

#include <cstddef>
#include <cstdint>

namespace gradmesh::fuzz {

/// Choices, front to back; all are 0 where the bytes have come to an end.
class Choices {
 public:
  Choices(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

  bool at_end() const { return next_ == end_; }
  /// 0..255.
  unsigned byte() { return at_end() ? 0u : *next_++; }
  unsigned below(std::size_t count) { return (byte() << 8 | byte()) % unsigned(count); }
  /// Above 0 and below 1.
  double share() { return (byte() + 0.5) / 256; }

 private:
  const std::uint8_t *next_, *end_;
};

}  // namespace gradmesh::fuzz
