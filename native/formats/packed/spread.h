#pragma once

#include <array>
#include <cstdint>

#include "formats/packed/range_coder.h"

namespace gradmesh {

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
