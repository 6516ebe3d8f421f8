#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "formats/pdf/bits/bit_reader.h"

namespace gradmesh {

/// How a shading of type 4 to 7 packs its numbers (ISO 32000-1, 8.7.4.5.5 to 8.7.4.5.8).
struct Packing {
  /// What the smallest and the largest raw number stand for.
  using Range = std::array<double, 2>;

  int coordinate_bits = 0, component_bits = 0, flag_bits = 0;
  Range x{}, y{};
  /// One for each component of a colour: those of its colour space, or the parameter of a Function.
  std::vector<Range> components;
};

/// Throws InputError, whose message says what does not fit, unless the bits are among those that
/// the format allows, those of the flag only where the shading `has_flags`, and the ranges finite.
void check(const Packing& packing, bool has_flags);

/// A colour as a shading has it.
using Components = std::vector<double>;

/// Reads the parts of a shading's records one after the other.
class ShadingReader {
 public:
  ShadingReader(std::string_view bytes, const Packing& packing) : bits_(bytes), packing_(packing) {}

  /// Return the next flag, of which the low two bits count, the next point and the next colour;
  /// nothing at the end of the data.
  std::optional<int> flag();
  std::optional<glm::dvec2> point();
  std::optional<Components> color();
  /// Goes to the next record, which begins with a byte.
  void end_record() { bits_.align(); }
  /// Returns whether there is anything left.
  bool has_more() const { return bits_.left() > 0; }
  /// Returns whether there is more than the end of a line, which belongs to the data of some
  /// writers.
  bool has_much_more() const { return bits_.left() > 2 * 8; }

 private:
  std::optional<double> number(int bits, const Packing::Range& range);

  BitReader bits_;
  const Packing& packing_;
};

}  // namespace gradmesh
