#include "error/edit_error.h"

namespace gradmesh {
namespace {

/// Copies the samples of `window` out of a raster, row by row, or back into it.
template <class Sample, int Channels>
void take(const Raster<Sample, Channels>& raster, Window window, std::vector<Sample>& to) {
  to.clear();
  for (int c = 0; c < Channels; ++c)
    for (int y = window.y0; y < window.y1; ++y) {
      const Sample* row = raster.at(window.x0, y, c);
      to.insert(to.end(), row, row + window.width());
    }
}

template <class Sample, int Channels>
void put(const std::vector<Sample>& from, Window window, Raster<Sample, Channels>& raster) {
  auto row = from.begin();
  for (int c = 0; c < Channels; ++c)
    for (int y = window.y0; y < window.y1; ++y, row += window.width())
      std::copy_n(row, window.width(), raster.at(window.x0, y, c));
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
      metric_(make_metric(metric, reference_)) {
  frame_.masked_opacity = start.color_model() == ColorModel::bilinear && is_translucent(start);
  state_.image = rasterizer_->paint(start, frame_);
  state_.map = metric_->map(state_.image);
  state_.sum = sum(state_.map, state_.map.window());
  state_.bounds.resize(start.face_slots());
  for (const Face f : start.faces()) state_.bounds[f.value] = pixel_bounds(start.patch(f), frame_);
}

Window EditError::changed_pixels(const Mesh& mesh) const {
  Window changed;
  for (const Face f : trial_.touched) {
    if (std::size_t(f.value) < state_.bounds.size())
      changed = changed.united(state_.bounds[f.value]);
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
  trial_.sum = state_.sum;
  take(state_.image, trial_.pixels, trial_.image);
  take(state_.map, trial_.measured, trial_.map);

  const double before = sum(state_.map, trial_.measured);
  rasterizer_->paint(journal.mesh(), frame_, trial_.pixels, state_.image);
  metric_->fill_map(state_.image, trial_.measured, state_.map);
  state_.sum += sum(state_.map, trial_.measured) - before;
  return error();
}

void EditError::accept(const Journal& journal) {
  state_.bounds.resize(journal.mesh().face_slots());
  for (const Face f : trial_.touched)
    state_.bounds[f.value] =
        journal.mesh()[f].alive ? pixel_bounds(journal.mesh().patch(f), frame_) : Window{};
}

void EditError::reject() {
  put(trial_.image, trial_.pixels, state_.image);
  put(trial_.map, trial_.measured, state_.map);
  state_.sum = trial_.sum;
}

double EditError::whole_frame(const Mesh& mesh) const {
  return mean(metric_->map(rasterizer_->paint(mesh, frame_)));
}

}  // namespace gradmesh
