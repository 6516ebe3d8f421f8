#include "simplify/simplify.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/error.h"
#include "base/limits.h"
#include "base/parallel.h"
#include "form/handles.h"
#include "mesh/build.h"
#include "mesh/rectangle.h"
#include "methods/best.h"
#include "methods/gqe.h"
#include "plain/fewer_handles.h"
#include "raster/painting.h"
#include "simplify/target.h"
#include "trial/merge_trial.h"

namespace gradmesh {
namespace {

/// Throws InputError if the mesh is smooth and the method does not keep rectangles. The colours of
/// a smooth patch follow those of its neighbours in rows and columns.
void check_smooth(const Mesh& mesh, bool keeps_rectangle) {
  if (mesh.is_smooth() && !keeps_rectangle)
    throw InputError(
        "its colours follow those of the neighbours (type=\"bicubic\"), so that only whole lines "
        "can be taken out, by the method lines.");
}

/// Throws InputError if a grid of points and handles cannot hold the mesh: it has one colour at
/// each point and nothing between.
void check_plain(const Mesh& mesh) {
  if (mesh.color_model() == ColorModel::bicubic)
    throw InputError("its colours are bicubic, which a plain mesh gradient cannot hold.");
  if (!find_grid(mesh)) throw InputError("it is not one rectangle of patches without T-junctions.");
}

/// Returns the frame in which the error is measured.
Frame measured_frame(const Mesh& original, const RunOptions& options) {
  Frame frame = fit_frame(original, options.view, options.resolution, options.padding);
  if (options.visible) frame.hidden = std::make_shared<HiddenPixels>(*options.visible, frame);
  return frame;
}

/// Returns the number of threads that is asked for, or fewer if the limit on memory allows fewer.
int threads_for(const Frame& frame, int asked) {
  std::size_t threads = asked > 0 ? std::size_t(asked) : thread_count();
  while (threads > 1 && measuring_bytes(frame, threads) > limits().memory) --threads;
  return int(threads);
}

bool is_blank(const Painting& painting) {
  return std::ranges::all_of(painting.top.samples,
                             [](std::uint32_t sample) { return sample == 0; });
}

/// Throws InputError if the mesh covers no pixel: all merges would then cost nothing, although
/// Inkscape may still show a line. Hidden pixels count as covered here, since nobody sees what is
/// merged there.
void check_painted(const Mesh& mesh, Frame frame, const RunOptions& options) {
  frame.hidden = nullptr;
  if (is_blank(paint_whole(mesh, frame)))
    throw InputError(
        "the mesh is so thin that it covers no pixel at a resolution of {0}, so that no error "
        "could be measured.",
        options.resolution);
}

/// Returns the table of prices that this run may use and add to: that of the options, or `own`.
/// Throws std::invalid_argument if the table of the options has another key.
PriceTable& analysis_for(const PriceTableKey& key, const RunOptions& options, PriceTable& own) {
  if (!options.analysis) return own = {key, {}};
  if (options.analysis->prices.empty()) options.analysis->key = key;
  if (options.analysis->key != key)
    throw std::invalid_argument(
        "the analysis is of another mesh, metric, resolution or color model.");
  return *options.analysis;
}

/// Measures the mesh as it will be written, on the whole frame, and puts the errors into `result`.
/// Returns true if the errors keep to epsilon and the local bound.
bool measure(const Mesh& mesh, const EditError& error, const RunOptions& options,
             SimplifyResult& result) {
  FrameError found;
  if (options.rules) {
    result.form = options.rules->form(mesh, result.frame);
    found = error.whole_frame(result.form.surface, result.form.masks_opacity());
  } else {
    found = error.whole_frame(mesh);
  }
  result.error = found.mean;
  result.local_error = found.local;
  return found.keeps_to(options.epsilon);
}

/// Counts the handles and objects of a mesh, in the form that was measured if it has one.
void count_what_is_written(const Mesh& mesh, bool has_form, SimplifyResult& result) {
  result.handles_after = count_handles(has_form ? result.form.surface : mesh);
  if (has_form && result.form.blocks) result.objects = int(result.form.blocks->blocks.size());
}

/// Takes the last merge back. If the method keeps rectangles, takes all merges of the last line
/// back.
void undo_last(MergeTrial& trial, const Method& method) {
  do trial.undo_last();
  while (method.keeps_rectangle && trial.depth() > 0 && !find_grid(trial.mesh()));
}

/// Takes the last merges back, twice as many at each step, until the mesh as it will be written
/// keeps to epsilon. The error as written differs from the selected mesh's by rounding.
void take_back(MergeTrial& trial, const Method& method, const RunOptions& options,
               SimplifyResult& result) {
  for (int at_once = 1; trial.depth() > 0; at_once *= 2) {
    for (int i = 0; i < at_once && trial.depth() > 0; ++i) undo_last(trial, method);
    if (trial.depth() > 0 && measure(trial.mesh(), trial.measure(), options, result)) break;
  }
  trial.measure_again();
}

Stopped why_stopped(const StopWatch& watch, const SimplifyResult& result) {
  if (watch.reason() == StopWatch::Reason::cancelled) return Stopped::cancelled;
  if (watch.reason() == StopWatch::Reason::budget) return Stopped::budget;
  return result.changed ? Stopped::done : Stopped::nothing_to_merge;
}

/// The state that both a simplification and an analysis begin with.
class Run {
 public:
  Run(Mesh& mesh, const RunOptions& options)
      : options_((check(options), options)),
        method_(method_named(options.method)),
        watch_(options.time_budget, options.progress),
        mesh_(mesh),
        original_(options.original ? *options.original : mesh),
        frame_(measured_frame(original_, options)),
        limit_(threads_for(frame_, options.threads)),
        trial_(mesh, measured_error(), options.epsilon),
        analysis_(analysis_for(analysis_key(original_, mesh, frame_, options.metric), options,
                               own_analysis_)) {
    if (options.device && !options.device->is_lost())
      trial_.use_device(options.device, options.device_lost);
  }

