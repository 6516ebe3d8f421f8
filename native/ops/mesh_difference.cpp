#include "ops/mesh_difference.h"

#include <algorithm>
#include <type_traits>

namespace gradmesh {

template <class Record>
std::vector<Record>& MeshDifference::records(Mesh& mesh) {
  if constexpr (std::is_same_v<Record, PointRecord>) return mesh.points_;
  if constexpr (std::is_same_v<Record, HandleRecord>) return mesh.handles_;
  if constexpr (std::is_same_v<Record, FaceRecord>) return mesh.faces_;
  if constexpr (std::is_same_v<Record, HalfedgeRecord>) return mesh.halfedges_;
}

MeshDifference::MeshDifference(const Mesh& before, const Mesh& after)
    : before_(header(before)), after_(header(after)) {
  const auto compare = [&]<class Record>(Part<Record>& part) {
    const std::vector<Record>&from = records<Record>(before), &to = records<Record>(after);
    const std::size_t common = std::min(from.size(), to.size());
    for (std::size_t i = 0; i < common; ++i) {
      if (from[i] == to[i]) continue;
      part.places.push_back(i);
      part.before.push_back(from[i]);
      part.after.push_back(to[i]);
    }
    part.before.insert(part.before.end(), from.begin() + std::ptrdiff_t(common), from.end());
    part.after.insert(part.after.end(), to.begin() + std::ptrdiff_t(common), to.end());
  };
  std::apply([&](auto&... part) { (compare(part), ...); }, parts_);
}

void MeshDifference::apply(Mesh& mesh, bool is_forward) const {
  const auto change = [&]<class Record>(const Part<Record>& part) {
    std::vector<Record>& all = records<Record>(mesh);
    const std::vector<Record>& from = is_forward ? part.before : part.after;
    const std::vector<Record>& to = is_forward ? part.after : part.before;
    const auto changed = std::ptrdiff_t(part.places.size());
    for (std::size_t i = 0; i < part.places.size(); ++i) all[part.places[i]] = to[i];
    all.resize(all.size() - (from.size() - part.places.size()));
    all.insert(all.end(), to.begin() + changed, to.end());
  };
  std::apply([&](const auto&... part) { (change(part), ...); }, parts_);
  const Header& is = is_forward ? after_ : before_;
  mesh.face_count_ = is.face_count;
  mesh.color_model_ = is.color_model;
  mesh.smooth_ = is.smooth;
}

std::size_t MeshDifference::bytes() const {
  std::size_t sum = sizeof *this;
  const auto add = [&]<class Record>(const Part<Record>& part) {
    sum += part.places.size() * sizeof(std::size_t) +
           (part.before.size() + part.after.size()) * sizeof(Record);
  };
  std::apply([&](const auto&... part) { (add(part), ...); }, parts_);
  return sum;
}

}  // namespace gradmesh
