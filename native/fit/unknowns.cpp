#include "fit/unknowns.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

namespace gradmesh {
namespace {

template <class Element>
void sort_once(std::vector<Element>& elements) {
  std::ranges::sort(elements);
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
}

bool has_color_tangents(const Mesh& mesh) { return mesh.color_model() == ColorModel::bicubic; }

void add_tangents(const Mesh& mesh, const std::vector<Face>& faces, const Plainness& plain,
                  std::vector<Unknown>& unknowns) {
  std::vector<Halfedge> curves;
  for (const Face f : faces)
    for (const Halfedge h : mesh.sides(f)) curves.push_back(mesh.curve(h));
  sort_once(curves);
  for (const Halfedge curve : curves) {
    if (plain.is_straight(curve)) continue;
    for (const Handle handle : mesh[curve].handles) {
      Unknown unknown{Unknown::tangent, has_color_tangents(mesh), {}, curve, handle};
      unknown.opposite = plain.opposite(handle);
      if (unknown.opposite) {
        const Handle other = unknown.opposite->handle;
        // The other one of the two is no unknown of its own.
        if (other < handle && std::ranges::binary_search(curves, unknown.opposite->curve)) continue;
        const double a = glm::length(mesh[handle].tangent.position);
        const double b = glm::length(mesh[other].tangent.position);
        unknown.share = 2 * a / (a + b);
        unknown.opposite_share = 2 * b / (a + b);
      }
      unknowns.push_back(unknown);
    }
  }
}

void add_points(const Mesh& mesh, const std::vector<Face>& faces, const Plainness& plain,
                std::vector<Unknown>& unknowns) {
  std::vector<Point> points;
  for (const Face f : faces)
    for (const Halfedge h : mesh.sides(f))
      if (plain.is_free(mesh.origin(h))) points.push_back(mesh.origin(h));
  sort_once(points);
  for (const Point p : points) {
    Unknown unknown{Unknown::place, false};
    unknown.moved = p;
    unknowns.push_back(unknown);
  }
}

/// Changes an unknown and nothing that depends on it. Adds the curves that change to `changed`.
void change_alone(Journal& journal, const Unknown& unknown, const Value& by, const Plainness& plain,
                  std::vector<Halfedge>& changed) {
  const Mesh& mesh = journal.mesh();
  switch (unknown.kind) {
    case Unknown::twist:
      journal.edit(unknown.corner).twist += by;
      return journal.touch(mesh.face(unknown.corner));
    case Unknown::tangent:
      journal.edit(unknown.handle).tangent += unknown.share * by;
      changed.push_back(unknown.curve);
      if (!unknown.opposite) return;
      journal.edit(unknown.opposite->handle).tangent += -unknown.opposite_share * by;
      return changed.push_back(unknown.opposite->curve);
    case Unknown::place:
      journal.edit(unknown.moved).position += by.position;
      const std::vector<Halfedge>& curves = plain.curves_at(unknown.moved);
      changed.insert(changed.end(), curves.begin(), curves.end());
  }
}

/// Returns the influence of an unknown on a patch that is `before` without, and `after` with, a
/// unit step of the unknown.
Influence influence(int number, const Unknown& unknown, const Patch& before, const Patch& after) {
  Influence result{number, {}, {}};
  for (std::size_t k = 0; k < 16; ++k) {
    const Value change = after.c[k / 4][k % 4] - before.c[k / 4][k % 4];
    result.place[k] = change.position.x;
    if (unknown.moves_color) result.color[k] = change.color.r;
  }
  return result;
}

bool is_zero(const Influence& influence) {
  const auto zero = [](double d) { return d == 0; };
  return std::ranges::all_of(influence.place, zero) && std::ranges::all_of(influence.color, zero);
}

}  // namespace

std::vector<Unknown> unknowns_of(const Mesh& mesh, const std::vector<Face>& faces,
                                 const Plainness& plain) {
  std::vector<Unknown> unknowns;
  for (const Face f : faces)
    if (!plain.is_coons(f))
      for (const Halfedge h : mesh.sides(f))
        unknowns.push_back({Unknown::twist, has_color_tangents(mesh), h});
  add_tangents(mesh, faces, plain, unknowns);
  add_points(mesh, faces, plain, unknowns);
  return unknowns;
}

void change(Journal& journal, std::span<const Unknown> unknowns, std::span<const Value> by,
            const Plainness& plain) {
  std::vector<Halfedge> changed;
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    change_alone(journal, unknowns[i], by[i], plain, changed);
  sort_once(changed);
  plain.refresh(journal, changed);
}

std::vector<InfluencedFace> influences(Journal& journal, const std::vector<Unknown>& unknowns,
                                       const Plainness& plain) {
  // A unit step of each unknown shows its column, as the mesh is linear in it; x represents y and
  // red for the other colours.
  const Value unit{glm::dvec2(1.0, 0.0), glm::dvec4(1.0, 0.0, 0.0, 0.0)};
  const Mesh& mesh = journal.mesh();
  const std::size_t depth = journal.depth();
  std::map<Face, std::vector<Influence>> found;
  std::vector<Patch> after;
  for (int i = 0; i < int(unknowns.size()); ++i) {
    const Unknown& unknown = unknowns[std::size_t(i)];
    journal.begin();
    change(journal, std::span(&unknown, 1), std::span(&unit, 1), plain);
    const std::vector<Face> touched = journal.touched_since(depth);
    after.clear();
    for (const Face f : touched) after.push_back(mesh.patch(f));
    journal.undo();
    for (std::size_t k = 0; k < touched.size(); ++k) {
      const Influence by = influence(i, unknown, mesh.patch(touched[k]), after[k]);
      if (!is_zero(by)) found[touched[k]].push_back(by);
    }
  }
  std::vector<InfluencedFace> faces;
  for (auto& [face, by] : found) faces.push_back({face, std::move(by)});
  return faces;
}

}  // namespace gradmesh