  SimplifyResult simplify() {
    SimplifyResult result;
    result.method = method_.name;
    result.frame = frame_;
    result.patches_before = mesh_.face_count();
    result.handles_before = count_handles(mesh_);
    result.seconds.rasterize = watch_.seconds();
    std::optional<FittedMesh> best;
    try {
      if (method_.makes_plain)
        best = select_plain(result);
      else if (method_.fits)
        best = select_best(result);
      else
        merge_what_fits(result);
    } catch (...) {
      trial_.undo_all();
      throw;
    }
    if (best) {
      mesh_ = std::move(best->mesh);
      keeps_as_written(mesh_, result);
    }
    result.evaluations += trial_.evaluations();
    if (trial_.has_device()) result.renderer = options_.device->info().name;
    result.error_added_up = best ? best->error : trial_.error();
    result.patches_after = mesh_.face_count();
    result.changed = best || trial_.depth() > 0;
    count_what_is_written(mesh_, result.changed && options_.rules, result);
    result.stopped = why_stopped(watch_, result);
    result.seconds.total = watch_.seconds();
    result.seconds.select = result.seconds.total - result.seconds.rasterize - result.seconds.verify;
    return result;
  }

  std::vector<EdgePrice> edges() { return price_edges(trial_, analysis_, watch_); }
  std::vector<RegionPrice> regions() {
    return price_regions(trial_, analysis_, options_.epsilon, watch_);
  }
  std::vector<double> fits(const std::vector<RegionPrice>& regions) {
    const auto fork = trial_.fork_to_fit(std::make_shared<const FitTarget>(original_, frame_));
    return fitted_prices(fork->trial, regions, options_.epsilon, watch_);
  }

 private:
  EditError measured_error() const {
    EditError error(original_, mesh_, frame_, options_.metric,
                    options_.rules && options_.rules->may_mask_opacity(), options_.max_local_error);
    if (is_blank(error.state()->painting)) check_painted(mesh_, frame_, options_);
    return error;
  }

