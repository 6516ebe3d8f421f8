#include "raster/tessellate.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/clamped_int.h"

namespace gradmesh {
namespace {

using Points = Bicubic<glm::dvec2>;

/// How far triangles may be from the surface, in pixels, where the patch does not fold.
constexpr double coarseness = 0.7;
/// How far the cells of the grid may be from the surface elsewhere. Triangles along the outline can
/// be longer than a cell; their error takes the rest of the tenth of a pixel that is promised.
constexpr double fineness = 0.08;
constexpr int most_steps = 2048;

Points hermite_in_pixels(const Patch& patch, const Affine& to_pixels) {
  Points points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const bool is_corner = i % 3 == 0 && j % 3 == 0;
      const glm::dvec2 p = patch.c[i][j].position;
      points[i][j] = is_corner ? to_pixels.point(p) : to_pixels.vector(p);
    }
  return points;
}

/// Returns a bound of the derivative of the surface of order a along u and b along v, by the
/// differences of the Bezier points.
double most_derivative(Points p, int a, int b) {
  constexpr double factor[] = {1, 3, 6, 6};
  for (int n = 0; n < a; ++n)
    for (int i = 0; i + n < 3; ++i)
      for (int j = 0; j < 4; ++j) p[i][j] = p[i + 1][j] - p[i][j];
  double most = 0;
  for (int i = 0; i + a < 4; ++i) {
    for (int n = 0; n < b; ++n)
      for (int j = 0; j + n < 3; ++j) p[i][j] = p[i][j + 1] - p[i][j];
    for (int j = 0; j + b < 4; ++j) most = std::max(most, glm::dot(p[i][j], p[i][j]));
  }
  return factor[a] * factor[b] * std::sqrt(most);
}

/// Bounds of the second derivatives.
struct Bends {
  double uu, uv, vv;
};

Bends bends_of(const Points& p) {
  return {most_derivative(p, 2, 0), most_derivative(p, 1, 1), most_derivative(p, 0, 2)};
}

Window pixels_of(const Points& bezier) {
  glm::dvec2 low = bezier[0][0], high = low;
  for (const auto& row : bezier)
    for (const glm::dvec2 p : row) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  const SubpixelPoint first = snap(low), last = snap(high);
  return {first_pixel(first.x), first_pixel(first.y), first_pixel(last.x), first_pixel(last.y)};
}

void set_refinement(const Points& powers, const Bends& bends, const Folds& folds,
                    FaceShape& shape) {
  Refinement& refinement = shape.refinement;
  refinement.needed = true;
  refinement.everywhere = !shape.may_fold;
  for (int i = 0; i < Folds::cells; ++i) {
    refinement.cells[i] = 0;
    for (int j = 0; j < Folds::cells; ++j) refinement.cells[i] |= (folds.sign[i][j] != 0) << j;
  }
  const glm::dvec2 corner = glm::floor(glm::clamp(powers[0][0], -1e6, 1e6));
  refinement.x = clamped_pixel(corner.x);
  refinement.y = clamped_pixel(corner.y);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 2; ++k)
        refinement.position[k][i][j] = float(powers[i][j][k] - (i + j == 0 ? corner[k] : 0));
  refinement.most[2][0] = float(bends.uu);
  refinement.most[1][1] = float(bends.uv);
  refinement.most[0][2] = float(bends.vv);
}

/// Sets what interpolation along rows needs to know.
void set_sizes(const Points& bezier, Refinement& refinement) {
  const glm::dvec2 p00 = bezier[0][0], p03 = bezier[0][3], p30 = bezier[3][0], p33 = bezier[3][3];
  for (int a = 0; a <= 3; ++a)
    for (int b = std::max(0, 3 - a); b <= std::min(3, 4 - a); ++b)
      refinement.most[a][b] = float(most_derivative(bezier, a, b));
  // As if it were a parallelogram.
  const glm::dvec2 along_u = 0.5 * ((p30 - p00) + (p33 - p03));
  const glm::dvec2 along_v = 0.5 * ((p03 - p00) + (p33 - p30));
  const double area = along_u.x * along_v.y - along_u.y * along_v.x;
  const double scale =
      std::abs(area) > 1e-6 * (glm::dot(along_u, along_u) + glm::dot(along_v, along_v)) ? 1 / area
                                                                                        : 0;
  const glm::dvec2 centre =
      0.25 * ((p00 + p33) + (p03 + p30)) - glm::dvec2(refinement.x, refinement.y);
  const auto plane = [&](double b, double c) -> std::array<float, 3> {
    return {float(0.5 - (b * centre.x + c * centre.y)), float(b), float(c)};
  };
  refinement.start_u = plane(scale * along_v.y, -scale * along_v.x);
  refinement.start_v = plane(-scale * along_u.y, scale * along_u.x);
}

