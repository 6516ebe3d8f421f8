#include "app/pages/page_shapes.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <numbers>

#include "formats/svg/values/mesh_outline.h"
#include "formats/text/number.h"
#include "mesh/boundary.h"

namespace gradmesh {
namespace {

/// The width in pixels of a line of width 0, which PDF shows as thin as can be seen, and SVG not at
/// all.
constexpr double thinnest_line = 1;

Box box_of(const PagePath& path) {
  Box box;
  for (const PagePath::Step& step : path.steps)
    for (const glm::dvec2 point : step.points) box.add(point);
  return box;
}

/// Returns a box that holds all that a stroke paints; of its curves it is the exact one, since
/// programs clip by boxes that are hardly larger.
Box box_of(const PageStroke& stroke) {
  const auto& [path, line, pen] = stroke;
  Box curves;
  glm::dvec2 here(0.0);
  for (const auto& [kind, points] : path.steps) {
    if (kind == PagePath::Step::Kind::curve)
      curves.add_cubic(here, points[0], points[1], points[2]);
    else
      curves.add(points[2]);
    here = points[2];
  }
  const double corner = line.cap == LineCap::square ? std::numbers::sqrt2 : 1;
  const double reach = line.join == LineJoin::miter ? std::max(corner, line.miter_limit) : corner;
  const double least = thinnest_line / pixels_per_point;
  // As far as the ellipse reaches that the pen is.
  const glm::dmat2 rows = glm::transpose(pen.linear);
  const glm::dvec2 pen_reach(glm::length(rows[0]), glm::length(rows[1]));
  const glm::dvec2 margin = 0.5 * reach * std::max(line.width, least) * pen_reach;
  Box box;
  box.add(curves.low() - margin);
  box.add(curves.high() + margin);
  return box;
}

/// Returns true if the path is one rectangle along the axes.
bool is_box(const PagePath& path) {
  using Kind = PagePath::Step::Kind;
  std::vector<glm::dvec2> corners;
  for (const auto& [kind, points] : path.steps) {
    if (kind == Kind::curve || (kind == Kind::move && !corners.empty())) return false;
    if (kind != Kind::close && (corners.empty() || corners.back() != points[2]))
      corners.push_back(points[2]);
  }
  if (corners.size() == 5 && corners.back() == corners.front()) corners.pop_back();
  if (corners.size() != 4) return false;
  const bool starts_along_x = corners[0].y == corners[1].y;
  for (std::size_t k = 0; k < 4; ++k) {
    const glm::dvec2 side = corners[(k + 1) % 4] - corners[k];
    if (((k % 2 == 0) == starts_along_x ? side.y : side.x) != 0) return false;
  }
  return true;
}

/// Returns true if a clip path shows all that lies in the box, up to rounding.
bool shows_all(const PagePath& path, const Box& box) {
  constexpr double rounding = 0.01;
  if (!is_box(path)) return false;
  const Box seen = box_of(path);
  return seen.low().x <= box.low().x + rounding && seen.low().y <= box.low().y + rounding &&
         seen.high().x >= box.high().x - rounding && seen.high().y >= box.high().y - rounding;
}

PagePath mapped(PagePath path, const Affine& map) {
  for (PagePath::Step& step : path.steps)
    for (glm::dvec2& point : step.points) point = map.point(point);
  return path;
}

}  // namespace

std::string path_data(const PagePath& path) {
  const auto point = [](glm::dvec2 at) {
    return format_number(pixels_per_point * at.x) + "," + format_number(pixels_per_point * at.y);
  };
  std::string data;
  for (const auto& [kind, points] : path.steps) {
    if (!data.empty()) data += ' ';
    switch (kind) {
      case PagePath::Step::Kind::move:
        data += "M" + point(points[2]);
        break;
      case PagePath::Step::Kind::line:
        data += "L" + point(points[2]);
        break;
      case PagePath::Step::Kind::curve:
        data += "C" + point(points[0]) + " " + point(points[1]) + " " + point(points[2]);
        break;
      case PagePath::Step::Kind::close:
        data += "Z";
        break;
    }
  }
  return data;
}

std::vector<SvgShape> shapes_of(const Mesh& mesh, const Clips& clips, const PageStroke* stroke) {
  const Affine to_points = Affine::scaling(glm::dvec2(1 / pixels_per_point));
  Box box = bounding_box(mesh, stroke ? stroke->pen * to_points : to_points);
  if (stroke) {
    box = overlap(box, box_of(*stroke));
    if (box.empty()) return {};
  }
  std::vector<SvgShape> shapes;
  for (auto clip = clips.rbegin(); clip != clips.rend(); ++clip) {
    const Box seen = box_of(**clip);
    if (seen.empty() || !(seen.size().x > 0) || !(seen.size().y > 0) || overlap(seen, box).empty())
      return {};
    if (shows_all(**clip, box)) continue;
    SvgShape shape{path_data(**clip), (*clip)->rule};
    const bool is_there = std::ranges::any_of(
        shapes, [&](const SvgShape& s) { return s.path == shape.path && s.rule == shape.rule; });
    if (!is_there) shapes.push_back(std::move(shape));
  }
  if (stroke)
    shapes.insert(shapes.begin(), {path_data(mapped(stroke->path, stroke->pen.inverse()))});
  else if (shapes.empty())
    shapes.push_back({covering_path(mesh)});
  return shapes;
}

SvgStroke svg_stroke(const LineStyle& line) {
  static constexpr std::array<const char*, 3> caps{"butt", "round", "square"};
  static constexpr std::array<const char*, 3> joins{"miter", "round", "bevel"};
  SvgStroke stroke{.width = line.width > 0 ? pixels_per_point * line.width : thinnest_line,
                   .cap = caps[std::size_t(line.cap)],
                   .join = joins[std::size_t(line.join)],
                   .miter_limit = line.miter_limit,
                   .dash_offset = pixels_per_point * line.dash_phase};
  for (const double length : line.dashes) stroke.dashes.push_back(pixels_per_point * length);
  return stroke;
}

}  // namespace gradmesh