  /// Does the same as measure, and adds the time to the phase `verify`.
  bool keeps_as_written(const Mesh& mesh, SimplifyResult& result) {
    const double before = watch_.seconds();
    const bool keeps = measure(mesh, trial_.measure(), options_, result);
    result.seconds.verify += watch_.seconds() - before;
    return keeps;
  }

  /// Merges until nothing more fits. The error as written may be larger than that of the merges,
  /// since blocks are painted in another order than faces, which shows where a mesh lies over
  /// itself. Then takes the last merges back, lowers epsilon by what writing adds, and merges what
  /// still fits.
  void merge_what_fits(SimplifyResult& result) {
    for (bool goes_on = true; goes_on;) {
      const std::size_t depth = trial_.depth();
      PriceTable afresh{analysis_.key, {}};
      method_.run({trial_, depth == 0 ? analysis_ : afresh, options_, watch_});
      if (trial_.depth() == 0 || keeps_as_written(mesh_, result)) break;
      trial_.lower_epsilon(options_.epsilon - (result.error - trial_.error()));
      take_back(trial_, method_, options_, result);
      goes_on = trial_.depth() > depth && !method_.merges_named_edges;
    }
    if (trial_.depth() == 0) merge_nothing(result);
  }

  void merge_nothing(SimplifyResult& result) const {
    // A mesh that is not changed is not written, so it has an error only against another original.
    const FrameError start = options_.original ? trial_.measure().whole_frame(mesh_) : FrameError();
    result.error = start.mean;
    result.local_error = start.local;
  }

  /// Takes handles out of the mesh as one grid. Returns the mesh with fewer of them, if there is
  /// one.
  std::optional<FittedMesh> select_plain(SimplifyResult& result) {
    check_plain(mesh_);
    const FitTarget picture(original_, frame_), coarse(original_, coarse_frame());
    const auto measured = [this](const PlainGrid& grid) {
      SimplifyResult as_written;
      as_written.frame = frame_;
      const bool keeps =
          measure(build_derived_mesh(grid.parts()), trial_.measure(), options_, as_written);
      const double bound = options_.max_local_error.value_or(0);
      return GridTask::Measured{as_written.error, bound > 0 ? as_written.local_error / bound : 0,
                                keeps};
    };
    const auto simpler = with_fewer_handles(
        PlainGrid(mesh_), {picture, coarse, measured, options_.epsilon, target_of(options_, mesh_)},
        watch_);
    if (!simpler) {
      merge_nothing(result);
      return std::nullopt;
    }
    result.evaluations = simpler->evaluations;
    return FittedMesh{build_derived_mesh(simpler->grid.parts()), simpler->error};
  }

  /// Returns the frame of half as many pixels each way.
  Frame coarse_frame() const {
    RunOptions half = options_;
    half.resolution = std::max(options_.resolution / 2, least_resolution);
    return measured_frame(original_, half);
  }

  /// Merges as gqe does. Returns the mesh that fits make of the merged mesh if the fitted mesh has
  /// fewer patches, or as many with a smaller error; nothing otherwise.
  std::optional<FittedMesh> select_best(SimplifyResult& result) {
    // Both must be made before anything is merged.
    const FitContext context = fit_context();
    const auto start = trial_.fork();
    const auto regions = price_regions(trial_, analysis_, trial_.room(), watch_);
    if (what_is_counted(options_) == Count::handles && mesh_.color_model() == ColorModel::bilinear)
      return select_blocks(start->trial, regions, context, result);
    select_gqe(trial_, regions, {options_.omega, false}, watch_);
    std::optional<FittedMesh> best = merge_and_fit(start->trial, trial_, regions, context, watch_);
    merge_what_fits(result);
    if (best && best->mesh.face_count() > mesh_.face_count()) best = fit(trial_, context, watch_);
    if (!best || best->mesh.face_count() > mesh_.face_count()) return std::nullopt;
    const bool as_many = best->mesh.face_count() == mesh_.face_count();
    if (as_many && result.error <= context.written(best->mesh).error) return std::nullopt;
    return best;
  }