/// Fills the strip between two rows of vertices that run the same way, `outer` to their left.
/// `along(vertex)` is how far a vertex is along the strip.
template <class Along>
void add_strip(const std::vector<std::uint32_t>& outer, const std::vector<std::uint32_t>& inner,
               const Along& along, std::vector<Triangle>& triangles) {
  std::size_t i = 0, j = 0;
  while (i + 1 < outer.size() || j + 1 < inner.size()) {
    const bool step_outer = j + 1 == inner.size() ||
                            (i + 1 < outer.size() && along(outer[i]) + along(outer[i + 1]) <=
                                                         along(inner[j]) + along(inner[j + 1]));
    if (step_outer) {
      triangles.push_back({outer[i], outer[i + 1], inner[j]});
      ++i;
    } else {
      triangles.push_back({outer[i], inner[j + 1], inner[j]});
      ++j;
    }
  }
}

double widest_gap(const std::vector<double>& lines) {
  double widest = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) widest = std::max(widest, lines[i] - lines[i - 1]);
  return widest;
}

/// Numbers of cells of the grid that are needed along u and v.
struct Steps {
  double u, v;
};

/// Returns the steps that keep linear interpolation within the tolerance. Over a cell of hu x hv it
/// is off by at most (uu hu^2 + 2 uv hu hv + vv hv^2) / 8. Steps in the ratio of a to b share that
/// well between the two directions.
Steps steps_for(const Bends& bends, double tolerance) {
  const double a = std::sqrt(bends.uu + bends.uv + 1e-9), b = std::sqrt(bends.vv + bends.uv + 1e-9);
  const double bend = bends.uu / (a * a) + 2 * bends.uv / (a * b) + bends.vv / (b * b);
  const double scale = std::sqrt(bend / (8 * tolerance));
  return {a * scale, b * scale};
}

/// Sets the lines of the grid, at equal distances in each run of cells that are `fine` or not.
/// There is at least one line inside, as a grid needs a vertex inside.
void set_lines(const std::array<bool, Folds::cells>& fine, double fine_steps, double coarse_steps,
               std::vector<double>& lines) {
  lines.assign(1, 0);
  for (int end = 0, begin = 0; begin < Folds::cells; begin = end) {
    for (end = begin + 1; end < Folds::cells && fine[end] == fine[begin];) ++end;
    const double first = double(begin) / Folds::cells, length = double(end - begin) / Folds::cells;
    const double wanted = std::ceil(length * (fine[begin] ? fine_steps : coarse_steps));
    const int count = clamped_int(wanted, length < 1 ? 1 : 2, most_steps);
    for (int i = 1; i <= count; ++i) lines.push_back(first + length * (double(i) / count));
  }
}

/// Returns true if all triangles have the orientation of the patch, where that is known.
bool agrees(const FaceShape& shape, const Folds& folds) {
  for (const auto& [a, b, c] : shape.triangles) {
    const Vertex &p = shape.vertices[a], &q = shape.vertices[b], &r = shape.vertices[c];
    const int sign = folds.sign_at((p.u + q.u + r.u) / 3, (p.v + q.v + r.v) / 3);
    const std::int64_t area = doubled_area(p, q, r);
    // They run from v to u.
    if (sign > 0 ? area > 0 : sign < 0 && area < 0) return false;
  }
  return true;
}

void set_bounds(FaceShape& shape) {
  const Vertex& any = shape.vertices.front();
  SubpixelPoint low{any.x, any.y}, high = low;
  for (const Vertex& v : shape.vertices) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y)};
  }
  shape.bounds = {first_pixel(low.x), first_pixel(low.y), first_pixel(high.x), first_pixel(high.y)};
}

}  // namespace

void Tessellator::start(const Mesh& mesh, const Frame& frame) {
  mesh_ = &mesh;
  frame_ = &frame;
  outlines_.start(mesh, frame);
}

void Tessellator::tessellate(Face face, const Patch& patch, Window window, FaceShape& shape) {
  shape.vertices.clear();
  shape.triangles.clear();
  shape.spans.clear();
  shape.bounds = {};
  shape.traced = shape.may_fold = false;
  shape.refinement.needed = false;
  const Points hermite = hermite_in_pixels(patch, frame_->to_pixels);
  const Points bezier = change_form(hermite, bezier_of_hermite);
  // The outlines leave the patch by up to `flatness`.
  if (pixels_of(bezier).grown(1).clipped(window).empty()) return;

  const Points powers = change_form(hermite, powers_of_hermite);
  const Bends bends = bends_of(bezier);
  const Folds folds = folds_of(bezier);
  // u runs to the left of v where the Jacobian is positive.
  if (!folds.possible() && trace(face, folds.sign[0][0] < 0, shape)) {
    set_refinement(powers, bends, folds, shape);
    set_sizes(bezier, shape.refinement);
    set_bounds(shape);
    return;
  }
  const Steps coarse = steps_for(bends, coarseness), fine = steps_for(bends, fineness);
  std::array<bool, Folds::cells> fine_u = {}, fine_v = {};
  for (int i = 0; i < Folds::cells; ++i)
    for (int j = 0; j < Folds::cells; ++j)
      if (folds.sign[i][j] == 0) fine_u[i] = fine_v[j] = shape.may_fold = true;
  set_lines(fine_u, fine.u, coarse.u, lines_u_);
  set_lines(fine_v, fine.v, coarse.v, lines_v_);
  cut(face, powers, shape);
  if (agrees(shape, folds)) {
    const double hu = widest_gap(lines_u_), hv = widest_gap(lines_v_);
    if (bends.uu * hu * hu + 2 * bends.uv * hu * hv + bends.vv * hv * hv > 8 * fineness)
      set_refinement(powers, bends, folds, shape);
  } else {
    shape.may_fold = true;
    fine_u.fill(true);
    fine_v.fill(true);
    set_lines(fine_u, fine.u, coarse.u, lines_u_);
    set_lines(fine_v, fine.v, coarse.v, lines_v_);
    cut(face, powers, shape);
  }
  set_bounds(shape);
}

