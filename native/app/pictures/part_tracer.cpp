#include "app/pictures/part_tracer.h"

#include <algorithm>
#include <chrono>

#include "base/clamped_int.h"
#include "files/box_reducer.h"
#include "mesh/build.h"
#include "trace/guided_grid.h"
#include "trace/outline_grid.h"
#include "trace/shape_target.h"
#include "trace/thinned_grids.h"
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
      coarse_(followed_ == part_.image ? exact_ : compared_with(followed_)) {}

std::shared_ptr<const PictureComparison> PartTracer::compared_with(const RgbaImage& image) const {
  const Affine to_pixels = Affine::scaling(pixels_of(image) / part_.size);
  std::vector<float> counted;
  if (part_.shape)
    counted = counted_pixels(mapped(*part_.shape, to_pixels), image.width, image.height);
  return std::make_shared<const PictureComparison>(image, to_pixels * part_.to_mesh.inverse(),
                                                   part_.scale * part_.size.x / image.width,
                                                   std::move(counted));
}

PartTracer::Goal PartTracer::goal() const {
  Goal goal = unweighted_goal();
  weigh(goal.target, part_.weighted, goal.place.inverse() * part_.to_mesh);
  return goal;
}

PartTracer::Goal PartTracer::unweighted_goal() const {
  if (!part_.shape) {
    const RgbaImage wide = with_wide_pixels(followed_);
    const glm::dvec2 pixel = part_.size / pixels_of(wide);
    return {target_of(wide, part_.scale * pixel.x),
            {{}, wide.width, wide.height},
            part_.to_mesh * Affine::scaling(pixel)};
  }
  const glm::dvec2 pixel = part_.size / pixels_of(followed_);
  const FilledOutline shape = shape_in_pixels();
  const ShapeFrame frame = turned_frame(shape.outline).value_or(straight_frame(shape.outline));
  return {target_of_shape(followed_, shape, frame, part_.scale * pixel.x), frame,
          part_.to_mesh * Affine::scaling(pixel) * frame.to_picture};
}

std::function<void(const LineGrid&)> PartTracer::shower(const Goal& goal) const {
  if (!options_.show) return {};
  using Clock = std::chrono::steady_clock;
  // Not so often that the run would take longer for it.
  constexpr std::chrono::milliseconds pause(400);
  return [this, pause, place = goal.place, next = Clock::now(),
          shown = std::optional<LineGrid>()](const LineGrid& grid) mutable {
    if (Clock::now() < next || shown == grid) return;
    options_.show(exact_->painted(mesh_of(grid, place)));
    shown = grid;
    next = Clock::now() + pause;
  };
}

PartTracer::Beginnings PartTracer::beginnings(const Goal& goal) const {
  std::vector<std::vector<glm::dvec2>> guides = part_.guides;
  const Affine to_grid = goal.place.inverse() * part_.to_mesh;
  for (std::vector<glm::dvec2>& guide : guides)
    for (glm::dvec2& point : guide) point = to_grid.point(point);
  Beginnings beginnings{unguided_beginnings(goal), {}};
  for (Beginning& beginning : beginnings.grids) {
    GuidedGrid guided = guided_grid(beginning.grid, guides, options_.handles);
    beginning.grid = std::move(guided.grid);
    beginnings.unused_guides.push_back(std::move(guided.unused));
  }
  return beginnings;
}

std::vector<Beginning> PartTracer::unguided_beginnings(const Goal& goal) const {
  // A grid that follows the outline has no points far from what they are to change.
  constexpr double nicer_to_edit = 0.7;
  const auto is_enough = [this, &goal](const LineGrid& grid) {
    return coarse_->flip(mesh_of(grid, goal.place)) <= options_.epsilon;
  };
  std::vector<Beginning> beginnings;
  for (const LineGrid& even : even_grids(goal.target, goal.frame.size(), options_.handles)) {
    beginnings.push_back({&goal.target, even, is_enough});
    if (!part_.shape) continue;
    // One line less each way, as those of the beginning stay.
    const auto following = outline_grid(
        mapped(shape_in_pixels().outline, goal.frame.to_picture.inverse()),
        std::max(1, even.rows() - 1), std::max(1, even.columns() - 1), goal.frame.size());
    if (following) beginnings.push_back({&goal.target, *following, is_enough, nicer_to_edit});
  }
  return beginnings;
}

FilledOutline PartTracer::shape_in_pixels() const {
  return mapped(*part_.shape, Affine::scaling(pixels_of(followed_) / part_.size));
}

TracedPart PartTracer::run(StopWatch& watch) const {
  const Goal goal = this->goal();
  const Beginnings beginnings = this->beginnings(goal);
  const TracedGrid traced = traced_grid(beginnings.grids, options_.handles, watch, shower(goal));
  const LineGrid& grid = traced.grid;
  TracedPart part{mesh_of(grid, goal.place), grid.rows(), grid.columns(),
                  beginnings.unused_guides[traced.beginning]};
  if (options_.wants_simpler)
    for (const LineGrid& simpler : thinned_grids(grid, goal.target, watch))
      part.simpler.push_back(mesh_of(simpler, goal.place));
  return part;
}

}  // namespace gradmesh
