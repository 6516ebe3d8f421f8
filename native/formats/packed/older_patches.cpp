#include "formats/packed/older_patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "base/limits.h"
#include "formats/packed/scale.h"

namespace gradmesh {
namespace {

/// A list of whole numbers, each in a byte for each seven bits, the sign being the lowest.
class Numbers {
 public:
  /// Takes a list from the front of `bytes`, which begins with its length.
  static Numbers take_from(std::string_view& bytes) {
    const std::uint64_t length = bits_from(bytes);
    Numbers numbers;
    numbers.has_sufficed_ = length <= bytes.size();
    numbers.rest_ = bytes.substr(0, length);
    bytes.remove_prefix(numbers.rest_.size());
    return numbers;
  }

  /// Returns the next number; 0 after the last.
  std::int64_t next() {
    has_sufficed_ = has_sufficed_ && !rest_.empty();
    const std::uint64_t bits = bits_from(rest_);
    return std::int64_t(bits >> 1 ^ (bits & 1 ? ~std::uint64_t(0) : 0));
  }
  /// Returns true if all numbers were taken, and no more than these.
  bool is_exhausted() const { return rest_.empty() && has_sufficed_; }

 private:
  static std::uint64_t bits_from(std::string_view& bytes) {
    constexpr unsigned more = 0x80;
    std::uint64_t bits = 0;
    for (unsigned shift = 0; !bytes.empty(); shift += 7) {
      const auto byte = std::uint8_t(bytes.front());
      bytes.remove_prefix(1);
      if (shift < 64) bits |= std::uint64_t(byte & ~more) << shift;
      if (byte < more) break;
    }
    return bits;
  }

  std::string_view rest_;
  bool has_sufficed_ = true;
};

class PatchReader {
 public:
  /// The lists: what belongs to all, rows and columns and whether sides are curves, x, y, channels.
  static constexpr int count = 7;
  explicit PatchReader(std::array<Numbers, count>& lists) : lists_(lists) {}

  void read_scale() {
    for (int axis = 0; axis < 2; ++axis)
      step_[axis] = std::ldexp(1.0, int(std::clamp<std::int64_t>(shape().next(), -1000, 1000)));
    for (std::int64_t& levels : levels_)
      levels = std::clamp<std::int64_t>(shape().next(), 1, 65535);
  }

  /// Returns nothing if the grid would have none or more than `most` patches.
  std::optional<PatchGrid> read(std::uint64_t most) {
    const std::int64_t rows = shape().next(), columns = shape().next();
    if (rows < 1 || columns < 1 || std::uint64_t(rows) > most ||
        std::uint64_t(columns) > most / std::uint64_t(rows))
      return std::nullopt;
    rows_ = int(rows);
    columns_ = int(columns);
    net_.assign(std::size_t(3 * rows_ + 1) * std::size_t(3 * columns_ + 1), {});
    corners_.assign(std::size_t(rows_ + 1) * std::size_t(columns_ + 1), glm::dvec4(0.0));
    read_corners();
    for (int i = 0; i <= rows_; ++i) read_line(3 * i, 0, 0, 1, columns_);
    for (int j = 0; j <= columns_; ++j) read_line(0, 3 * j, 1, 0, rows_);
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) read_interior(row, column);
    for (int channel = 0; channel < 4; ++channel) read_colors(channel);
    PatchGrid grid{rows_, columns_, {}};
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) grid.patches.push_back(patch(row, column));
    return grid;
  }

 private:
  Numbers& shape() { return lists_[0]; }
  glm::dvec2 next_steps() {
    const auto x = double(lists_[1].next()), y = double(lists_[2].next());
    return {x, y};
  }

  /// Returns a point of the net of the whole grid, in steps.
  glm::dvec2& net(int i, int j) {
    return net_[std::size_t(i) * std::size_t(3 * columns_ + 1) + std::size_t(j)];
  }
  glm::dvec4& corner(int row, int column) {
    return corners_[std::size_t(row) * std::size_t(columns_ + 1) + std::size_t(column)];
  }

  void read_corners() {
    for (int i = 0; i <= 3 * rows_; i += 3)
      for (int j = 0; j <= 3 * columns_; j += 3) {
        glm::dvec2 expected(0.0);
        if (i > 0 && j > 0)
          expected = net(i - 3, j) + net(i, j - 3) - net(i - 3, j - 3);
        else if (i > 0 || j > 0)
          expected = i > 0 ? net(i - 3, j) : net(i, j - 3);
        net(i, j) = expected + next_steps();
      }
  }