  /// Returns the blocks that leave least to handle: of all the patches that can be merged, or of
  /// fewer, which leaves more of epsilon for straight sides. Returns nothing if there are none.
  std::optional<FittedMesh> select_blocks(MergeTrial& start,
                                          const std::vector<RegionPrice>& regions,
                                          FitContext context, SimplifyResult& result) {
    context.count = Count::handles;
    std::optional<FittedMesh> best;
    const int before = context.written(mesh_).handles;
    int least = std::numeric_limits<int>::max();
    for (const double share : {1.0, 0.5}) {
      const auto merged = start.fork();
      merged->trial.lower_epsilon(share * options_.epsilon);
      select_gqe(merged->trial, regions, {options_.omega, false}, watch_);
      context.share = share;
      auto found = merge_and_fit(start, merged->trial, regions, context, watch_);
      if (!found) continue;
      const FitContext::Written left = context.written(found->mesh);
      if (left.handles >= before || left.to_handle >= least) continue;
      best = std::move(found);
      least = left.to_handle;
    }
    if (!best) merge_nothing(result);
    return best;
  }

  FitContext fit_context() const {
    FitContext context;
    context.target = std::make_shared<const FitTarget>(original_, frame_);
    context.omega = options_.omega;
    context.epsilon = options_.epsilon;
    context.written = [this](const Mesh& mesh) {
      SimplifyResult as_written;
      as_written.frame = frame_;
      const bool keeps = measure(mesh, trial_.measure(), options_, as_written);
      count_what_is_written(mesh, options_.rules != nullptr, as_written);
      return FitContext::Written{as_written.error, keeps, as_written.handles_after,
                                 to_handle(as_written)};
    };
    return context;
  }

  const RunOptions& options_;
  const Method& method_;
  StopWatch watch_;
  Mesh& mesh_;
  const Mesh& original_;
  const Frame frame_;
  const ThreadLimit limit_;
  MergeTrial trial_;
  PriceTable own_analysis_;
  PriceTable& analysis_;
};

}  // namespace

const char* name(Stopped stopped) {
  switch (stopped) {
    case Stopped::done:
      return "done";
    case Stopped::budget:
      return "budget";
    case Stopped::cancelled:
      return "cancelled";
    case Stopped::nothing_to_merge:
      return "nothing to merge";
  }
  return "";
}

int to_handle(const SimplifyResult& result) {
  return result.handles_after + handles_of_an_object * result.objects;
}

SimplifyResult simplify(Mesh& mesh, const RunOptions& options) {
  check_smooth(mesh, method_named(options.method).keeps_rectangle);
  const std::optional<Target> target = target_of(options, mesh);
  if (!target) return Run(mesh, options).simplify();
  if (!method_named(options.method).makes_plain) return simplify_to_target(mesh, options, *target);
  // This selection knows what is left as it goes.
  RunOptions without_epsilon = options;
  without_epsilon.epsilon = 1;
  return Run(mesh, without_epsilon).simplify();
}

std::vector<EdgePrice> analyze_edges(const Mesh& mesh, const RunOptions& options) {
  check_smooth(mesh, false);
  Mesh copy = mesh;
  return Run(copy, options).edges();
}

std::vector<RegionPrice> analyze_regions(const Mesh& mesh, const RunOptions& options) {
  check_smooth(mesh, false);
  Mesh copy = mesh;
  return Run(copy, options).regions();
}

std::vector<double> analyze_fits(const Mesh& mesh, const RunOptions& options,
                                 const std::vector<RegionPrice>& regions) {
  check_smooth(mesh, false);
  Mesh copy = mesh;
  return Run(copy, options).fits(regions);
}

PriceTableKey analysis_key(const Mesh& mesh, const RunOptions& options) {
  check(options);
  const Mesh& original = options.original ? *options.original : mesh;
  return analysis_key(original, mesh, measured_frame(original, options), options.metric);
}

}  // namespace gradmesh
