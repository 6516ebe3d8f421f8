#include "formats/packed/patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "base/limits.h"
#include "formats/packed/numbers.h"
#include "geom/box.h"

namespace gradmesh {
namespace {

constexpr double farthest = 1e9;

/// How numbers stand for positions and colours.
struct Scale {
  /// The steps of x and y are 2 to these powers.
  std::array<std::int64_t, 2> exponents{};
  /// For each channel, the number of steps from 0 to 1.
  std::array<std::int64_t, 4> levels{};

  glm::dvec2 step() const {
    return {std::ldexp(1.0, int(exponents[0])), std::ldexp(1.0, int(exponents[1]))};
  }
};

/// Writes or reads all patches, as its Numbers do.
class PatchCoder {
 public:
  /// The lists: what belongs to all, rows and columns and whether sides are curves, x, y, channels.
  static constexpr int count = 7;
  explicit PatchCoder(std::array<Numbers, count>& lists) : lists_(lists) {}

  bool is_read() const { return lists_[0].is_read(); }

  void code(Scale& scale) {
    for (std::int64_t& exponent : scale.exponents)
      exponent = std::clamp<std::int64_t>(shape().code(exponent), -1000, 1000);
    for (std::int64_t& levels : scale.levels)
      levels = std::clamp<std::int64_t>(shape().code(levels), 1, 65535);
    scale_ = scale;
  }

  /// Returns false if the grid would have none or more than `most` patches.
  bool code(PatchGrid& grid, std::uint64_t most) {
    const std::int64_t rows = shape().code(grid.rows), columns = shape().code(grid.columns);
    if (rows < 1 || columns < 1 || std::uint64_t(rows) > most ||
        std::uint64_t(columns) > most / std::uint64_t(rows))
      return false;
    rows_ = grid.rows = int(rows);
    columns_ = grid.columns = int(columns);
    net_.assign(std::size_t(3 * rows_ + 1) * std::size_t(3 * columns_ + 1), {});
    corners_.assign(std::size_t(rows_ + 1) * std::size_t(columns_ + 1), glm::dvec4(0.0));
    if (!is_read()) take(grid);
    code_corners();
    for (int i = 0; i <= rows_; ++i) code_line(3 * i, 0, 0, 1, columns_);
    for (int j = 0; j <= columns_; ++j) code_line(0, 3 * j, 1, 0, rows_);
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) code_interior(row, column);
    for (int channel = 0; channel < 4; ++channel) code_colors(channel);
    grid.patches.clear();
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) grid.patches.push_back(patch(row, column));
    return true;
  }

 private:
  Numbers& shape() { return lists_[0]; }

  /// Returns a point of the net of the whole grid, in steps.
  glm::dvec2& net(int i, int j) {
    return net_[std::size_t(i) * std::size_t(3 * columns_ + 1) + std::size_t(j)];
  }
  glm::dvec4& corner(int row, int column) {
    return corners_[std::size_t(row) * std::size_t(columns_ + 1) + std::size_t(column)];
  }

