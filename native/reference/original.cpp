#include "reference/original.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "mesh/mesh_hash.h"
#include "raster/seen_areas.h"
#include "reference/paint_picture.h"

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

class OriginalPicture final : public Original {
 public:
  OriginalPicture(RgbaImage picture, const Affine& to_units)
      : picture_(std::move(picture)), to_units_(to_units) {
    if (picture_.pixels() == 0) throw std::invalid_argument("a picture has a pixel or more.");
    const double area = to_units.determinant();
    if (!(std::isfinite(area) && area != 0))
      throw std::invalid_argument("the place of a picture has an area.");
  }

  Frame frame(const Affine& view, int resolution, const FramePadding& padding) const override {
    const Affine to_view = view * to_units_;
    Box box;
    for (const double x : {0, picture_.width})
      for (const double y : {0, picture_.height}) box.add(to_view.point({x, y}));
    return fit_frame(box, view, resolution, padding);
  }
  void paint(const Frame& frame, Painting& painting) const override {
    paint_picture(picture_, to_units_, frame, painting);
  }
  bool is_translucent() const override {
    const std::uint8_t* const opacities = picture_.samples.data() + 3 * picture_.pixels();
    return std::any_of(opacities, opacities + picture_.pixels(),
                       [](std::uint8_t opacity) { return opacity < 255; });
  }
  /// A picture knows no curves.
  OutlinePoints outlines(const Frame&) const override { return {}; }
  std::uint64_t hash() const override {
    Hash hash;
    hash.add(picture_.width);
    hash.add(picture_.height);
    const auto* const bytes = reinterpret_cast<const char*>(picture_.samples.data());
    hash.add(std::string_view(bytes, picture_.samples.size()));
    for (const glm::dvec2 v : {to_units_.linear[0], to_units_.linear[1], to_units_.offset})
      for (int i = 0; i < 2; ++i) hash.add(v[i]);
    return hash.value();
  }
  bool is_picture() const override { return true; }

 private:
  const RgbaImage picture_;
  const Affine to_units_;
};

class OriginalWithAreas final : public Original {
 public:
  OriginalWithAreas(std::shared_ptr<const Original> base, std::shared_ptr<const Mesh> mesh,
                    const std::vector<FilledOutline>& areas)
      : base_(std::move(base)), mesh_(original_of(std::move(mesh))) {
    for (const FilledOutline& area : areas) areas_.push_back({area, {}});
  }

  Frame frame(const Affine& view, int resolution, const FramePadding& padding) const override {
    return base_->frame(view, resolution, padding);
  }
  void paint(const Frame& frame, Painting& painting) const override {
    base_->paint(frame, painting);
    Painting other(painting.window());
    mesh_->paint(frame, other);
    const std::vector<int> seen = seen_areas(areas_, frame);
    const auto [x0, y0, x1, y1] = painting.window();
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x)
        if (seen[std::size_t(y) * std::size_t(frame.width) + std::size_t(x)] >= 0)
          copy(other, {x, y, x + 1, y + 1}, painting);
  }
  bool is_translucent() const override {
    return base_->is_translucent() || mesh_->is_translucent();
  }
  /// A border that was edited lies elsewhere than that of the base; another one hardly does.
  OutlinePoints outlines(const Frame& frame) const override { return mesh_->outlines(frame); }
  std::uint64_t hash() const override {
    Hash hash;
    hash.add(base_->hash());
    hash.add(mesh_->hash());
    for (const FlatArea& area : areas_)
      for (const std::vector<glm::dvec2>& polygon : area.area.outline)
        for (const glm::dvec2 point : polygon)
          for (int i = 0; i < 2; ++i) hash.add(point[i]);
    return hash.value();
  }
  bool is_picture() const override { return base_->is_picture(); }

 private:
  const std::shared_ptr<const Original> base_, mesh_;
  /// Without colours.
  std::vector<FlatArea> areas_;
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

std::shared_ptr<const Original> original_of(RgbaImage picture, const Affine& to_units) {
  return std::make_shared<OriginalPicture>(std::move(picture), to_units);
}

std::shared_ptr<const Original> with_areas(std::shared_ptr<const Original> base,
                                           std::shared_ptr<const Mesh> mesh,
                                           const std::vector<FilledOutline>& areas) {
  return std::make_shared<OriginalWithAreas>(std::move(base), std::move(mesh), areas);
}

}  // namespace gradmesh
