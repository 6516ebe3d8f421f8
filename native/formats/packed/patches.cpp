#include "formats/packed/patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "base/limits.h"
#include "formats/packed/expectation.h"
#include "formats/packed/range_coder.h"
#include "formats/packed/scale.h"

namespace gradmesh {
namespace {

constexpr glm::dvec2 no_guess(std::numeric_limits<double>::quiet_NaN());

/// Writes or reads all patches, as its coder does.
class PatchCoder {
 public:
  explicit PatchCoder(RangeCoder coder) : coder_(std::move(coder)) {}

  RangeCoder& coder() { return coder_; }
  std::int64_t code(std::int64_t count) { return counts_.code(coder_, count); }
  bool code(bool flag) { return coder_.code(flag); }

  /// Returns nothing if the text would be longer than `most`.
  std::optional<std::string> code(std::string text, std::int64_t most) {
    const std::int64_t length = code(std::int64_t(text.size()));
    if (length < 0 || length > most) return std::nullopt;
    text.resize(std::size_t(length));
    for (char& letter : text) {
      unsigned known = 1;  // The bits so far, after a one.
      for (int bit = 7; bit >= 0; --bit)
        known = known << 1 | coder_.code(letter >> bit & 1, letter_chances_[known]);
      letter = char(std::uint8_t(known));
    }
    return text;
  }

  void code(const Scale& known) {
    const auto between = [&](std::int64_t number, std::int64_t low, std::int64_t high) {
      return std::clamp(code(number), low, high);
    };
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto [is_decimal, exponent] = known.steps[axis];
      const bool decimal = coder_.code(is_decimal);
      scale_.steps[axis] = {decimal, int(between(exponent, decimal ? -15 : -1000, 1000))};
    }
    for (std::size_t channel = 0; channel < 4; ++channel)
      scale_.levels[channel] = between(known.levels[channel], 1, 65535);
  }

