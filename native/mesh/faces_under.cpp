#include "mesh/faces_under.h"

namespace gradmesh {
namespace {

bool is_under(const Patch& patch, const FilledOutline& area) {
  constexpr int samples = 17;
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j) {
      const Value place = patch.at((i + 0.5) / samples, (j + 0.5) / samples);
      if (contains(area, place.position)) return true;
    }
  return false;
}

}  // namespace

std::vector<Face> faces_under(const Mesh& mesh, const FilledOutline& area) {
  std::vector<Face> faces;
  for (const Face f : mesh.faces())
    if (is_under(mesh.patch(f), area)) faces.push_back(f);
  return faces;
}

}  // namespace gradmesh