/// Returns the vertex of a cut of the k-th side of a patch.
Vertex Tessellator::vertex_on(int k, const Outlines::Cut& cut) {
  const double u = k == 0 ? 0 : k == 1 ? cut.t : k == 2 ? 1 : 1 - cut.t;
  const double v = k == 0 ? cut.t : k == 1 ? 1 : k == 2 ? 1 - cut.t : 0;
  return {cut.point.x, cut.point.y, float(u), float(v)};
}

bool Tessellator::trace(Face face, bool clockwise, FaceShape& shape) {
  polygon_.clear();
  shape.vertices.clear();
  const std::array<Halfedge, 4> sides = mesh_->sides(face);
  int top = INT_MAX, bottom = INT_MIN;
  for (int k = 0; k < 4; ++k)
    for (const Outlines::Cut& cut : outlines_.along(sides[k])) {
      shape.vertices.push_back(vertex_on(k, cut));
      polygon_.push_back(cut.point);
      top = std::min(top, cut.point.y);
      bottom = std::max(bottom, cut.point.y);
    }
  // Of the whole frame: how a face is painted must not depend on the window.
  shape.traced = tracer_.trace(polygon_, clockwise, std::max(first_pixel(top), 0),
                               std::min(first_pixel(bottom), frame_->height), shape.spans);
  return shape.traced;
}

void Tessellator::cut(Face face, const Points& powers, FaceShape& shape) {
  const int nu = int(lines_u_.size()) - 1, nv = int(lines_v_.size()) - 1;
  shape.vertices.clear();
  shape.triangles.clear();
  shape.vertices.reserve(std::size_t(nu) * nv);
  shape.triangles.reserve(2 * std::size_t(nu) * nv);
  for (int j = 1; j < nv; ++j) {
    const double v = lines_v_[j];
    std::array<glm::dvec2, 4> row;
    for (int i = 0; i < 4; ++i)
      row[i] = powers[i][0] + v * (powers[i][1] + v * (powers[i][2] + v * powers[i][3]));
    for (int i = 1; i < nu; ++i) {
      const double u = lines_u_[i];
      const SubpixelPoint p = snap(row[0] + u * (row[1] + u * (row[2] + u * row[3])));
      shape.vertices.push_back({p.x, p.y, float(u), float(v)});
    }
  }
  const std::array<Halfedge, 4> sides = mesh_->sides(face);
  for (int k = 0; k < 4; ++k) add_side(k, sides[k], shape);
  const auto inside = [&](int i, int j) { return std::uint32_t((j - 1) * (nu - 1) + (i - 1)); };
  for (int j = 1; j + 1 < nv; ++j)
    for (int i = 1; i + 1 < nu; ++i) {
      shape.triangles.push_back({inside(i, j), inside(i, j + 1), inside(i + 1, j)});
      shape.triangles.push_back({inside(i + 1, j + 1), inside(i + 1, j), inside(i, j + 1)});
    }
}

void Tessellator::add_side(int k, Halfedge leaf, FaceShape& shape) {
  const int nu = int(lines_u_.size()) - 1, nv = int(lines_v_.size()) - 1;
  outer_.clear();
  inner_.clear();
  for (const Outlines::Cut& cut : outlines_.along(leaf)) {
    outer_.push_back(std::uint32_t(shape.vertices.size()));
    shape.vertices.push_back(vertex_on(k, cut));
  }
  // From corner to corner of the inner grid, in the direction of the side.
  const int count = k % 2 == 0 ? nv - 1 : nu - 1;
  const int corner[4] = {0, (nv - 2) * (nu - 1), (nv - 1) * (nu - 1) - 1, nu - 2};
  const int step[4] = {nu - 1, 1, -(nu - 1), -1};
  for (int i = 0; i < count; ++i) inner_.push_back(std::uint32_t(corner[k] + i * step[k]));
  const float direction = k < 2 ? 1.f : -1.f;
  const auto along = [&](std::uint32_t i) {
    return direction * (k % 2 == 0 ? shape.vertices[i].v : shape.vertices[i].u);
  };
  add_strip(outer_, inner_, along, shape.triangles);
}

}  // namespace gradmesh
