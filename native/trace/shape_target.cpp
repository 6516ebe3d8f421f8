#include "trace/shape_target.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "base/clamped_int.h"
#include "geom/crossings.h"

namespace gradmesh {
namespace {

/// Adds to the pixels of a row what a line covers of them from one place to another.
void cover(double from, double to, float share, float* row, int width) {
  const double last = width;
  from = std::clamp(from, 0.0, last);
  to = std::clamp(to, 0.0, last);
  for (int x = clamped_int(std::floor(from), 0, width); x < to; ++x)
    row[x] += share * float(std::min<double>(x + 1, to) - std::max<double>(x, from));
}

/// Returns the whole pixels around an outline that `turn` has brought here, and one more each way.
ShapeFrame frame_around(const Outline& outline, const glm::dmat2& turn) {
  constexpr int margin = 1, most = 1 << 15;
  constexpr double last_bits = 1e-6;
  const Box box = bounding_box(mapped(outline, {glm::transpose(turn), glm::dvec2(0.0)}));
  const glm::dvec2 low = glm::floor(box.low() + last_bits) - double(margin);
  const glm::dvec2 size = glm::ceil(box.high() - last_bits) + double(margin) - low;
  return {Affine{turn, turn * low}, clamped_int(size.x, 1, most), clamped_int(size.y, 1, most)};
}

double area(const ShapeFrame& frame) { return double(frame.width) * frame.height; }

/// Returns the angle, in radians and at most an eighth of a turn, from the axes to an outline's
/// main axes: those of the moments of inertia of the line.
double main_angle(const Outline& outline) {
  double length = 0, xx = 0, xy = 0, yy = 0;
  glm::dvec2 sum(0.0);
  for (const std::vector<glm::dvec2>& polygon : outline)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()],
                       middle = (a + b) / 2.0;
      const double here = glm::length(b - a);
      length += here;
      sum += here * middle;
      xx += here * middle.x * middle.x;
      xy += here * middle.x * middle.y;
      yy += here * middle.y * middle.y;
    }
  if (!(length > 0)) return 0;
  const glm::dvec2 center = sum / length;
  const double angle =
      0.5 * std::atan2(2 * (xy - length * center.x * center.y),
                       xx - yy - length * (center.x * center.x - center.y * center.y));
  constexpr double quarter = std::numbers::pi / 2;
  return angle - quarter * std::round(angle / quarter);
}

/// Returns what a mesh is to be (level_for) at a place between the centres of its pixels.
glm::vec4 sample(const RgbaImage& picture, glm::dvec2 place) {
  const double x = place.x - 0.5, y = place.y - 0.5;
  const int x0 = clamped_int(std::floor(x), 0, picture.width - 1);
  const int y0 = clamped_int(std::floor(y), 0, picture.height - 1);
  const double fx = std::clamp(x - x0, 0.0, 1.0), fy = std::clamp(y - y0, 0.0, 1.0);
  glm::dvec3 color(0.0), plain(0.0);
  double opacity = 0;
  for (const int dy : {0, 1})
    for (const int dx : {0, 1}) {
      const glm::dvec4 pixel = level_for(picture.pixel(std::min(x0 + dx, picture.width - 1),
                                                       std::min(y0 + dy, picture.height - 1)));
      const double share = (dx ? fx : 1 - fx) * (dy ? fy : 1 - fy);
      color += share * pixel.a * glm::dvec3(pixel);
      plain += share * glm::dvec3(pixel);
      opacity += share * pixel.a;
    }
  return {glm::vec3(opacity > 0 ? color / opacity : plain), float(opacity)};
}

/// Returns the shares, 0..1, of pixels that a shape covers.
std::vector<float> covered_shares(const FilledOutline& shape, int width, int height) {
  constexpr int a_row = 8;
  std::vector<float> shares(std::size_t(width) * std::size_t(height));
  const auto lines = crossings(shape.outline, a_row, 0.5, a_row * height);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    float* const row = shares.data() + k / a_row * std::size_t(width);
    int winding = 0;
    for (std::size_t i = 0; i + 1 < lines[k].size(); ++i) {
      winding += lines[k][i].winding;
      if (is_inside(winding, shape.rule))
        cover(lines[k][i].x, lines[k][i + 1].x, 1.0f / a_row, row, width);
    }
  }
  return shares;
}

}  // namespace

ShapeFrame straight_frame(const Outline& outline) { return frame_around(outline, glm::dmat2(1.0)); }

std::optional<ShapeFrame> turned_frame(const Outline& outline) {
  constexpr double least_angle = 0.05, little_smaller = 0.9;
  const double angle = main_angle(outline);
  if (std::abs(angle) < least_angle) return {};
  const double c = std::cos(angle), s = std::sin(angle);
  const ShapeFrame frame = frame_around(outline, glm::dmat2(c, s, -s, c));
  if (area(frame) > little_smaller * area(straight_frame(outline))) return {};
  return frame;
}

std::vector<float> counted_pixels(const FilledOutline& shape, int width, int height) {
  constexpr float all = 0.999f;
  std::vector<float> shares = covered_shares(shape, width, height);
  if (std::ranges::any_of(shares, [](float share) { return share > all; }))
    for (float& share : shares) share = share > all ? 1.0f : 0.0f;
  return shares;
}

TargetPicture target_of_shape(const RgbaImage& picture, const FilledOutline& shape,
                              const ShapeFrame& frame, double scale) {
  const bool is_straight = frame.to_picture.linear == glm::dmat2(1.0);
  const double beyond = point_of_pixels(scale) - 0.5;
  TargetPicture target;
  target.width = frame.width;
  target.height = frame.height;
  // In a turned frame it is the picture that is moved, and not the point in the pixels.
  if (is_straight) target.point = 0.5 + beyond;
  const Affine to_frame = frame.to_picture.inverse();
  target.weights = counted_pixels(mapped(shape, to_frame), frame.width, frame.height);
  target.pixels.reserve(target.weights.size());
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      glm::dvec2 place = frame.to_picture.point({x + 0.5, y + 0.5});
      float& weight = target.weights[target.pixels.size()];
      const bool is_in_picture =
          place.x > 0 && place.y > 0 && place.x < picture.width && place.y < picture.height;
      if (!is_in_picture) weight = 0;
      if (!is_straight) place -= beyond;
      target.pixels.push_back(sample(picture, place));
      target.is_opaque = target.is_opaque && (weight == 0 || target.pixels.back().a == 255);
    }
  return target;
}

void weigh(TargetPicture& target, const std::vector<WeightedArea>& areas, const Affine& to_pixels) {
  const auto factors = weights_in({target.width, target.height, to_pixels}, areas);
  if (!factors) return;
  if (target.weights.empty()) target.weights.assign(target.samples(), 1.0F);
  for (std::size_t n = 0; n < target.samples(); ++n) target.weights[n] *= factors->samples[n];
}

}  // namespace gradmesh