  /// Writes nothing yet: takes points and colours of the patches.
  void take(const PatchGrid& grid) {
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) {
        const BezierNet from = bezier_net(grid.patches[std::size_t(row * columns_ + column)]);
        for (int i = 0; i < 4; ++i)
          for (int j = 0; j < 4; ++j)
            net(3 * row + i, 3 * column + j) =
                from[std::size_t(i)][std::size_t(j)].position / scale_.step();
        for (const int i : {0, 1})
          for (const int j : {0, 1})
            corner(row + i, column + j) = from[std::size_t(3 * i)][std::size_t(3 * j)].color;
      }
  }

  /// Writes how far a point is from where it is expected, in whole steps, or reads that. Returns
  /// these steps.
  glm::dvec2 code_steps(glm::dvec2 steps) {
    const auto code = [](Numbers& list, double n) { return double(list.code(std::llround(n))); };
    return {code(lists_[1], steps.x), code(lists_[2], steps.y)};
  }

  void code_corners() {
    for (int i = 0; i <= 3 * rows_; i += 3)
      for (int j = 0; j <= 3 * columns_; j += 3) {
        glm::dvec2 expected(0.0);
        if (i > 0 && j > 0)
          expected = net(i - 3, j) + net(i, j - 3) - net(i - 3, j - 3);
        else if (i > 0 || j > 0)
          expected = i > 0 ? net(i - 3, j) : net(i, j - 3);
        net(i, j) = expected + code_steps(net(i, j) - expected);
      }
    bends_.clear();
  }

  /// Codes the handles of `sides` sides in one line of the net from (i, j) on. How a side bends
  /// away from its chord is expected to be as in the line before.
  void code_line(int i, int j, int down, int right, int sides) {
    const bool is_first = i == 0 && j == 0;
    if (is_first) bends_.assign(std::size_t(2 * sides), glm::dvec2(0.0));
    for (int k = 0; k < sides; ++k, i += 3 * down, j += 3 * right) {
      const glm::dvec2 start = net(i, j), end = net(i + 3 * down, j + 3 * right);
      const std::array<glm::dvec2, 2> thirds{start + (end - start) / 3.0,
                                             start + (end - start) * (2.0 / 3.0)};
      glm::dvec2* handles[]{&net(i + down, j + right), &net(i + 2 * down, j + 2 * right)};
      const bool is_curve =
          code_flag(is_off(*handles[0] - thirds[0]) || is_off(*handles[1] - thirds[1]));
      for (std::size_t n = 0; n < 2; ++n) {
        glm::dvec2& bend = bends_[std::size_t(2 * k) + n];
        bend = is_curve ? bend + code_steps(*handles[n] - thirds[n] - bend) : glm::dvec2(0.0);
        *handles[n] = thirds[n] + bend;
      }
    }
  }

  void code_interior(int row, int column) {
    BezierNet points{};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        points[std::size_t(i)][std::size_t(j)].position = net(3 * row + i, 3 * column + j);
    const auto coons = coons_interior(points);
    bool is_off_coons = false;
    const auto each = [&](const auto& work) {
      for (const int i : {1, 2})
        for (const int j : {1, 2})
          work(net(3 * row + i, 3 * column + j), coons[std::size_t(i - 1)][std::size_t(j - 1)]);
    };
    each([&](glm::dvec2& p, glm::dvec2 q) { is_off_coons = is_off_coons || is_off(p - q); });
    const bool has_tensor = code_flag(is_off_coons);
    each([&](glm::dvec2& p, glm::dvec2 q) { p = has_tensor ? q + code_steps(p - q) : q; });
  }

  void code_colors(int channel) {
    const double levels = double(scale_.levels[std::size_t(channel)]);
    std::vector<std::int64_t> above(std::size_t(columns_ + 1)), here(above.size());
    for (int row = 0; row <= rows_; ++row, above.swap(here))
      for (int column = 0; column <= columns_; ++column) {
        const auto j = std::size_t(column);
        const std::int64_t up = above[j], left = j > 0 ? here[j - 1] : up,
                           across = j > 0 && row > 0 ? above[j - 1] : left;
        const std::int64_t expected =
            row == 0 ? left
                     : std::clamp(up + left - across, std::min(up, left), std::max(up, left));
        double& value = corner(row, column)[channel];
        const std::int64_t level = std::llround(std::clamp(value, 0.0, 1.0) * levels);
        const std::int64_t off = lists_[std::size_t(3 + channel)].code(level - expected);
        here[j] = std::clamp<std::int64_t>(expected + std::clamp<std::int64_t>(off, -65535, 65535),
                                           0, std::int64_t(levels));
        value = double(here[j]) / levels;
      }
  }

  bool code_flag(bool flag) { return shape().code(flag) != 0; }
  /// Returns true if a distance in steps is more than rounding leaves.
  static bool is_off(glm::dvec2 steps) {
    constexpr double most = 0.75;
    return std::abs(steps.x) > most || std::abs(steps.y) > most;
  }

  Patch patch(int row, int column) {
    BezierNet points{};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        points[std::size_t(i)][std::size_t(j)].position =
            net(3 * row + i, 3 * column + j) * scale_.step();
    for (const int i : {0, 1})
      for (const int j : {0, 1})
        points[std::size_t(3 * i)][std::size_t(3 * j)].color = corner(row + i, column + j);
    Patch patch = patch_from_bezier(points);
    make_color_bilinear(patch);
    return patch;
  }

  std::array<Numbers, count>& lists_;
  Scale scale_;
  int rows_ = 0, columns_ = 0;
  std::vector<glm::dvec2> net_;
  std::vector<glm::dvec4> corners_;
  /// How far the handles of the sides in the line before are from the thirds of their chords.
  std::vector<glm::dvec2> bends_;
};

