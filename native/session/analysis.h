#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "draw/heat_scale.h"
#include "methods/merging/motorcycle.h"
#include "methods/merging/regions.h"
#include "session/worker.h"
#include "simplify/state_curve.h"

namespace gradmesh {

/// What can be found out about a mesh besides how it looks.
enum class AnalysisKind {
  prices,   ///< what a click on each inner line costs
  regions,  ///< the tensor product regions that can be merged (paper 6.3)
  parts,    ///< the motorcycle graph (paper 6.2)
};

/// Returns the analysis of that name: "prices", "regions" or "parts". Throws std::invalid_argument
/// with all names if there is none.
AnalysisKind analysis_named(const std::string& name);

/// By how much the error rises if a line of one gradient is taken out, or if the patches beside a
/// curve are merged; infinity if that cannot be.
struct CurvePrice {
  Halfedge curve;
  double error;
};

/// Returns the scale on which these prices lie: between the lowest and the highest of them if these
/// are one to three powers of ten apart, otherwise over one or three up to the highest.
HeatScale scale_of(const std::vector<CurvePrice>& prices);

/// What was found out, of which kind that is has content.
struct Analysis {
  std::vector<CurvePrice> prices = {};
  /// By rising size, each within the error of Balanced.
  std::vector<RegionPrice> regions = {};
  MotorcycleGraph parts = {};
  /// The price that costly edges of `parts` exceed.
  double limit = 0;
  /// Why nothing was found.
  std::optional<Message> failure = std::nullopt;
};

/// Returns the regions that hold a patch, the largest first.
std::vector<RegionPrice> largest_regions(const Analysis& analysis, Face patch);

/// Finds out about one mesh while other things go on. All members may be called at any time from
/// one thread.
class AnalysisSearch {
 public:
  /// The mesh is `shown`, measured by `problem`. Lines of one gradient cost what taking them out
  /// does, followed by a fit of what is around if `fits` is true.
  AnalysisSearch(const Problem& problem, MeshKind form, const Candidate& shown, bool fits);

  const Mesh& mesh() const { return shown_.mesh; }
  /// Returns true if prices are those of edits that are followed by fits.
  bool fits() const { return fits_; }

  /// Sees to it that something is found out, after what is being found out.
  void request(AnalysisKind kind);
  /// Waits until all that is wanted is found out.
  void wait() { worker_.wait(); }
  /// Ends the search, which is busy until it has ended.
  void end() { worker_.end(); }
  bool is_busy() const { return worker_.is_busy(); }
  /// Returns what was found out; null if it was not yet.
  std::shared_ptr<const Analysis> found(AnalysisKind kind) const;

 private:
  Analysis search(AnalysisKind kind, const std::atomic<bool>& must_end) const;
  std::vector<CurvePrice> prices_of_lines(const std::atomic<bool>& must_end) const;

  const Problem problem_;
  const MeshKind form_;
  const Candidate shown_;
  const bool fits_;
  mutable std::mutex mutex_;
  /// Null for what is wanted and not found yet.
  std::map<AnalysisKind, std::shared_ptr<const Analysis>> found_;
  /// Destroyed first, so that no task outlives what it writes to.
  Worker worker_;
};

}  // namespace gradmesh
