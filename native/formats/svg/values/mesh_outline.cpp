#include "formats/svg/values/mesh_outline.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "form/block_outline.h"
#include "formats/text/number.h"
#include "geom/convex_hull.h"
#include "geom/fold.h"
#include "mesh/boundary.h"

namespace gradmesh {
namespace {

using Loop = std::vector<Cubic<Value>>;

double doubled_area_of(const Loop& loop) {
  constexpr int steps = 8;
  std::vector<glm::dvec2> polygon;
  for (const Cubic<Value>& curve : loop)
    for (int i = 0; i < steps; ++i) polygon.push_back(curve.at(double(i) / steps).position);
  return doubled_area(polygon);
}

Loop reversed(const Loop& loop) {
  Loop result;
  std::transform(loop.rbegin(), loop.rend(), std::back_inserter(result),
                 [](const Cubic<Value>& curve) { return curve.reversed(); });
  return result;
}

std::string path_data(const Loop& loop) {
  std::string d = "M " + format_point(loop.front().p0.position);
  for (const Cubic<Value>& curve : loop)
    d += " C " + format_point(curve.bezier1().position) + " " +
         format_point(curve.bezier2().position) + " " + format_point(curve.p1.position);
  return d + " Z";
}

Loop loop_of(const Mesh& mesh, Face face) {
  Loop loop;
  for (const Halfedge side : mesh.sides(face)) loop.push_back(mesh.side_of(side));
  return loop;
}

std::string clockwise_path(const Loop& loop) {
  return path_data(doubled_area_of(loop) < 0 ? reversed(loop) : loop);
}

/// Adds a path to others.
void add(std::string& paths, const std::string& path) {
  if (!paths.empty()) paths += ' ';
  paths += path;
}

/// Returns the convex polygon around a patch: its control points hold it.
std::string hull_path(const Patch& patch) {
  std::vector<glm::dvec2> points;
  for (const auto& row : bezier_net(patch))
    for (const Value& point : row) points.push_back(point.position);
  std::string d;
  for (const glm::dvec2 corner : convex_hull(std::move(points)))
    d += (d.empty() ? "M " : " L ") + format_point(corner);
  return d + " Z";
}

}  // namespace

std::string outline_path(const Mesh& mesh) {
  const std::vector<int> component = face_components(mesh);
  std::map<int, std::vector<Loop>> outlines;
  for (const std::vector<Halfedge>& leaves : boundary_loops(mesh)) {
    Loop loop;
    for (const Halfedge h : leaves) loop.push_back(mesh.side_of(h));
    outlines[component[mesh.face(leaves.front()).value]].push_back(std::move(loop));
  }
  // Faces of one component go round the same way, those of another perhaps not; where the two lie
  // over one another their turns must not cancel.
  std::string d;
  for (const auto& [number, loops] : outlines) {
    double area = 0;
    for (const Loop& loop : loops) area += doubled_area_of(loop);
    for (const Loop& loop : loops) add(d, path_data(area < 0 ? reversed(loop) : loop));
  }
  return d;
}

std::string patches_path(const Mesh& mesh) {
  std::string d;
  for (const Face face : mesh.faces()) add(d, clockwise_path(loop_of(mesh, face)));
  return d;
}

std::string covering_path(const Mesh& mesh) {
  const std::vector<int> component = face_components(mesh);
  // By component, which way its faces go round.
  std::map<int, bool> turns;
  bool lies_over_itself = false;
  std::string d;
  for (const Face face : mesh.faces()) {
    const Loop loop = loop_of(mesh, face);
    const Patch patch = mesh.patch(face);
    const bool is_clockwise = doubled_area_of(loop) >= 0, is_folded = folds(patch);
    const auto first = turns.try_emplace(component[face.value], is_clockwise).first;
    lies_over_itself = lies_over_itself || is_folded || first->second != is_clockwise;
    add(d, is_folded ? hull_path(patch) : clockwise_path(loop));
  }
  return lies_over_itself ? d : outline_path(mesh);
}

}  // namespace gradmesh