template <class Visit>
void visit_values(const std::vector<PatchGrid>& grids, const Visit& visit) {
  for (const PatchGrid& grid : grids)
    for (const Patch& patch : grid.patches)
      for (const auto& row : bezier_net(patch))
        for (const Value& value : row) visit(value);
}

std::int64_t exponent_for(double low, double high, int precision) {
  constexpr int most_bits = 50;  // Of a double, so that steps are counted exactly.
  const double size = high - low, largest = std::max(std::abs(low), std::abs(high));
  if (largest == 0) return 0;
  const int finest = std::ilogb(largest) - most_bits;
  return std::max({size > 0 ? std::ilogb(size) - precision : finest, finest, -1000});
}

Scale scale_for(const std::vector<PatchGrid>& grids, int precision) {
  Box box;
  visit_values(grids, [&](const Value& value) { box.add(value.position); });
  Scale scale;
  scale.exponents = {exponent_for(box.low().x, box.high().x, precision),
                     exponent_for(box.low().y, box.high().y, precision)};
  scale.levels.fill(255);
  for (const PatchGrid& grid : grids)
    for (const Patch& patch : grid.patches)
      for (int k = 0; k < 4; ++k)
        for (int channel = 0; channel < 4; ++channel) {
          const double level = 255 * std::clamp(patch.corner(k).color[channel], 0.0, 1.0);
          constexpr double rounding = 1e-6;
          if (std::abs(level - std::round(level)) > rounding)
            scale.levels[std::size_t(channel)] = 65535;
        }
  return scale;
}

bool is_near(const std::vector<PatchGrid>& grids) {
  bool near = true;
  visit_values(grids, [&](const Value& value) {
    near = near && std::abs(value.position.x) <= farthest && std::abs(value.position.y) <= farthest;
  });
  return near;
}

}  // namespace

std::string pack_patches(std::vector<PatchGrid> grids, int precision) {
  std::array<Numbers, PatchCoder::count> lists;
  Scale scale = scale_for(grids, precision);
  lists[0].code(std::int64_t(grids.size()));
  PatchCoder coder(lists);
  coder.code(scale);
  for (PatchGrid& grid : grids) coder.code(grid, grid.patches.size());
  std::string bytes;
  for (const Numbers& list : lists) list.append_to(bytes);
  return bytes;
}

std::optional<std::vector<PatchGrid>> unpack_patches(std::string_view bytes) {
  std::array<Numbers, PatchCoder::count> lists;
  for (Numbers& list : lists) list = Numbers::take_from(bytes);
  std::vector<PatchGrid> grids;
  const std::int64_t count = lists[0].code(0);
  PatchCoder coder(lists);
  Scale scale;
  coder.code(scale);
  std::uint64_t room = limits().patches;
  for (std::int64_t i = 0; i < count; ++i) {
    PatchGrid& grid = grids.emplace_back();
    if (!coder.code(grid, room)) return std::nullopt;
    room -= grid.patches.size();
  }
  const bool is_whole = bytes.empty() && std::ranges::all_of(lists, &Numbers::is_exhausted);
  if (grids.empty() || !is_whole || !is_near(grids)) return std::nullopt;
  return grids;
}

}  // namespace gradmesh
