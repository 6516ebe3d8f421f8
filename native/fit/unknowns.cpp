#include "fit/unknowns.h"

#include <algorithm>
#include <map>

#include "ops/refresh.h"

namespace gradmesh {
namespace {

template <class Element>
void sort_once(std::vector<Element>& elements) {
  std::ranges::sort(elements);
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
}

bool has_color_tangents(const Mesh& mesh) { return mesh.color_model() == ColorModel::bicubic; }

void add_tangents(const Mesh& mesh, const std::vector<Face>& faces,
                  std::vector<Unknown>& unknowns) {
  std::vector<Halfedge> curves;
  for (const Face f : faces)
    for (const Halfedge h : mesh.sides(f)) curves.push_back(mesh.curve(h));
  sort_once(curves);
  for (const Halfedge curve : curves)
    for (const Handle handle : mesh[curve].handles)
      unknowns.push_back({Unknown::tangent, has_color_tangents(mesh), {}, curve, handle});
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

std::vector<Unknown> unknowns_of(const Mesh& mesh, const std::vector<Face>& faces) {
  std::vector<Unknown> unknowns;
  for (const Face f : faces)
    for (const Halfedge h : mesh.sides(f))
      unknowns.push_back({Unknown::twist, has_color_tangents(mesh), h});
  add_tangents(mesh, faces, unknowns);
  return unknowns;
}

void change(Journal& journal, const Unknown& unknown, const Value& by) {
  const Mesh& mesh = journal.mesh();
  switch (unknown.kind) {
    case Unknown::twist:
      journal.edit(unknown.corner).twist += by;
      return journal.touch(mesh.face(unknown.corner));
    case Unknown::tangent:
      journal.edit(unknown.handle).tangent += by;
      return refresh(journal, std::array{unknown.curve});
  }
}

std::vector<InfluencedFace> influences(Journal& journal, const std::vector<Unknown>& unknowns) {
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
    change(journal, unknown, unit);
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
