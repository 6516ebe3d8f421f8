#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace gradmesh {

/// How likely a bit is set, as those tell that were coded with it.
class Chance {
 public:
  /// Returns the share, in 2^-16 and neither none nor all.
  std::uint32_t of_one() const { return share_; }
  void learn(bool bit);

 private:
  std::uint32_t share_ = 1 << 15, seen_ = 0;
};

/// Writes bits as a string of bytes, or reads them: a bit takes fewer the likelier it was. Both are
/// done by the same function, so that what writes also reads. (G. N. N. Martin, "Range encoding",
/// 1979; carries are kept back as LZMA does.)
class RangeCoder {
 public:
  /// Makes a coder that writes.
  RangeCoder() = default;
  /// Makes a coder that reads the bytes, which must outlive it.
  explicit RangeCoder(std::string_view bytes);

  bool is_read() const { return is_read_; }
  /// Writes the bit and returns it, or returns the next bit whatever `bit` is; any after the last.
  /// `chance` learns of it.
  bool code(bool bit, Chance& chance);
  /// Writes or reads a bit of which nothing is known.
  bool code(bool bit);

  /// Returns the bytes that were written. Nothing can be written after that.
  std::string finish();
  /// Returns true if all bytes were read, and no more than these.
  bool is_exhausted() const { return rest_.empty() && has_sufficed_; }

 private:
  bool narrow(bool bit, std::uint32_t share_of_one);
  void put_byte();
  void take_byte();

  std::uint32_t range_ = UINT32_MAX;
  /// What is written: the lower end of the range, the byte before it and how many bytes of 255
  /// after that one a carry would still change.
  std::uint64_t low_ = 0;
  std::uint8_t byte_ = 0;
  std::size_t full_bytes_ = 0;
  std::string written_;
  /// What is read: the place in the range, and the bytes to come.
  std::uint32_t place_ = 0;
  std::string_view rest_;
  bool is_read_ = false, has_sufficed_ = true;
};

/// How whole numbers of one kind are spread around zero, as those tell that were coded before: how
/// many bits they have, and what the highest of these are.
class Spread {
 public:
  /// Writes the number and returns it, or returns the next number whatever `number` is.
  std::int64_t code(RangeCoder& coder, std::int64_t number);

 private:
  static constexpr unsigned most_bits = 63, known_bits = 3;
  /// For each number of bits whether there are more, and the highest bits after the first.
  std::array<Chance, most_bits> more_{};
  std::array<std::array<Chance, 1 << known_bits>, most_bits + 1> highest_{};
};

}  // namespace gradmesh
