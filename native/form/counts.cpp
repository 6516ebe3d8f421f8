#include "form/counts.h"

#include "form/handles.h"

namespace gradmesh {

MeshCounts counts_of(const Mesh& surface) { return {count_handles(surface), surface.face_count()}; }

}  // namespace gradmesh
