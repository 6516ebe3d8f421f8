#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "device/device.h"
#include "form/counts.h"
#include "mesh/mesh.h"
#include "pricing/price_table.h"
#include "problem/candidate.h"
#include "problem/writing_rules.h"
#include "reference/layout.h"
#include "reference/original.h"
#include "reference/reference.h"
#include "trial/merge_trial.h"

namespace gradmesh {

/// The options of the methods. Method::options names those that a method heeds.
struct MethodOptions {
  std::uint64_t seed = 0;
  /// Weight of a region's size against its error (Eq. 7), 0..1.
  double omega = 0.75;
  /// Share of epsilon, 0 or more, above which edges bound the parts (6.2).
  double kappa = 0.05;
  /// The edges to merge, in this order, by either of their half-edges.
  std::vector<int> edges;
};

/// What a result has to keep to.
struct Bounds {
  /// The largest error, 0..1 (paper, section 5).
  double epsilon = 0.01;
  /// The largest error in any window of 32 x 32 pixels, 0..1, beside epsilon (LocalBound).
  std::optional<double> local = std::nullopt;
  /// The largest error in any window of 4 x 4 pixels away from the outline, 0..1, beside these
  /// (metric/detail_errors.h).
  std::optional<double> detail = std::nullopt;
  /// At most how many handles or patches may be left, for methods that know that as they go
  /// (Method::meets_targets).
  std::optional<Target> target = std::nullopt;
};

/// With what merges are priced.
struct Pricing {
  /// The prices that earlier runs have found; runs add theirs. Null for a table of the problem's
  /// own.
  PriceTable* table = nullptr;
  /// Returns the device that prices many regions at once, null for the cores alone. Called when the
  /// first price is needed; empty if there is no device.
  std::function<std::shared_ptr<Device>()> device = {};
  /// Called with the error when the device fails, on the thread of the run; the cores go on.
  MergeTrial::DeviceLost device_lost = {};
};

/// What a run works on: a mesh, the picture that counts, the rules by which the mesh will be
/// written, and the bounds. Every method makes a Candidate of a Problem. Copies share the picture
/// and all that is found out on the way, so that a method may run with other bounds or rules.
class Problem {
 public:
  /// `original` is what has the picture that counts; null if that is `mesh` itself. Throws
  /// InputError if the original has no size.
  Problem(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Original> original,
          const Layout& layout, int resolution, MetricKind metric);

  Bounds bounds;
  /// What is made few.
  Count count = Count::patches;
  MethodOptions options;
  /// The number of threads; 0 for all cores. No result depends on the number.
  int threads = 0;
  /// The rules by which the mesh will be written; null if it is written as it is.
  std::shared_ptr<const WritingRules> rules;
  /// The rules for a rectangle of patches that stays one mesh gradient; null if that cannot be.
  std::shared_ptr<const WritingRules> gradient_rules;

  const Mesh& mesh() const { return *shared_->mesh; }
  /// Returns what has the picture that counts.
  const std::shared_ptr<const Original>& original() const { return shared_->original; }
  const Frame& frame() const { return shared_->frame; }
  MetricKind metric() const { return shared_->metric; }
  /// Returns the picture that counts, which is painted at the first call.
  const std::shared_ptr<const Reference>& reference() const;
  /// Returns the picture with half as many pixels each way, which is painted at the first call:
  /// enough to tell which edits are cheaper than others.
  const Reference& coarse_reference() const;

  /// Returns the key of the prices of this problem.
  PriceTableKey price_key() const;
  /// Sets with what merges are priced, for all copies.
  void price_with(Pricing pricing) const { shared_->pricing = std::move(pricing); }
  PriceTable& prices() const;
  /// Returns the name of the device that has priced merges until now, or "software".
  std::string renderer() const;

  /// Returns a copy of the problem for methods that keep a rectangle of patches.
  Problem as_gradient() const;
  /// Returns a problem with another mesh in the place of the mesh, such as one that has come of it
  /// or differs in what is fixed. It has prices of its own.
  Problem with_mesh(std::shared_ptr<const Mesh> mesh) const;
  /// Returns a problem with another picture that counts, in the same frame. It has prices of its
  /// own.
  Problem with_original(std::shared_ptr<const Original> original) const;
  /// Returns a problem in whose picture the errors of some places count more or less, as of
  /// Layout::weighted. It has prices of its own.
  Problem weighted(std::vector<WeightedArea> areas) const;
  /// Returns how the picture is laid out.
  const Layout& layout() const { return shared_->layout; }
  /// Returns a copy of the problem with other bounds.
  Problem within(const Bounds& other) const;
  /// Returns bounds that allow errors so much larger than those of the mesh as it was, where that
  /// is measured against a picture, from which it differs already; else the same bounds. The local
  /// bound of within() is beyond that of each window then, as it is.
  Bounds beyond_start(Bounds bounds) const;

  /// Returns a copy of the mesh with a trial that merges in it. The first call paints the mesh, and
  /// throws InputError if it covers no pixel.
  std::unique_ptr<MergeTrial::Fork> trial() const;
  /// Returns a trial that prices merges on the device if there is one and no pixel has a weight.
  std::unique_ptr<MergeTrial::Fork> pricing_trial() const;

  /// Measures a mesh as it will be written. May be called concurrently once trial() was called.
  /// Where `near` is given, a candidate of this problem whose surface differs little, only what
  /// differs is painted and measured; and once the error is certain to be above `limit` it is not
  /// worked out further, and the candidate does not keep to the bounds.
  Candidate measure(Mesh mesh, const Candidate* near = nullptr,
                    double limit = std::numeric_limits<double>::infinity()) const;
  /// Returns the candidate that is the mesh as it was. It is not written, so it has an error only
  /// against another original.
  Candidate unchanged() const;

  /// Returns as many threads as are asked for, or fewer if the limit on memory allows fewer. Lives
  /// as long as a run does.
  ThreadLimit thread_limit() const;
  /// Returns the number of edits that were painted and measured, for all copies.
  int evaluations() const;
  /// Counts evaluations that a method has made by itself.
  void count_evaluations(int made) const { shared_->evaluations += made; }

 private:
  struct Shared {
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const Original> original;
    Layout layout;
    int resolution;
    MetricKind metric;
    Frame frame;
    std::shared_ptr<const Reference> reference, coarse;
    /// The error of the mesh as it was, with opacities as they are and in a mask.
    std::array<std::optional<EditError>, 2> starts = {};
    Pricing pricing = {};
    PriceTable own_prices = {};
    std::shared_ptr<Device> device = {};
    int evaluations = 0;
  };

  /// Returns true if the original is the very mesh of the problem.
  bool is_of_itself() const { return shared_->original->mesh() == shared_->mesh; }
  /// Returns the error of the mesh as it was, from which all edits start.
  EditError& start() const;
  /// Gives a candidate its errors, and finds out whether it keeps to the bounds.
  void take(const FrameError& error, Candidate& found) const;
  /// Returns the bound of the error of small parts; null if there is none. The first call, which
  /// within(), as_gradient() and trial() make, may not be concurrent.
  const std::shared_ptr<const LocalBound>& local_bound() const;

  std::shared_ptr<Shared> shared_;
  /// Made of `bounds` and of the map of `start()` when it is first needed.
  mutable std::shared_ptr<const LocalBound> local_bound_;
};

}  // namespace gradmesh
