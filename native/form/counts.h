#pragma once

#include "mesh/mesh.h"

namespace gradmesh {

/// What can be counted of a mesh, and made few.
enum class Count { handles, patches };

/// How many of each a mesh has.
struct MeshCounts {
  /// As of count_handles.
  int handles = 0;
  int patches = 0;

  int operator[](Count what) const { return what == Count::handles ? handles : patches; }
};

/// At most how many of what a mesh may have in the end.
struct Target {
  Count what = Count::patches;
  int most = 0;

  bool is_reached(const MeshCounts& counts) const { return counts[what] <= most; }
};

/// Returns the counts of a mesh as a reader finds it (WrittenForm).
MeshCounts counts_of(const Mesh& surface);

}  // namespace gradmesh
