#include "reference/original.h"

#include <utility>

#include "mesh/mesh_hash.h"

namespace gradmesh {
namespace {

class OriginalMesh final : public Original {
 public:
  explicit OriginalMesh(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)) {}

  Frame frame(const Affine& view, int resolution, const FramePadding& padding) const override {
    return fit_frame(*mesh_, view, resolution, padding);
  }
  void paint(const Frame& frame, Painting& painting) const override {
    paint_whole(*mesh_, frame, painting);
  }
  bool is_translucent() const override { return gradmesh::is_translucent(*mesh_); }
  OutlinePoints outlines(const Frame& frame) const override { return {*mesh_, frame}; }
  std::uint64_t hash() const override {
    Hash hash;
    add(hash, *mesh_);
    return hash.value();
  }
  std::shared_ptr<const Mesh> mesh() const override { return mesh_; }

 private:
  const std::shared_ptr<const Mesh> mesh_;
};

}  // namespace

Painting Original::painted(const Frame& frame) const {
  Painting painting(frame.window());
  paint(frame, painting);
  return painting;
}

std::shared_ptr<const Original> original_of(std::shared_ptr<const Mesh> mesh) {
  return mesh ? std::make_shared<OriginalMesh>(std::move(mesh)) : nullptr;
}

}  // namespace gradmesh
