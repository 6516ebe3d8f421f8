#include "trial/fit_trial.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "fit/refit.h"
#include "ops/merge/merge_region.h"
#include "ops/straighten.h"
#include "raster/folds.h"

namespace gradmesh {
namespace {

constexpr double most_damping = 1e3;

/// Returns the faces and those that share a curve with them, each once.
std::vector<Face> with_neighbours(const Mesh& mesh, const std::vector<Face>& faces) {
  std::vector<Face> result = faces;
  for (const Face f : faces)
    for (const Halfedge h : mesh.sides(f)) {
      const Halfedge curve = mesh.curve(h);
      for (const Halfedge side : {curve, mesh[curve].twin})
        if (side.valid())
          for (const Halfedge leaf : mesh.leaves(side)) result.push_back(mesh.face(leaf));
    }
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// A merge that costs more than this many times the limit is not fitted.
constexpr double most_that_a_fit_saves = 4;

/// Sums of the map that rise by less than this are left alone.
constexpr double noticeable = 0.01;

/// Returns the faces that the fit changes and that surely do not fold.
std::vector<Face> unfolded_faces(const Mesh& mesh, const Fit& fit) {
  std::vector<Face> faces;
  for (const InfluencedFace& f : fit.influenced())
    if (!may_fold(mesh.patch(f.face))) faces.push_back(f.face);
  return faces;
}

/// Returns for each unknown whether it changes a face for which `is_one` is true.
std::vector<bool> unknowns_of(const Fit& fit, const std::function<bool(Face)>& is_one) {
  std::vector<bool> result(fit.unknowns().size(), false);
  for (const InfluencedFace& f : fit.influenced())
    if (is_one(f.face))
      for (const Influence& by : f.by) result[std::size_t(by.unknown)] = true;
  return result;
}

}  // namespace

/// The faces of a fit as a surface of refit(): a step is accepted if it lowers the measured error
/// and folds none of the faces that did not fold. What did harm are the unknowns of faces that fold
/// or where the error rises.
class FitTrial::Surface {
 public:
  Surface(FitTrial& trial, const std::vector<Face>& faces)
      : journal_(trial.journal_),
        error_(trial.error_),
        fit_(journal_, trial.reference(), faces, trial.plainness()),
        unfolded_(unfolded_faces(trial.mesh(), fit_)),
        damping_(fit_.unknowns().size(), most_damping) {}

  std::size_t unknown_count() const { return fit_.unknowns().size(); }
  std::vector<Value> step() { return fit_.step(damping_); }
  void move(const std::vector<Value>& step, const std::vector<bool>& held) {
    depth_ = journal_.depth();
    fit_.apply(step, held);
  }
  void take_back() { journal_.undo_to(depth_); }

  Verdict judge(int attempt) {
    const Mesh& mesh = journal_.mesh();
    std::vector<bool> folded(mesh.face_slots(), false);
    for (const Face f : unfolded_) folded[std::size_t(f.value)] = may_fold(mesh.patch(f));
    const bool better = error_.after_edits(journal_, depth_) < error_.error() &&
                        std::ranges::find(folded, true) == folded.end();
    const std::vector<double> change = error_.change_by_face(mesh.face_slots());
    std::vector<bool> worse = unknowns_of(fit_, [&](Face f) {
      return folded[std::size_t(f.value)] || change[std::size_t(f.value)] > noticeable;
    });
    for (std::size_t u = 0; u < worse.size(); ++u) {
      if (worse[u]) damping_.raise(u, attempt > 0);
      if (!worse[u] && attempt == 0) damping_.lower(u);
    }
    if (better) error_.accept(journal_);
    return {better, true, std::move(worse)};
  }

