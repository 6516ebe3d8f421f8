#include "formats/pdf/page/page_stroke.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/clamped_int.h"
#include "formats/pdf/objects/dictionary.h"

namespace gradmesh {
namespace {

/// The styles of caps and joins have the numbers 0 to 2.
template <class Style>
void set_line_shape(Style& style, QPDFObjectHandle number) {
  if (const auto n = number_of(number)) style = static_cast<Style>(clamped_int(*n, 0, 2));
}

/// Returns what a map does to a circle but for its size: the symmetric map of area 1 that makes the
/// same ellipse of it. The identity where it stays a circle, or has no area.
Affine pen_of(const Affine& map) {
  // The ellipse of A is that of the root of A A^T, which is symmetric.
  const glm::dmat2 square = map.linear * glm::transpose(map.linear);
  const double size = std::abs(map.determinant()), trace = square[0].x + square[1].y;
  // Farther than this from a circle it is a line, and its inverse has lost its digits.
  constexpr double rounding = 1e-6, thinnest = 1e-6;
  if (!(size > thinnest * trace) || trace < 2 * size * (1 + rounding)) return {};
  const double scale = 1 / std::sqrt(size * (trace + 2 * size));
  return {(square + glm::dmat2(size)) * scale, glm::dvec2(0.0)};
}

}  // namespace

void set_line_width(LineStyle& line, QPDFObjectHandle width) {
  if (const auto n = number_of(width); n && *n >= 0) line.width = *n;
}

void set_line_cap(LineStyle& line, QPDFObjectHandle cap) { set_line_shape(line.cap, cap); }

void set_line_join(LineStyle& line, QPDFObjectHandle join) { set_line_shape(line.join, join); }

void set_miter_limit(LineStyle& line, QPDFObjectHandle limit) {
  if (const auto n = number_of(limit); n && *n >= 1) line.miter_limit = *n;
}

void set_dashes(LineStyle& line, QPDFObjectHandle dashes, QPDFObjectHandle phase) {
  // Each stroke of a stranger's file has them, and may be as short as a dash.
  constexpr int most_dashes = 1000;
  if (!dashes.isArray() || dashes.getArrayNItems() > most_dashes) return;
  std::vector<double> lengths = numbers_of(dashes);
  if (lengths.empty() && dashes.getArrayNItems() > 0) return;
  if (std::ranges::any_of(lengths, [](double length) { return length < 0; })) return;
  // Dashes without any length would have no end.
  if (std::ranges::none_of(lengths, [](double length) { return length > 0; })) lengths.clear();
  line.dashes = std::move(lengths);
  line.dash_phase = number_of(phase).value_or(0);
}

void set_line_style(LineStyle& line, QPDFObjectHandle state) {
  set_line_width(line, value_of(state, "/LW"));
  set_line_cap(line, value_of(state, "/LC"));
  set_line_join(line, value_of(state, "/LJ"));
  set_miter_limit(line, value_of(state, "/ML"));
  QPDFObjectHandle dash = value_of(state, "/D");
  if (dash.isArray() && dash.getArrayNItems() == 2)
    set_dashes(line, dash.getArrayItem(0), dash.getArrayItem(1));
}

PageStroke page_stroke(PagePath path, LineStyle line, const Affine& to_page) {
  const double scale = std::sqrt(std::abs(to_page.determinant()));
  const auto put = [&](double& length) {
    // What is longer than any page is wide looks the same, and is a number that SVG can hold.
    constexpr double longest = 1e6;
    length = std::clamp(scale * length, -longest, longest);
  };
  put(line.width);
  std::ranges::for_each(line.dashes, put);
  put(line.dash_phase);
  // A line as thin as can be seen is as thin in all directions.
  const Affine pen = line.width > 0 ? pen_of(to_page) : Affine();
  return {std::move(path), std::move(line), pen};
}

}  // namespace gradmesh
