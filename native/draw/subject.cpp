#include "draw/subject.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "mesh/boundary.h"

namespace gradmesh {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Subject::Subject(const Mesh& mesh, const Affine& view, Translation translation)
    : mesh_(mesh),
      view_(view),
      translation_(std::move(translation)),
      box_(bounding_box(mesh, view)) {
  std::vector<double> widths;
  for (const Face f : mesh.faces()) widths.push_back(narrowness(f));
  unit_ = 0.01 * std::max(box_.size().x, box_.size().y);
  line_width_ = std::clamp(0.03 * median(std::move(widths)), 0.11 * unit_, 0.2 * unit_);
}

std::string Subject::curve(Halfedge side) const {
  const Cubic<Value> c = mesh_.curve_of(side);
  PathText text = path();
  text.move(c.p0.position);
  text.curve(c);
  return text.text();
}

std::string Subject::outline(Face face) const {
  PathText text = path();
  const std::array<Halfedge, 4> sides = mesh_.sides(face);
  text.move(mesh_.position(mesh_.origin(sides[0])));
  for (const Halfedge h : sides) text.curve(mesh_.side_of(h));
  text.close();
  return text.text();
}

glm::dvec2 Subject::center(Face face) const {
  constexpr int steps = 8;
  std::vector<glm::dvec2> around;
  for (const Halfedge h : mesh_.sides(face)) {
    const Cubic<Value> side = mesh_.side_of(h);
    for (int i = 0; i < steps; ++i) around.push_back(point(side.at(double(i) / steps).position));
  }
  const glm::dvec2 inside = point(mesh_.patch(face).at(0.5, 0.5).position);
  double area = 0;
  glm::dvec2 moment(0);
  for (std::size_t i = 0; i < around.size(); ++i) {
    const glm::dvec2 a = around[i] - inside, b = around[(i + 1) % around.size()] - inside;
    const double twice = a.x * b.y - a.y * b.x;
    area += twice;
    moment += twice * (a + b) / 3.0;
  }
  return area == 0 ? inside : inside + moment / area;
}

double Subject::narrowness(Face face) const {
  const Patch patch = mesh_.patch(face);
  const auto across = [&](double u0, double v0, double u1, double v1) {
    return glm::distance(point(patch.at(u0, v0).position), point(patch.at(u1, v1).position));
  };
  return std::min(across(0, 0.5, 1, 0.5), across(0.5, 0, 0.5, 1));
}

Drawing blank_drawing(const Subject& subject) {
  Drawing drawing;
  const glm::dvec2 margin(3 * subject.unit());
  drawing.box.add(subject.box().low() - margin);
  drawing.box.add(subject.box().high() + margin);
  return drawing;
}

}  // namespace gradmesh