  /// Returns false if the grid would have none or more than `most` patches.
  bool code(PatchGrid& grid, std::uint64_t most) {
    const std::int64_t rows = code(std::int64_t(grid.rows)),
                       columns = code(std::int64_t(grid.columns));
    if (rows < 1 || columns < 1 || std::uint64_t(rows) > most ||
        std::uint64_t(columns) > most / std::uint64_t(rows))
      return false;
    rows_ = grid.rows = int(rows);
    columns_ = grid.columns = int(columns);
    net_.assign(std::size_t(3 * rows_ + 1) * std::size_t(3 * columns_ + 1), {});
    corners_.assign(std::size_t(rows_ + 1) * std::size_t(columns_ + 1), glm::dvec4(0.0));
    if (!coder_.is_read()) take(grid);
    code_corners();
    code_lines({.down = 0, .right = 1, .sides = columns_, .lines = rows_ + 1});
    code_lines({.down = 1, .right = 0, .sides = rows_, .lines = columns_ + 1});
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) code_interior(row, column);
    for (int channel = 0; channel < 4; ++channel) code_colors(channel);
    grid.patches.clear();
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) grid.patches.push_back(patch(row, column));
    return true;
  }

 private:
  /// The lines of the net along its rows or its columns.
  struct Lines {
    int down, right, sides, lines;
  };
  /// A curve's handles from the thirds of its chord; no_guess for a line.
  using Bends = std::array<glm::dvec2, 2>;
  /// What handles may be guessed from.
  static constexpr std::size_t ways = 4;
  using Guesses = std::array<glm::dvec2, ways>;

  /// Returns a point of the net of the whole grid, in steps.
  glm::dvec2& net(int i, int j) {
    return net_[std::size_t(i) * std::size_t(3 * columns_ + 1) + std::size_t(j)];
  }
  glm::dvec4& corner(int row, int column) {
    return corners_[std::size_t(row) * std::size_t(columns_ + 1) + std::size_t(column)];
  }
  /// Returns point `k` of a line; no_guess beyond its ends.
  glm::dvec2 on_line(const Lines& all, int line, int k) {
    if (k < 0 || k > 3 * all.sides) return no_guess;
    return net(3 * line * all.right + k * all.down, 3 * line * all.down + k * all.right);
  }

  /// Writes nothing yet: takes points and colours of the patches.
  void take(const PatchGrid& grid) {
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) {
        const BezierNet from = bezier_net(grid.patches[std::size_t(row * columns_ + column)]);
        for (int i = 0; i < 4; ++i)
          for (int j = 0; j < 4; ++j) {
            const glm::dvec2 p = from[std::size_t(i)][std::size_t(j)].position;
            net(3 * row + i, 3 * column + j) = {scale_.steps[0].count(p.x),
                                                scale_.steps[1].count(p.y)};
          }
        for (const int i : {0, 1})
          for (const int j : {0, 1})
            corner(row + i, column + j) = from[std::size_t(3 * i)][std::size_t(3 * j)].color;
      }
  }

  /// Writes or reads a number that is whole but for rounding, as it differs from `expected`.
  double code_number(double number, double expected, Spread& spread) {
    return expected + double(spread.code(coder_, std::llround(number - expected)));
  }

  void code_corners() {
    const auto corner_at = [&](int i, int j) {
      return i < 0 || j < 0 ? no_guess : net(3 * i, 3 * j);
    };
    for (int i = 0; i <= rows_; ++i)
      for (int j = 0; j <= columns_; ++j) {
        const glm::dvec2 left = corner_at(i, j - 1), up = corner_at(i - 1, j);
        const std::array<glm::dvec2, 4> guesses{left + up - corner_at(i - 1, j - 1),
                                                2.0 * left - corner_at(i, j - 2),
                                                2.0 * up - corner_at(i - 2, j),
                                                j > 0   ? left
                                                : i > 0 ? up
                                                        : last_};
        code_point(net(3 * i, 3 * j), guesses, expected_corners_, corner_spreads_);
      }
    last_ = net(0, 0);
  }

  template <std::size_t count>
  void code_point(glm::dvec2& point, const std::array<glm::dvec2, count>& guesses,
                  std::array<Expectation<count>, 2>& expectations, std::array<Spread, 2>& spreads) {
    for (int axis = 0; axis < 2; ++axis) {
      std::array<double, count> of_axis;
      for (std::size_t way = 0; way < count; ++way) of_axis[way] = guesses[way][axis];
      Expectation<count>& expectation = expectations[std::size_t(axis)];
      point[axis] = code_number(point[axis], expectation.of(of_axis), spreads[std::size_t(axis)]);
      expectation.learn(of_axis, point[axis]);
    }
  }

  /// Codes which sides along the rows or the columns are curves, and the handles of these.
  void code_lines(const Lines& all) {
    std::vector<Bends> bends(std::size_t(all.sides), Bends{no_guess, no_guess});
    std::vector<bool> is_curve(bends.size());
    for (int line = 0; line < all.lines; ++line)
      for (int k = 0; k < all.sides; ++k) {
        const auto side = std::size_t(k);
        const bool was_curve = k > 0 && is_curve[side - 1];
        is_curve[side] =
            coder_.code(has_bend(all, line, k), curve_chances_[is_curve[side]][was_curve]);
        bends[side] = code_handles(all, line, k, is_curve[side], was_curve, bends[side]);
      }
  }

  Bends thirds(const Lines& all, int line, int k) {
    const glm::dvec2 start = on_line(all, line, 3 * k), end = on_line(all, line, 3 * k + 3);
    return {start + (end - start) / 3.0, start + (end - start) * (2.0 / 3.0)};
  }

  bool has_bend(const Lines& all, int line, int k) {
    const Bends straight = thirds(all, line, k);
    return is_off(on_line(all, line, 3 * k + 1) - straight[0]) ||
           is_off(on_line(all, line, 3 * k + 2) - straight[1]);
  }

  /// Codes the handles of a side; `above` are the bends of the same side in the line before.
  /// Returns the bends.
  Bends code_handles(const Lines& all, int line, int k, bool is_curve, bool was_curve,
                     const Bends& above) {
    const Bends straight = thirds(all, line, k);
    Bends bends{no_guess, no_guess};
    for (const int n : {0, 1}) {
      const auto end = std::size_t(n);
      const int at = 3 * k + 1 + n;
      glm::dvec2& handle =
          net(3 * line * all.right + at * all.down, 3 * line * all.down + at * all.right);
      if (!is_curve) {
        handle = straight[end];
        continue;
      }
      const Guesses guesses{straight[end] + above[end], smooth_handle(all, line, k, n),
                            n == 0 && was_curve ? continued_handle(all, line, k) : no_guess,
                            n == 0 ? straight[end] : straight[end] + bends[0]};
      code_point(handle, guesses, expected_handles_[end], handle_spreads_);
      bends[end] = handle - straight[end];
    }
    return bends;
  }

  /// Returns the handle of a curve through the corners before, at and after the end `n` of a side
  /// that runs through each at a time like the length of its chords.
  glm::dvec2 smooth_handle(const Lines& all, int line, int k, int n) {
    const int at = 3 * (k + n);
    const glm::dvec2 here = on_line(all, line, at);
    const glm::dvec2 back = here - on_line(all, line, at - 3),
                     forth = on_line(all, line, at + 3) - here;
    const double before = glm::length(back), after = glm::length(forth);
    const glm::dvec2 direction =
        (back * (after / before) + forth * (before / after)) / (3 * (before + after));
    return n == 0 ? here + direction * after : here - direction * before;
  }

  /// Returns the first handle of a side that goes on as the side before ends.
  glm::dvec2 continued_handle(const Lines& all, int line, int k) {
    const glm::dvec2 here = on_line(all, line, 3 * k);
    const double before = glm::length(here - on_line(all, line, 3 * k - 3)),
                 after = glm::length(here - on_line(all, line, 3 * k + 3));
    return here + (here - on_line(all, line, 3 * k - 1)) * (after / before);
  }

  void code_interior(int row, int column) {
    BezierNet points{};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        points[std::size_t(i)][std::size_t(j)].position = net(3 * row + i, 3 * column + j);
    const auto coons = coons_interior(points);
    const auto each = [&](const auto& work) {
      for (const int i : {1, 2})
        for (const int j : {1, 2})
          work(net(3 * row + i, 3 * column + j), coons[std::size_t(i - 1)][std::size_t(j - 1)]);
    };
    bool is_off_coons = false;
    each([&](glm::dvec2& p, glm::dvec2 q) { is_off_coons = is_off_coons || is_off(p - q); });
    if (!coder_.code(is_off_coons, tensor_chance_))
      each([&](glm::dvec2& p, glm::dvec2 q) { p = q; });
    else
      each([&](glm::dvec2& p, glm::dvec2 q) {
        code_point(p, std::array{q}, expected_tensors_, tensor_spreads_);
      });
  }

  void code_colors(int channel) {
    const std::int64_t levels = scale_.levels[std::size_t(channel)];
    Spread& spread = color_spreads_[channel == 3];
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
        const std::int64_t level = std::llround(std::clamp(value, 0.0, 1.0) * double(levels));
        const std::int64_t off = spread.code(coder_, level - expected);
        here[j] = std::clamp<std::int64_t>(expected + std::clamp(off, -levels, levels), 0, levels);
        value = double(here[j]) / double(levels);
      }
  }

  /// Returns true if a distance in steps is more than rounding leaves.
  bool is_off(glm::dvec2 steps) const {
    return std::abs(steps.x) > scale_.steps[0].noise() ||
           std::abs(steps.y) > scale_.steps[1].noise();
  }

  Patch patch(int row, int column) {
    BezierNet points{};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const glm::dvec2 p = net(3 * row + i, 3 * column + j);
        points[std::size_t(i)][std::size_t(j)].position = {scale_.steps[0].times(p.x),
                                                           scale_.steps[1].times(p.y)};
      }
    for (const int i : {0, 1})
      for (const int j : {0, 1})
        points[std::size_t(3 * i)][std::size_t(3 * j)].color = corner(row + i, column + j);
    Patch patch = patch_from_bezier(points);
    make_color_bilinear(patch);
    return patch;
  }

  RangeCoder coder_;
  Scale scale_;
  int rows_ = 0, columns_ = 0;
  std::vector<glm::dvec2> net_;
  std::vector<glm::dvec4> corners_;
  /// The first corner of the grid before.
  glm::dvec2 last_{0.0};
  Spread counts_;
  std::array<Spread, 2> corner_spreads_{}, handle_spreads_{}, tensor_spreads_{};
  /// Of colours and of opacities.
  std::array<Spread, 2> color_spreads_{};
  std::array<Expectation<4>, 2> expected_corners_{};
  /// At the starts and at the ends of sides.
  std::array<std::array<Expectation<ways>, 2>, 2> expected_handles_{};
  std::array<Expectation<1>, 2> expected_tensors_{};
  /// That a side is a curve, where that above and that before are none or one.
  std::array<std::array<Chance, 2>, 2> curve_chances_{};
  Chance tensor_chance_;
  std::array<Chance, 256> letter_chances_{};
};

}  // namespace

