#include "error/edit_error.h"

namespace gradmesh {
namespace {

/// Copies the samples of `window` out of a raster, row by row, or back into it.
template <class Sample, int Channels>
void take(const Raster<Sample, Channels>& raster, Window window, std::vector<Sample>& to) {
  to.clear();
  for (int y = window.y0; y < window.y1; ++y) {
    const Sample* row = raster.at(window.x0, y);
    to.insert(to.end(), row, row + Channels * window.width());
  }
}

template <class Sample, int Channels>
void put(const std::vector<Sample>& from, Window window, Raster<Sample, Channels>& raster) {
  const std::size_t row = std::size_t(Channels) * window.width();
  for (int y = window.y0; y < window.y1; ++y)
    std::copy_n(from.begin() + row * (y - window.y0), row, raster.at(window.x0, y));
}

double sum(const Plane& map, Window window) {
  double total = 0;
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) total += *map.at(x, y);
  return total;
}

}  // namespace

EditError::EditError(const Mesh& original, const Mesh& start, const Frame& frame, MetricKind metric)
    : rasterizer_(make_software_rasterizer()),
      frame_(frame),
      reference_(rasterizer_->paint(original, frame)),
      metric_(make_metric(metric, reference_)),
      map_(frame.width, frame.height) {
  frame_.masked_opacity = start.color_model() == ColorModel::bilinear && is_translucent(start);
  image_ = rasterizer_->paint(start, frame_);
  map_ = metric_->map(image_);
  sum_ = sum(map_, map_.window());
  bounds_.resize(start.face_slots());
  for (const Face f : start.faces()) bounds_[f.value] = pixel_bounds(start.patch(f), frame_);
}

Window EditError::changed_pixels(const Mesh& mesh) const {
  Window changed;
  for (const Face f : trial_.touched) {
    if (std::size_t(f.value) < bounds_.size()) changed = changed.united(bounds_[f.value]);
    if (mesh[f].alive) changed = changed.united(pixel_bounds(mesh.patch(f), frame_));
  }
  return changed.clipped(frame_.window());
}

double EditError::after_edits(const Journal& journal, std::size_t depth) {
  trial_.touched = journal.touched_since(depth);
  trial_.pixels = changed_pixels(journal.mesh());
  trial_.measured = trial_.pixels.empty()
                        ? Window{}
                        : trial_.pixels.grown(metric_->reach()).clipped(frame_.window());
  trial_.sum = sum_;
  take(image_, trial_.pixels, trial_.image);
  take(map_, trial_.measured, trial_.map);

  const double before = sum(map_, trial_.measured);
  rasterizer_->paint(journal.mesh(), frame_, trial_.pixels, image_);
  metric_->fill_map(image_, trial_.measured, map_);
  sum_ += sum(map_, trial_.measured) - before;
  return error();
}

void EditError::accept(const Journal& journal) {
  bounds_.resize(journal.mesh().face_slots());
  for (const Face f : trial_.touched)
    bounds_[f.value] =
        journal.mesh()[f].alive ? pixel_bounds(journal.mesh().patch(f), frame_) : Window{};
}

void EditError::reject() {
  put(trial_.image, trial_.pixels, image_);
  put(trial_.map, trial_.measured, map_);
  sum_ = trial_.sum;
}

double EditError::whole_frame(const Mesh& mesh) const {
  return mean(metric_->map(rasterizer_->paint(mesh, frame_)));
}

}  // namespace gradmesh
