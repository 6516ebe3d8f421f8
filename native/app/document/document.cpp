#include "app/document/document.h"

#include "simplify/options.h"

namespace gradmesh {

void Document::check_color_model(ColorModel model) const {
  if (!format().holds(model)) throw InputError(why_not(model));
}

Message Document::why_not(ColorModel model) const {
  return Message("{0}: {1} cannot hold colours of the model {2}.", name(), format().label,
                 gradmesh::name(model));
}

void Document::write(const std::vector<ChangedMesh>& meshes, MetricKind metric,
                     const WriteOptions& writing) {
  replace(meshes, metric, writing);
  changed_ = true;
}

}  // namespace gradmesh