std::string pack(PackedMesh mesh, int precision) {
  PatchCoder coder{RangeCoder()};
  coder.code(mesh.smooth);
  coder.code(mesh.curves, INT64_MAX);
  coder.code(std::int64_t(mesh.grids.size()));
  coder.code(scale_for(mesh.grids, precision));
  for (PatchGrid& grid : mesh.grids) coder.code(grid, grid.patches.size());
  return coder.coder().finish();
}

std::optional<PackedMesh> unpack(std::string_view bytes) {
  // Far more than a text of numbers, so that few bytes do not become many.
  constexpr std::size_t most_letters = 100;
  PatchCoder coder{RangeCoder(bytes)};
  PackedMesh mesh{.smooth = coder.code(false)};
  auto curves = coder.code("", std::int64_t(most_letters * bytes.size()));
  if (!curves) return std::nullopt;
  mesh.curves = std::move(*curves);
  const std::int64_t count = coder.code(std::int64_t(0));
  coder.code(Scale());
  std::uint64_t room = limits().patches;
  for (std::int64_t i = 0; i < count; ++i) {
    PatchGrid& grid = mesh.grids.emplace_back();
    if (!coder.code(grid, room)) return std::nullopt;
    room -= grid.patches.size();
  }
  if (mesh.grids.empty() || !coder.coder().is_exhausted() || !lie_near(mesh.grids))
    return std::nullopt;
  return mesh;
}

}  // namespace gradmesh
