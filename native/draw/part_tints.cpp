#include "draw/part_tints.h"

#include <algorithm>
#include <array>

#include "mesh/region.h"

namespace gradmesh {
namespace {

glm::dvec3 of_bytes(int r, int g, int b) { return glm::dvec3(r, g, b) / 255.0; }

const std::array<glm::dvec3, 6> colors{of_bytes(0x56, 0xb4, 0xe9), of_bytes(0xe6, 0x9f, 0x00),
                                       of_bytes(0x00, 0x9e, 0x73), of_bytes(0xcc, 0x79, 0xa7),
                                       of_bytes(0xf0, 0xe4, 0x42), of_bytes(0x00, 0x72, 0xb2)};

std::vector<int> parts_of_faces(const Mesh& mesh, const MotorcycleGraph& graph) {
  std::vector<int> part(mesh.face_slots(), -1);
  for (std::size_t i = 0; i < graph.parts.size(); ++i)
    for (const Halfedge edge : graph.parts[i])
      for (const Halfedge side : {edge, mesh[edge].twin})
        if (mesh.is_leaf(side)) part[mesh.face(side).value] = int(i);
  return part;
}

std::vector<int> tints(const Mesh& mesh, const std::vector<int>& part, std::size_t parts) {
  std::vector<std::vector<int>> beside(parts);
  for (const Halfedge h : mesh.halfedges()) {
    const Halfedge across = mesh.is_leaf(h) ? leaf_across(mesh, h) : Halfedge{};
    if (!across.valid()) continue;
    const int a = part[mesh.face(h).value], b = part[mesh.face(across).value];
    if (a > b && b >= 0) beside[a].push_back(b);
  }
  std::vector<int> tint(parts);
  for (std::size_t i = 0; i < parts; ++i) {
    std::array<bool, colors.size()> used{};
    for (const int other : beside[i]) used[tint[other]] = true;
    const auto free = std::ranges::find(used, false);
    tint[i] = free == used.end() ? int(i % used.size()) : int(free - used.begin());
  }
  return tint;
}

}  // namespace

const glm::dvec3 first_part_color = colors[0];

PartTints::PartTints(const Mesh& mesh, const MotorcycleGraph& graph)
    : part_(parts_of_faces(mesh, graph)), tint_(tints(mesh, part_, graph.parts.size())) {}

const glm::dvec3& PartTints::color(int part) const { return colors[tint_[std::size_t(part)]]; }

}  // namespace gradmesh
