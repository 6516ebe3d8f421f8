#include <algorithm>
#include <cstdint>

#include "raster/parameters.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/cover.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gradmesh::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr int unit = 1 << subpixel_bits;
constexpr int half = unit / 2;
/// Returns true if the edge functions of a triangle of that size, in grid units, fit into 32 bits
/// at all pixels of its box and a vector beyond.
bool is_small(std::int64_t width, std::int64_t height) {
  constexpr int beyond = (int(row_padding) + 1) * unit;
  return 2 * (width + beyond) * (height + beyond) < INT32_MAX;
}

/// Twice the area, in grid units, of the triangle between an edge and a pixel's centre: positive
/// inside. A centre on an edge belongs to the triangle on its right, or below it; so the function
/// is less by one on other edges, and a pixel is covered if none of the three is negative.
struct Edge {
  std::int32_t at_first, step_x, step_y, less;

  Edge(const Vertex& a, const Vertex& b, int x, int y) {
    const std::int32_t dx = b.x - a.x, dy = b.y - a.y;
    less = dy < 0 || (dy == 0 && dx > 0) ? 0 : 1;
    at_first = dx * (y * unit + half - a.y) - dy * (x * unit + half - a.x) - less;
    step_x = -dy * unit;
    step_y = dx * unit;
  }
};

/// Stores the parameters of a vector of covered pixels. Where patches may fold the larger v, then
/// the larger u, stays.
template <bool folds, class D, class V, class M>
HWY_INLINE void store(D d, V u, V v, M covered, float* u_at, float* v_at) {
  if constexpr (folds) {
    const V u_before = hn::LoadU(d, u_at), v_before = hn::LoadU(d, v_at);
    const M above = hn::Or(hn::Gt(v, v_before), hn::And(hn::Eq(v, v_before), hn::Gt(u, u_before)));
    covered = hn::And(covered, above);
  }
  hn::BlendedStore(u, covered, d, u_at);
  hn::BlendedStore(v, covered, d, v_at);
}

/// Covers the triangle a, b, c, clockwise and small, over the pixels of `box`.
template <bool folds, class D>
void cover_small(D d, const Vertex& a, const Vertex& b, const Vertex& c, std::int64_t area,
                 Window box, Parameters& parameters) {
  const hn::RebindToSigned<D> di;
  const Edge ab(a, b, box.x0, box.y0), bc(b, c, box.x0, box.y0), ca(c, a, box.x0, box.y0);

  // The share of a corner is the function of the edge opposite, over the triangle's area.
  const float scale = 1.0F / float(area);
  const float u_b = (b.u - a.u) * scale, u_c = (c.u - a.u) * scale;
  const float v_b = (b.v - a.v) * scale, v_c = (c.v - a.v) * scale;
  const auto per_b_u = hn::Set(d, u_b), per_c_u = hn::Set(d, u_c);
  const auto per_b_v = hn::Set(d, v_b), per_c_v = hn::Set(d, v_c);
  const auto u0 = hn::Set(d, a.u + (float(ca.less) * u_b + float(ab.less) * u_c));
  const auto v0 = hn::Set(d, a.v + (float(ca.less) * v_b + float(ab.less) * v_c));

  const auto lane = hn::Iota(di, 0);
  const auto first = [&](const Edge& edge) {
    return hn::Add(hn::Set(di, edge.at_first), hn::Mul(lane, hn::Set(di, edge.step_x)));
  };
  auto row_ab = first(ab), row_bc = first(bc), row_ca = first(ca);
  const auto down_ab = hn::Set(di, ab.step_y), down_bc = hn::Set(di, bc.step_y),
             down_ca = hn::Set(di, ca.step_y);
  const int lanes = int(hn::Lanes(d));
  const auto right_ab = hn::Set(di, ab.step_x * lanes), right_bc = hn::Set(di, bc.step_x * lanes),
             right_ca = hn::Set(di, ca.step_x * lanes);

  const std::size_t start = parameters.offset(box.x0, box.y0);
  float* u_row = parameters.u.data() + start;
  float* v_row = parameters.v.data() + start;
  const int width = box.width();
  for (int y = box.y0; y < box.y1; ++y) {
    auto on_ab = row_ab, on_bc = row_bc, on_ca = row_ca;
    for (int x = 0; x < width; x += lanes) {
      const auto outside = hn::Or(hn::Or(on_ab, on_bc), on_ca);
      const auto covered = hn::RebindMask(d, hn::Gt(outside, hn::Set(di, -1)));
      const auto to_b = hn::ConvertTo(d, on_ca), to_c = hn::ConvertTo(d, on_ab);
      const auto u = hn::Add(u0, hn::Add(hn::Mul(to_b, per_b_u), hn::Mul(to_c, per_c_u)));
      const auto v = hn::Add(v0, hn::Add(hn::Mul(to_b, per_b_v), hn::Mul(to_c, per_c_v)));
      store<folds>(d, u, v, covered, u_row + x, v_row + x);
      on_ab = hn::Add(on_ab, right_ab);
      on_bc = hn::Add(on_bc, right_bc);
      on_ca = hn::Add(on_ca, right_ca);
    }
    row_ab = hn::Add(row_ab, down_ab);
    row_bc = hn::Add(row_bc, down_bc);
    row_ca = hn::Add(row_ca, down_ca);
    u_row += parameters.stride;
    v_row += parameters.stride;
  }
}

