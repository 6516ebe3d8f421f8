#pragma once

#include <cstdint>
#include <string_view>

namespace gradmesh::fuzz {

/// Choices, front to back; all are 0 where the bytes have come to an end.
class Choices {
 public:
  explicit Choices(std::string_view bytes) : rest_(bytes) {}

  bool at_end() const { return rest_.empty(); }
  /// 0..255.
  unsigned byte() {
    if (at_end()) return 0;
    const auto byte = std::uint8_t(rest_.front());
    rest_.remove_prefix(1);
    return byte;
  }
  unsigned below(std::size_t count) { return (byte() << 8 | byte()) % unsigned(count); }
  /// Above 0 and below 1.
  double share() { return (byte() + 0.5) / 256; }

 private:
  std::string_view rest_;
};

}  // namespace gradmesh::fuzz
