#include "problem/problem.h"

#include <algorithm>

#include "base/error.h"
#include "base/limits.h"
#include "form/handles.h"
#include "ops/fix.h"

namespace gradmesh {
namespace {

bool is_blank(const Painting& painting) {
  return std::ranges::all_of(painting.top.samples,
                             [](std::uint32_t sample) { return sample == 0; });
}

/// Throws InputError if the mesh covers no pixel: all merges would then cost nothing, although
/// Inkscape may still show a line. Hidden pixels count as covered here, since nobody sees what is
/// merged there.
void check_painted(const Mesh& mesh, Frame frame, int resolution) {
  frame.hidden = nullptr;
  if (is_blank(paint_whole(mesh, frame)))
    throw InputError(
        "the mesh is so thin that it covers no pixel at a resolution of {0}, so that no error "
        "could be measured.",
        resolution);
}

}  // namespace

int Candidate::effort() const {
  return counts().handles + handles_of_an_object * form.object_count();
}

Problem::Problem(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Original> original,
                 const Layout& layout, int resolution, MetricKind metric) {
  if (!original) original = original_of(mesh);
  const Frame frame = laid_out(*original, layout, resolution);
  shared_ = std::make_shared<Shared>(
      Shared{std::move(mesh), std::move(original), layout, resolution, metric, frame, {}, {}});
}

const std::shared_ptr<const Reference>& Problem::reference() const {
  Shared& s = *shared_;
  if (!s.reference) s.reference = std::make_shared<const Reference>(*s.original, s.frame, s.metric);
  return s.reference;
}

const Reference& Problem::coarse_reference() const {
  constexpr int least = 16;
  Shared& s = *shared_;
  if (!s.coarse)
    s.coarse = std::make_shared<const Reference>(
        *s.original, laid_out(*s.original, s.layout, std::max(s.resolution / 2, least)), s.metric);
  return *s.coarse;
}

PriceTableKey Problem::price_key() const {
  return analysis_key(*original(), mesh(), frame(), metric());
}

PriceTable& Problem::prices() const {
  PriceTable* const table = shared_->pricing.table;
  return table ? *table : shared_->own_prices;
}

std::string Problem::renderer() const {
  return shared_->device ? shared_->device->info().name : "software";
}

Problem Problem::as_gradient() const {
  Problem copy = *this;
  copy.rules = gradient_rules ? gradient_rules : rules;
  copy.local_bound_ = nullptr;
  copy.local_bound();
  return copy;
}

Problem Problem::with_mesh(std::shared_ptr<const Mesh> mesh) const {
  Problem copy = *this;
  const Shared& s = *shared_;
  copy.shared_ =
      std::make_shared<Shared>(Shared{std::move(mesh), s.original, s.layout, s.resolution, s.metric,
                                      s.frame, s.reference, s.coarse});
  copy.local_bound_ = nullptr;
  return copy;
}

Problem Problem::with_original(std::shared_ptr<const Original> original) const {
  if (original == this->original()) return *this;
  Problem copy = *this;
  const Shared& s = *shared_;
  copy.shared_ = std::make_shared<Shared>(
      Shared{s.mesh, std::move(original), s.layout, s.resolution, s.metric, s.frame, {}, {}});
  copy.local_bound_ = nullptr;
  return copy;
}

Problem Problem::weighted(std::vector<WeightedArea> areas) const {
  Problem copy = *this;
  const Shared& s = *shared_;
  Layout layout = s.layout;
  layout.weighted = std::move(areas);
  Frame frame = s.frame;
  frame.weights = weights_in(frame, layout.weighted);
  copy.shared_ = std::make_shared<Shared>(Shared{s.mesh, s.original, std::move(layout),
                                                 s.resolution, s.metric, frame, nullptr, nullptr});
  copy.local_bound_ = nullptr;
  return copy;
}

Problem Problem::within(const Bounds& other) const {
  Problem copy = *this;
  copy.bounds = other;
  copy.local_bound_ = nullptr;
  copy.local_bound();
  return copy;
}

Bounds Problem::beyond_start(Bounds allowed) const {
  if (!original()->is_picture()) return allowed;
  const bool masks = rules && rules->may_mask_opacity();
  const FrameError start =
      MeasuredSurface(*reference(), mesh(), masks, nullptr, allowed.detail.has_value()).error();
  allowed.epsilon += start.mean;
  if (allowed.detail) *allowed.detail += start.detail;
  return allowed;
}

EditError& Problem::start() const {
  const bool masks = rules && rules->may_mask_opacity();
  std::optional<EditError>& start = shared_->starts[masks];
  if (!start) {
    start.emplace(reference(), mesh(), masks, is_of_itself());
    if (is_blank(start->state()->painting)) check_painted(mesh(), frame(), shared_->resolution);
  }
  return *start;
}

std::unique_ptr<MergeTrial::Fork> Problem::trial() const {
  EditError error = start().fork();
  error.keep_to(local_bound());
  return std::make_unique<MergeTrial::Fork>(mesh(), std::move(error), bounds.epsilon);
}

std::unique_ptr<MergeTrial::Fork> Problem::pricing_trial() const {
  auto fork = trial();
  Shared& s = *shared_;
  // A device is asked for once; one that has failed is not tried again. None knows weights.
  const auto choose = std::exchange(s.pricing.device, {});
  if (choose && !s.frame.weights) s.device = choose();
  if (s.device && s.device->is_lost()) s.device = nullptr;
  if (s.device)
    fork->trial.use_device(s.device, [shared = shared_](const DeviceError& error) {
      shared->device = nullptr;
      if (shared->pricing.device_lost) shared->pricing.device_lost(error);
    });
  return fork;
}

const std::shared_ptr<const LocalBound>& Problem::local_bound() const {
  if (bounds.local && !local_bound_) {
    const Plane& map = start().state()->map;
    local_bound_ = std::make_shared<const LocalBound>(original()->is_picture()
                                                          ? LocalBound::beyond(*bounds.local, map)
                                                          : LocalBound(*bounds.local, map));
  }
  return local_bound_;
}

void Problem::take(const FrameError& error, Candidate& found) const {
  found.error = error.mean;
  found.local_error = error.local;
  found.detail_error = error.detail;
  found.keeps =
      error.keeps_to(bounds.epsilon) && (!bounds.detail || error.detail <= *bounds.detail);
}

Candidate Problem::measure(Mesh mesh, const Candidate* near, double limit) const {
  Candidate found{.mesh = std::move(mesh), .changed = true};
  if (rules) found.form = rules->form(found.mesh, frame());
  const LocalBound* const bound = local_bound().get();
  const Mesh& surface = found.surface();
  if (near && near->measured && near->form.masks_opacity() == found.form.masks_opacity())
    found.measured =
        std::make_shared<MeasuredSurface>(*near->measured, *reference(), surface, bound, limit);
  else
    found.measured = std::make_shared<MeasuredSurface>(
        *reference(), surface, found.form.masks_opacity(), bound, bounds.detail.has_value());
  take(found.measured->error(), found);
  return found;
}

Candidate Problem::unchanged() const {
  Candidate found{.mesh = mesh(), .error_added_up = start().error()};
  const std::shared_ptr<const Mesh> same = original()->mesh();
  if (is_of_itself() || (same && are_same_but_for_fixed(*same, mesh()))) return found;
  EditError error = start().fork();
  error.keep_to(local_bound());
  take(error.whole_frame(mesh()), found);
  return found;
}

ThreadLimit Problem::thread_limit() const {
  std::size_t allowed = threads > 0 ? std::size_t(threads) : thread_count();
  while (allowed > 1 && measuring_bytes(frame(), allowed) > limits().memory) --allowed;
  return ThreadLimit(int(allowed));
}

int Problem::evaluations() const {
  int sum = shared_->evaluations;
  for (const auto& start : shared_->starts) sum += start ? start->evaluations() : 0;
  return sum;
}

}  // namespace gradmesh
