#include "app/picture_part.h"

#include <algorithm>

#include "base/clamped_int.h"
#include "files/box_reducer.h"
#include "mesh/build.h"
#include "trace/shape_target.h"
#include "trace/traced_grid.h"

namespace gradmesh {
namespace {

glm::dvec2 pixels_of(const RgbaImage& image) { return {image.width, image.height}; }

/// Returns the picture without what is smaller than `detail` pixels of the page.
RgbaImage without_detail(const RgbaImage& picture, glm::dvec2 page, double detail) {
  const int longest = std::max(picture.width, picture.height);
  const double wanted = std::max(page.x, page.y) / detail;
  if (wanted >= longest) return picture;
  BoxReducer reducer(picture.width, picture.height, clamped_int(wanted + 0.5, 1, longest));
  std::vector<std::uint16_t> row(4 * std::size_t(picture.width));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x)
      for (int k = 0; k < 4; ++k)
        row[std::size_t(4 * x + k)] = std::uint16_t(257 * *picture.at(x, y, k));
    reducer.add_row(row.data());
  }
  return reducer.image();
}

/// Returns a narrow picture with each pixel repeated, so that a mesh has the colour of a pixel all
/// over it, and not only where it is looked at.
RgbaImage with_wide_pixels(const RgbaImage& picture) {
  constexpr int narrow = 8;
  const int times = (narrow + std::min(picture.width, picture.height) - 1) /
                    std::min(picture.width, picture.height);
  if (times == 1) return picture;
  RgbaImage wide(times * picture.width, times * picture.height);
  for (int y = 0; y < wide.height; ++y)
    for (int x = 0; x < wide.width; ++x) wide.set_pixel(x, y, picture.pixel(x / times, y / times));
  return wide;
}

Mesh mesh_of(const LineGrid& grid, const Affine& place) {
  MeshParts parts = grid.parts();
  transform(parts, place);
  return build_mesh(parts);
}

}  // namespace

PartTracer::PartTracer(PicturePart part, const PartOptions& options)
    : part_(std::move(part)),
      options_(options),
      followed_(without_detail(part_.image, part_.size, options.detail)),
      exact_(compared_with(part_.image)),
      coarse_(compared_with(followed_)) {}

PictureComparison PartTracer::compared_with(const RgbaImage& image) const {
  const Affine to_pixels = Affine::scaling(pixels_of(image) / part_.size);
  std::vector<float> counted;
  if (part_.shape)
    counted = counted_pixels(mapped(*part_.shape, to_pixels), image.width, image.height);
  return PictureComparison(image, to_pixels * part_.to_mesh.inverse(),
                           part_.scale * part_.size.x / image.width, std::move(counted));
}

std::vector<PartTracer::Start> PartTracer::starts() const {
  const glm::dvec2 pixel = part_.size / pixels_of(followed_);
  if (!part_.shape) {
    const RgbaImage wide = with_wide_pixels(followed_);
    return {{target_of(wide, part_.scale * part_.size.x / wide.width), part_.size, part_.to_mesh}};
  }
  const FilledOutline shape = mapped(*part_.shape, Affine::scaling(glm::dvec2(1.0) / pixel));
  std::vector<ShapeFrame> frames{straight_frame(shape.outline)};
  if (const auto turned = turned_frame(shape.outline)) frames.push_back(*turned);
  std::vector<Start> starts;
  for (const ShapeFrame& frame : frames)
    starts.push_back({target_of_shape(followed_, shape, frame, part_.scale * pixel.x), frame.size(),
                      part_.to_mesh * Affine::scaling(pixel) * frame.to_picture});
  return starts;
}

TracedPart PartTracer::run(StopWatch& watch) const {
  const std::vector<Start> starts = this->starts();
  std::vector<Beginning> beginnings;
  std::vector<const Affine*> places;
  for (const Start& start : starts) {
    const auto is_enough = [this, &start](const LineGrid& grid) {
      return coarse_.flip(mesh_of(grid, start.place)) <= options_.epsilon;
    };
    for (LineGrid& grid : even_grids(start.target, start.size, options_.handles)) {
      beginnings.push_back({&start.target, std::move(grid), is_enough});
      places.push_back(&start.place);
    }
  }
  const TracedGrid traced = traced_grid(beginnings, options_.handles, watch);
  return {mesh_of(traced.grid, *places[traced.beginning]), traced.grid.rows(),
          traced.grid.columns()};
}

}  // namespace gradmesh
