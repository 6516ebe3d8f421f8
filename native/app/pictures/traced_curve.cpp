#include "app/pictures/traced_curve.h"

#include <memory>
#include <utility>

#include "simplify/options.h"

namespace gradmesh {

Curve traced_curve(std::vector<Mesh> meshes, const PartTracer& tracer) {
  Curve curve;
  for (Mesh& mesh : meshes) {
    const PictureErrors errors = tracer.errors_without_detail(mesh);
    CurveState& state = curve.states.emplace_back();
    state.counts = counts_of(mesh);
    state.error = errors.flip;
    state.local_error = errors.local_flip;
    state.mesh = std::make_shared<const Mesh>(std::move(mesh));
  }
  for (const Amount& amount : all_amounts())
    for (std::size_t n = curve.states.size(); n-- > 0;)
      if (curve.states[n].error <= amount.traced_epsilon) {
        curve.marks.push_back({amount.name, int(n)});
        break;
      }
  return curve;
}

}  // namespace gradmesh