 private:
  Journal& journal_;
  EditError& error_;
  Fit fit_;
  const std::vector<Face> unfolded_;
  Damping damping_;
  std::size_t depth_ = 0;
};

double FitTrial::price(const Region& region, double limit) {
  const std::size_t depth = journal_.depth();
  const double before = error();
  double price = std::numeric_limits<double>::infinity();
  if (const std::vector<Face> merged = merge_possible({region}); !merged.empty()) {
    const double most = most_that_a_fit_saves * limit;
    price = error_.after_edits(journal_, depth, before + most) - before;
    if (price > most) {
      journal_.undo_to(depth);
      return price;
    }
    Fit fit(journal_, reference(), merged, plainness());
    const Damping damping(fit.unknowns().size());
    constexpr int steps = 2;
    for (int i = 0; i < steps; ++i)
      fit.apply(fit.step(damping), std::vector<bool>(fit.unknowns().size(), false));
    const double unfitted = price;
    price = error_.after_edits(journal_, depth, before + limit) - before;
    const bool breaks = price <= limit && !error_.keeps_local_bound();
    price = breaks ? std::numeric_limits<double>::infinity() : std::min(price, unfitted);
  }
  journal_.undo_to(depth);
  return price;
}

bool FitTrial::try_and_fit(const std::vector<Region>& regions, double limit, int steps) {
  const std::size_t depth = journal_.depth();
  const std::vector<Face> merged = merge_possible(regions);
  return !merged.empty() && keep_if_cheap(depth, merged, limit, steps);
}

double FitTrial::price(const HandleDrop& drop) {
  const std::size_t depth = journal_.depth();
  make(drop);
  const double price = error_.after_edits(journal_, depth) - error();
  journal_.undo_to(depth);
  return price;
}

bool FitTrial::try_drops(const std::vector<HandleDrop>& drops, double limit, int steps,
                         const std::function<bool(const Mesh&)>& is_kept) {
  const std::size_t depth = journal_.depth();
  for (const HandleDrop& drop : drops) make(drop);
  return keep_if_cheap(depth, journal_.touched_since(depth), limit, steps, is_kept);
}

bool FitTrial::keep_if_cheap(std::size_t depth, const std::vector<Face>& changed, double limit,
                             int steps, const std::function<bool(const Mesh&)>& is_kept) {
  const State start{depth, error_.state()};
  error_.after_edits(journal_, depth);
  error_.accept(journal_);
  fit(with_neighbours(mesh(), changed), steps, limit);
  if (error() <= limit && error_.accepted_keeps_local_bound() && (!is_kept || is_kept(mesh()))) {
    last_change_.resize(mesh().face_slots(), 0);
    ++changes_;
    for (const Face f : journal_.touched_since(depth)) last_change_[f.value] = changes_;
    return true;
  }
  go_back(start);
  return false;
}

void FitTrial::make(const HandleDrop& drop) {
  const Plainness plain(mesh());
  journal_.begin();
  if (drop.face.valid()) return drop_tensor(journal_, drop.face);
  straighten(journal_, drop.curve);
  plain.refresh(journal_, std::array{drop.curve});
}

void FitTrial::improve(const std::vector<Face>& faces, int steps) {
  const State start = state();
  const bool kept = error_.accepted_keeps_local_bound();
  fit(faces, steps, 1);
  if (kept && !error_.accepted_keeps_local_bound()) go_back(start);
}

void FitTrial::fit(const std::vector<Face>& faces, int steps, double limit) {
  constexpr int attempts = 2;
  Surface surface(*this, faces);
  for (int left = steps; left-- > 0;) {
    const double before = error();
    const bool better = refit(surface, attempts);
    // Each step does less than the one before.
    const double drop = before - error();
    if (better && error() - left * drop > limit) return;
    constexpr double little = 0.02;
    if (better && error() <= limit && drop < little * error()) return;
  }
}

std::vector<Face> FitTrial::merge_possible(const std::vector<Region>& regions) {
  const std::size_t depth = journal_.depth();
  const Plainness plain = plainness();
  std::vector<Face> merged;
  for (const Region& region : regions) {
    const Face face = merge_region(journal_, region);
    if (face.valid()) merged.push_back(face);
  }
  if (keeps_plain_ && !merged.empty()) {
    // The sides of the neighbours have changed.
    journal_.begin();
    plain.keep_coons(journal_, depth);
  }
  return merged;
}

void FitTrial::go_back(const State& state) {
  journal_.undo_to(state.depth);
  error_.restore(state.error);
}

std::unique_ptr<FitTrial::Fork> FitTrial::fork() {
  return std::make_unique<Fork>(mesh(), error_.fork(), keeps_plain_);
}

}  // namespace gradmesh
