#include "trial/edit_error.h"

#include <algorithm>
#include <utility>

#include "metric/local_mean.h"

namespace gradmesh {
namespace {

bool overlaps(const Painting& painting, Window window) {
  for (int y = window.y0; y < window.y1; ++y) {
    const std::uint32_t* const row = painting.top.at(window.x0, y);
    if (std::any_of(row, row + window.width(),
                    [](std::uint32_t sample) { return TopFace(sample).covers_others(); }))
      return true;
  }
  return false;
}

}  // namespace

EditError::EditError(std::shared_ptr<const Reference> reference, const Mesh& start,
                     bool masks_opacity, bool is_original) {
  const auto fixed = std::make_shared<Fixed>();
  fixed->frame = reference->frame();
  fixed->frame.masked_opacity = masks_opacity && !start.is_smooth() &&
                                start.color_model() == ColorModel::bilinear &&
                                is_translucent(start);
  const auto state = std::make_shared<State>();
  if (is_original && !fixed->frame.masked_opacity) {
    state->painting = reference->painting();
    state->map = Plane(fixed->frame.width, fixed->frame.height);
  } else {
    state->painting = paint_whole(start, fixed->frame);
    state->map = reference->metric().map(state->painting.image);
  }
  state->sum = mean(state->map) * double(state->map.pixels());
  state->bounds.resize(start.face_slots());
  for (const Face f : start.faces())
    state->bounds[f.value] = pixel_bounds(start.patch(f), fixed->frame);
  state->overlaps = overlaps(state->painting, state->painting.window());
  fixed->reference = std::move(reference);
  fixed_ = fixed;
  state_ = state;
}

EditError EditError::fork() { return {fixed_, local_bound_, state()}; }

std::shared_ptr<const EditError::State> EditError::state() {
  own_state_.reset();
  return state_;
}

void EditError::restore(std::shared_ptr<const State> state) {
  own_state_.reset();
  state_ = std::move(state);
}

Window EditError::changed_pixels(const Mesh& mesh, const std::vector<Face>& touched) const {
  if (mesh.is_smooth()) return fixed_->frame.window();
  Window changed;
  for (const Face f : touched) {
    if (std::size_t(f.value) < state_->bounds.size())
      changed = changed.united(state_->bounds[f.value]);
    if (mesh[f].alive) changed = changed.united(pixel_bounds(mesh.patch(f), fixed_->frame));
  }
  return changed.clipped(fixed_->frame.window());
}

double EditError::after_edits(const Journal& journal, std::size_t depth, double limit) {
  ++fixed_->evaluations;
  const Metric& metric = reference().metric();
  const Window frame = fixed_->frame.window();
  trial_.touched = journal.touched_since(depth);
  trial_.pixels = changed_pixels(journal.mesh(), trial_.touched);
  trial_.sum = state_->sum;
  trial_.measured = {};
  if (trial_.pixels.empty()) return error();
  trial_.measured = trial_.pixels.grown(metric.reach()).clipped(frame);
  const Window seen = trial_.pixels.grown(2 * metric.reach()).clipped(frame);

  Painting& painting = trial_.painting;
  painting.image.reset(seen);
  painting.top.reset(seen);
  trial_.map.reset(trial_.measured);
  copy(state_->painting, seen, painting);
  copy(state_->map, trial_.measured, trial_.map);

  painter_.repaint(journal.mesh(), fixed_->frame, trial_.touched, trial_.pixels, painting);
  const auto pixels = double(state_->map.pixels());
  trial_.sum += metric.update_map(state_->painting.image, painting.image, trial_.pixels, trial_.map,
                                  limit * pixels - state_->sum);
  return trial_.sum / pixels;
}

std::vector<double> EditError::change_by_face(std::size_t face_slots) const {
  std::vector<double> change(face_slots, 0.0);
  const Window& window = trial_.measured;
  for (int y = window.y0; y < window.y1; ++y) {
    const std::uint32_t* top = trial_.painting.top.at(window.x0, y);
    const float *now = trial_.map.at(window.x0, y), *before = state_->map.at(window.x0, y);
    for (int i = 0; i < window.width(); ++i)
      if (const Face face = TopFace(top[i]).face(); face.valid())
        change[std::size_t(face.value)] += double(now[i]) - before[i];
  }
  return change;
}

bool EditError::keeps_local_bound() {
  if (!local_bound_ || trial_.measured.empty()) return true;
  // All windows with a pixel that was measured.
  const Window around = trial_.measured.grown(local_side - 1).clipped(fixed_->frame.window());
  trial_.map_around.reset(around);
  copy(state_->map, around, trial_.map_around);
  copy(trial_.map, trial_.measured, trial_.map_around);
  return local_bound_->holds(trial_.map_around);
}

void EditError::accept(const Journal& journal) {
  if (!own_state_) state_ = own_state_ = std::make_shared<State>(*state_);
  State& state = *own_state_;
  copy(trial_.painting, trial_.pixels, state.painting);
  copy(trial_.map, trial_.measured, state.map);
  state.sum = trial_.sum;
  state.overlaps = state.overlaps || overlaps(trial_.painting, trial_.pixels);
  state.bounds.resize(journal.mesh().face_slots());
  for (const Face f : trial_.touched)
    state.bounds[f.value] =
        journal.mesh()[f].alive ? pixel_bounds(journal.mesh().patch(f), fixed_->frame) : Window{};
}

std::unique_ptr<DeviceErrors> EditError::on_device(std::shared_ptr<Device> device) {
  auto errors = std::make_unique<DeviceErrors>(std::move(device), reference().metric_kind(),
                                               reference().painting().image, fixed_->frame);
  errors->start(state_->painting);
  return errors;
}

void EditError::describe(const Journal& journal, std::size_t depth, EditTile& tile) {
  ++fixed_->evaluations;
  const std::vector<Face> touched = journal.touched_since(depth);
  tiler_.make(journal.mesh(), fixed_->frame, touched, changed_pixels(journal.mesh(), touched),
              state_->overlaps ? &state_->painting : nullptr, tile);
}

}  // namespace gradmesh