/// Returns the first pixel whose centre lies on the right of an edge, or on the edge, in a row that
/// the edge crosses.
int first_pixel_on(const Vertex& a, const Vertex& b, int row) {
  const std::int64_t dx = b.x - a.x, dy = b.y - a.y, at = std::int64_t(row) * unit + half - a.y;
  const std::int64_t sign = dy < 0 ? -1 : 1;
  const std::int64_t over = sign * ((a.x - half) * dy + at * dx), under = sign * unit * dy;
  const std::int64_t quotient = over / under;
  return int(quotient + (over % under > 0));
}

/// Does as cover_small for triangles of any size.
template <bool folds>
void cover_large(const Vertex& a, const Vertex& b, const Vertex& c, std::int64_t area, Window box,
                 Parameters& parameters) {
  struct Slope {
    double along_x, along_y;
  };
  const auto slope = [&](float at_a, float at_b, float at_c) {
    const double to_b = double(at_b) - at_a, to_c = double(at_c) - at_a;
    return Slope{(to_b * (c.y - a.y) - to_c * (b.y - a.y)) / double(area),
                 (to_c * (b.x - a.x) - to_b * (c.x - a.x)) / double(area)};
  };
  const Slope du = slope(a.u, b.u, c.u), dv = slope(a.v, b.v, c.v);
  const hn::CappedTag<float, row_padding> d;
  const hn::RebindToSigned<decltype(d)> di;
  const auto u_step = hn::Set(d, float(du.along_x * unit));
  const auto v_step = hn::Set(d, float(dv.along_x * unit));
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0F);
  const std::array<std::array<const Vertex*, 2>, 3> edges{{{&a, &b}, {&b, &c}, {&c, &a}}};
  for (int y = box.y0; y < box.y1; ++y) {
    const int centre = y * unit + half;
    int first = INT32_MIN, last = INT32_MAX;
    for (const auto& [from, to] : edges) {
      if (from->y == to->y || centre < std::min(from->y, to->y) ||
          centre >= std::max(from->y, to->y))
        continue;
      // Clockwise: edges that run upwards have the triangle on their right.
      const int x = first_pixel_on(*from, *to, y);
      if (to->y < from->y)
        first = std::max(first, x);
      else
        last = std::min(last, x);
    }
    const int x0 = std::max(first, box.x0), x1 = std::min(last, box.x1);
    if (x0 >= x1) continue;
    // From the first pixel of the row, whether or not it lies in the box: what a pixel gets must
    // not depend on the window. In a sliver rounding could leave the patch.
    const double dx = double(std::int64_t(first) * unit + half - a.x), dy = centre - a.y;
    const auto u0 = hn::Set(d, float(a.u + du.along_x * dx + du.along_y * dy));
    const auto v0 = hn::Set(d, float(a.v + dv.along_x * dx + dv.along_y * dy));
    const std::size_t at = parameters.offset(x0, y);
    for (int i = 0; i < x1 - x0; i += int(hn::Lanes(d))) {
      const auto right = hn::ConvertTo(d, hn::Iota(di, x0 + i - first));
      const auto u = hn::Add(u0, hn::Mul(right, u_step)), v = hn::Add(v0, hn::Mul(right, v_step));
      const auto covered = hn::FirstN(d, std::size_t(x1 - x0 - i));
      store<folds>(d, hn::Min(hn::Max(u, zero), one), hn::Min(hn::Max(v, zero), one), covered,
                   parameters.u.data() + at + i, parameters.v.data() + at + i);
    }
  }
}

template <bool folds>
void cover_each(const FaceShape& shape, Parameters& parameters) {
  for (const Triangle& triangle : shape.triangles) {
    const Vertex& a = shape.vertices[triangle[0]];
    const Vertex* b = &shape.vertices[triangle[1]];
    const Vertex* c = &shape.vertices[triangle[2]];
    const int left = std::min({a.x, b->x, c->x}), right = std::max({a.x, b->x, c->x});
    const int top = std::min({a.y, b->y, c->y}), bottom = std::max({a.y, b->y, c->y});
    const Window box =
        Window{first_pixel(left), first_pixel(top), first_pixel(right), first_pixel(bottom)}
            .clipped(parameters.window);
    if (box.empty()) continue;
    std::int64_t area = doubled_area(a, *b, *c);
    if (area == 0) continue;
    if (area < 0) {
      std::swap(b, c);
      area = -area;
    }
    if (!is_small(right - left, bottom - top))
      cover_large<folds>(a, *b, *c, area, box, parameters);
    else if (box.width() <= 8)
      // NOLINTNEXTLINE(bugprone-branch-clone): the branches are equal on some vector units only.
      cover_small<folds>(hn::CappedTag<float, 8>(), a, *b, *c, area, box, parameters);
    else
      cover_small<folds>(hn::CappedTag<float, row_padding>(), a, *b, *c, area, box, parameters);
  }
}

void cover_all(const FaceShape& shape, Parameters& parameters) {
  if (shape.may_fold)
    cover_each<true>(shape, parameters);
  else
    cover_each<false>(shape, parameters);
}

}  // namespace
}  // namespace gradmesh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradmesh {

HWY_EXPORT(cover_all);

void cover(const FaceShape& shape, Parameters& parameters) {
  HWY_DYNAMIC_DISPATCH(cover_all)(shape, parameters);
}

}  // namespace gradmesh
#endif  // HWY_ONCE
