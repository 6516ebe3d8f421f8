#include "session/session.h"

#include <stdexcept>
#include <string>

namespace gradmesh {

void Session::show(MeshKind kind, int state, bool moves_on) {
  curves().request(kind);
  const auto found = curves().found(kind);
  if (!found || state < 0 || std::size_t(state) >= found->curve.states.size())
    throw std::invalid_argument("the curve has no state " + std::to_string(state) + " yet.");
  const Mesh mesh = *found->curve.states[std::size_t(state)].mesh;
  Setting setting = shown_.setting_as(kind, state);
  setting.basis = setting.next;
  shown_.measure_in(setting);
  shown_.show(shown_.measured(mesh, kind), setting);
  if (!moves_on) shown_.record(Message("Move along the curve"));
}

}  // namespace gradmesh
