#pragma once

#include <string_view>

#include "base/message.h"
#include "form/counts.h"
#include "metric/metric.h"

namespace gradmesh {

/// Returns "Gradient mesh: 140 handles, 80 patches".
Message mesh_label(const MeshCounts& now);
/// Returns "Gradient mesh: 140 of 660 handles, 80 of 132 patches"; "Gradient mesh: 140 handles, 80
/// of 132 patches" if the number of handles before is 0, which stands for unknown.
Message mesh_label(const MeshCounts& now, const MeshCounts& before);
/// Returns "Gradient mesh: 140 of 660 handles, 80 of 132 patches, FLIP 0.0098".
Message mesh_label(const MeshCounts& now, const MeshCounts& before, MetricKind metric,
                   double error);

/// Returns whether a text begins as such labels do, in English or in another language.
bool is_mesh_label(std::string_view text, const Translation& language);

}  // namespace gradmesh
