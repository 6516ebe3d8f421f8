#include "app/document/svg_rules.h"

#include "base/error.h"
#include "formats/svg/gradient/rows.h"
#include "mesh/build.h"
#include "raster/overlaps.h"

namespace gradmesh {
namespace {

/// Builds the mesh. Throws InputError if the mesh, in the coordinates in which it is written, is
/// one that the readers refuse: handles grow as patches are merged.
Mesh readable_mesh(MeshParts parts, const Affine& to_written = {}) {
  Mesh mesh = build_mesh(parts);
  for (Patch& patch : parts.patches) {
    transform(patch, to_written);
    if (!is_within_limits(patch))
      throw InputError("its mesh would reach beyond 5e8 user units when it is written.");
  }
  return mesh;
}

class BlockRules : public WritingRules {
 public:
  explicit BlockRules(bool has_step) : has_step_(has_step) {}

  WrittenForm form(const Mesh& mesh, const Frame& frame) const override {
    const double tolerance = coons_tolerance(frame);
    BlockForm blocks = block_form(mesh, tolerance, find_overlaps(mesh, frame));
    if (!has_step_) blocks.precision.step = 0;
    Mesh surface = readable_mesh(block_parts(mesh, blocks));
    return {std::move(surface), std::move(blocks)};
  }
  bool are_like(const WritingRules& other) const override {
    const auto* const blocks = dynamic_cast<const BlockRules*>(&other);
    return blocks && blocks->has_step_ == has_step_;
  }
  bool may_mask_opacity() const override { return true; }

 private:
  const bool has_step_;
};

class GradientRules : public WritingRules {
 public:
  explicit GradientRules(const Affine& to_gradient) : to_gradient_(to_gradient) {}

  WrittenForm form(const Mesh& mesh, const Frame& frame) const override {
    const BlockForm one = gradient_form(mesh, coons_tolerance(frame), to_gradient_);
    return {readable_mesh(block_parts(mesh, one), to_gradient_)};
  }
  bool are_like(const WritingRules& other) const override {
    const auto* const gradient = dynamic_cast<const GradientRules*>(&other);
    return gradient && gradient->to_gradient_ == to_gradient_;
  }

 private:
  const Affine to_gradient_;
};

}  // namespace

std::shared_ptr<const WritingRules> block_rules() { return std::make_shared<BlockRules>(true); }

std::shared_ptr<const WritingRules> exact_block_rules() {
  return std::make_shared<BlockRules>(false);
}

std::shared_ptr<const WritingRules> gradient_rules(const Affine& to_gradient) {
  return std::make_shared<GradientRules>(to_gradient);
}

}  // namespace gradmesh