  /// Reads the handles of `sides` sides in one line of the net from (i, j) on. How a side bends
  /// away from its chord is expected to be as in the line before.
  void read_line(int i, int j, int down, int right, int sides) {
    const bool is_first = i == 0 && j == 0;
    if (is_first) bends_.assign(std::size_t(2 * sides), glm::dvec2(0.0));
    for (int k = 0; k < sides; ++k, i += 3 * down, j += 3 * right) {
      const glm::dvec2 start = net(i, j), end = net(i + 3 * down, j + 3 * right);
      const std::array<glm::dvec2, 2> thirds{start + (end - start) / 3.0,
                                             start + (end - start) * (2.0 / 3.0)};
      glm::dvec2* handles[]{&net(i + down, j + right), &net(i + 2 * down, j + 2 * right)};
      const bool is_curve = shape().next() != 0;
      for (std::size_t n = 0; n < 2; ++n) {
        glm::dvec2& bend = bends_[std::size_t(2 * k) + n];
        bend = is_curve ? bend + next_steps() : glm::dvec2(0.0);
        *handles[n] = thirds[n] + bend;
      }
    }
  }

  void read_interior(int row, int column) {
    BezierNet points{};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        points[std::size_t(i)][std::size_t(j)].position = net(3 * row + i, 3 * column + j);
    const auto coons = coons_interior(points);
    const bool has_tensor = shape().next() != 0;
    for (const int i : {1, 2})
      for (const int j : {1, 2})
        net(3 * row + i, 3 * column + j) = coons[std::size_t(i - 1)][std::size_t(j - 1)] +
                                           (has_tensor ? next_steps() : glm::dvec2(0.0));
  }

  void read_colors(int channel) {
    const std::int64_t levels = levels_[std::size_t(channel)];
    std::vector<std::int64_t> above(std::size_t(columns_ + 1)), here(above.size());
    for (int row = 0; row <= rows_; ++row, above.swap(here))
      for (int column = 0; column <= columns_; ++column) {
        const auto j = std::size_t(column);
        const std::int64_t up = above[j], left = j > 0 ? here[j - 1] : up,
                           across = j > 0 && row > 0 ? above[j - 1] : left;
        const std::int64_t expected =
            row == 0 ? left
                     : std::clamp(up + left - across, std::min(up, left), std::max(up, left));
        const std::int64_t off = lists_[std::size_t(3 + channel)].next();
        here[j] = std::clamp<std::int64_t>(expected + std::clamp<std::int64_t>(off, -65535, 65535),
                                           0, levels);
        corner(row, column)[channel] = double(here[j]) / double(levels);
      }
  }

  Patch patch(int row, int column) {
    BezierNet points{};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        points[std::size_t(i)][std::size_t(j)].position = net(3 * row + i, 3 * column + j) * step_;
    for (const int i : {0, 1})
      for (const int j : {0, 1})
        points[std::size_t(3 * i)][std::size_t(3 * j)].color = corner(row + i, column + j);
    Patch patch = patch_from_bezier(points);
    make_color_bilinear(patch);
    return patch;
  }

  std::array<Numbers, count>& lists_;
  glm::dvec2 step_{1.0};
  std::array<std::int64_t, 4> levels_{};
  int rows_ = 0, columns_ = 0;
  std::vector<glm::dvec2> net_;
  std::vector<glm::dvec4> corners_;
  /// How far the handles of the sides in the line before are from the thirds of their chords.
  std::vector<glm::dvec2> bends_;
};

}  // namespace

std::optional<std::vector<PatchGrid>> unpack_older_patches(std::string_view bytes) {
  std::array<Numbers, PatchReader::count> lists;
  for (Numbers& list : lists) list = Numbers::take_from(bytes);
  std::vector<PatchGrid> grids;
  const std::int64_t count = lists[0].next();
  PatchReader reader(lists);
  reader.read_scale();
  std::uint64_t room = limits().patches;
  for (std::int64_t i = 0; i < count; ++i) {
    auto grid = reader.read(room);
    if (!grid) return std::nullopt;
    room -= grid->patches.size();
    grids.push_back(std::move(*grid));
  }
  const bool is_whole = bytes.empty() && std::ranges::all_of(lists, &Numbers::is_exhausted);
  if (grids.empty() || !is_whole || !lie_near(grids)) return std::nullopt;
  return grids;
}

}  // namespace gradmesh
