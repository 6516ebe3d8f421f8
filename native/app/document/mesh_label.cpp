#include "app/document/mesh_label.h"

#include <cstdio>

namespace gradmesh {

Message mesh_label(const MeshCounts& now) {
  return Message("Gradient mesh: {0} handles, {1} patches", now.handles, now.patches);
}

Message mesh_label(const MeshCounts& now, const MeshCounts& before) {
  if (before.handles == 0)
    return Message("Gradient mesh: {0} handles, {1} of {2} patches", now.handles, now.patches,
                   before.patches);
  return Message("Gradient mesh: {0} of {1} handles, {2} of {3} patches", now.handles,
                 before.handles, now.patches, before.patches);
}

Message mesh_label(const MeshCounts& now, const MeshCounts& before, MetricKind metric,
                   double error) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.4f", error);
  return Message("{0}, {1} {2}", mesh_label(now, before), label(metric), digits);
}

bool is_mesh_label(std::string_view text, const Translation& language) {
  const Message any = mesh_label({});
  for (const std::string& label : {any.english(), any.in(language)}) {
    const std::string words = label.substr(0, label.find('0'));
    if (!words.empty() && text.starts_with(words)) return true;
  }
  return false;
}

}  // namespace gradmesh
