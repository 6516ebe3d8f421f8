#include "fit/plainness.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "form/handles.h"
#include "form/written_patch.h"
#include "mesh/dependence.h"
#include "ops/refresh.h"
#include "ops/straighten.h"
#include "reference/outlines.h"

namespace gradmesh {
namespace {

const double most_off_line = std::cos(glm::radians(179.0));

bool are_in_line(glm::dvec2 a, glm::dvec2 b) {
  const double lengths = glm::length(a) * glm::length(b);
  return lengths > 0 && glm::dot(a, b) <= most_off_line * lengths;
}

}  // namespace

Plainness::Plainness(const Mesh& mesh)
    : straight_(mesh.halfedge_slots(), false), coons_(mesh.face_slots(), false) {
  const double same = rounding_of(mesh);
  for (const Face f : mesh.faces())
    coons_[std::size_t(f.value)] = !needs_tensor(mesh.patch(f), same);
  std::vector<bool> is_fixed;
  for (const Point p : mesh.points()) {
    is_fixed.resize(std::size_t(p.value) + 1, false);
    is_fixed.back() = mesh[p].is_junction();
  }
  for (const Halfedge h : mesh.curves()) {
    straight_[std::size_t(h.value)] = gradmesh::is_straight(mesh.curve_of(h), same);
    for (const Point p : {mesh.origin(h), mesh.end(h)}) {
      curves_[p].push_back(h);
      if (is_outline(mesh, h)) is_fixed[std::size_t(p.value)] = true;
    }
  }
  is_fixed.flip();
  free_ = std::move(is_fixed);
  pair_handles(mesh);
}

/// Of several that lie in one line with a handle the first is its opposite.
void Plainness::pair_handles(const Mesh& mesh) {
  for (const auto& [point, curves] : curves_)
    for (std::size_t i = 0; i < curves.size(); ++i)
      for (std::size_t j = i + 1; j < curves.size(); ++j) {
        const Halfedge a = curves[i], b = curves[j];
        if (a == b || is_straight(a) || is_straight(b)) continue;
        const Handle at_a = mesh[a].handles[mesh.origin(a) == point ? 0 : 1];
        const Handle at_b = mesh[b].handles[mesh.origin(b) == point ? 0 : 1];
        if (opposites_.contains(at_a) || opposites_.contains(at_b)) continue;
        if (!are_in_line(mesh[at_a].tangent.position, mesh[at_b].tangent.position)) continue;
        opposites_[at_a] = {b, at_b};
        opposites_[at_b] = {a, at_a};
      }
}

std::optional<Plainness::Opposite> Plainness::opposite(Handle handle) const {
  const auto found = opposites_.find(handle);
  return found == opposites_.end() ? std::nullopt : std::optional(found->second);
}

const std::vector<Halfedge>& Plainness::curves_at(Point point) const { return curves_.at(point); }

void Plainness::refresh(Journal& journal, std::span<const Halfedge> changed_curves) const {
  const Mesh& mesh = journal.mesh();
  for (const Halfedge curve : in_order_of_dependence(mesh, changed_curves)) {
    if (is_straight(curve)) straighten(journal, curve);
    refresh_curve(journal, curve);
  }
  if (!coons_.empty()) keep_coons(journal, journal.depth() - 1);
}

void Plainness::keep_coons(Journal& journal, std::size_t depth) const {
  for (const Face f : journal.touched_since(depth))
    if (is_coons(f) && journal.mesh()[f].alive) drop_tensor(journal, f);
}

}  // namespace gradmesh
