#include "session/history.h"

namespace gradmesh {

std::size_t History::bytes() const {
  std::size_t sum = 0;
  for (const Step& step : steps_) sum += step.mesh.bytes();
  return sum;
}

void History::record(const Mesh& mesh, const Setting& setting, const Message& name) {
  if (mesh != mesh_ || !setting.is_like(setting_)) {
    steps_.erase(steps_.begin() + std::ptrdiff_t(done_), steps_.end());
    steps_.push_back({name, MeshDifference(mesh_, mesh), setting_, setting});
    done_ = steps_.size();
    mesh_ = mesh;
  }
  setting_ = setting;
}

void History::undo() {
  const Step& step = steps_[--done_];
  step.mesh.back(mesh_);
  setting_ = step.before;
}

void History::redo() {
  const Step& step = steps_[done_++];
  step.mesh.forward(mesh_);
  setting_ = step.after;
}

}  // namespace gradmesh
