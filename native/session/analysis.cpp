#include "session/analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "session/curve_search.h"
#include "session/edits.h"
#include "simplify/options.h"
#include "simplify/simplify.h"

namespace gradmesh {
namespace {

constexpr double no_price = std::numeric_limits<double>::infinity();

/// Returns a problem over another mesh, whose regions are those within the error of Balanced.
Problem problem_over(const Problem& problem, const Mesh& mesh) {
  const auto balanced = std::ranges::find(all_amounts(), std::string("balanced"), &Amount::name);
  Problem over = problem.with_mesh(std::make_shared<const Mesh>(mesh));
  over.bounds = {bounds_of(*balanced, problem.metric()).epsilon};
  return over;
}

std::vector<CurvePrice> prices_of_edges(const std::vector<EdgePrice>& edges) {
  std::vector<CurvePrice> prices;
  for (const EdgePrice& edge : edges) prices.push_back({edge.edge, edge.error});
  return prices;
}

}  // namespace

AnalysisKind analysis_named(const std::string& name) {
  if (name == "prices") return AnalysisKind::prices;
  if (name == "regions") return AnalysisKind::regions;
  if (name == "parts") return AnalysisKind::parts;
  throw std::invalid_argument("analyses are prices, regions and parts, not '" + name + "'.");
}

HeatScale scale_of(const std::vector<CurvePrice>& prices) {
  double lowest = no_price, highest = 0;
  for (const CurvePrice& price : prices)
    if (std::isfinite(price.error)) {
      lowest = std::min(lowest, price.error);
      highest = std::max(highest, price.error);
    }
  // Where nothing costs anything, all lines are at the low end of some scale.
  if (highest <= 0) return HeatScale(1e-3);
  if (lowest <= 0) return HeatScale(highest);
  return HeatScale(highest, std::clamp(std::log10(highest / lowest), 1.0, HeatScale::decades));
}

std::vector<RegionPrice> largest_regions(const Analysis& analysis, Face patch) {
  std::vector<RegionPrice> regions = regions_with(analysis.regions, patch);
  std::ranges::reverse(regions);
  return regions;
}

AnalysisSearch::AnalysisSearch(const Problem& problem, MeshKind form, const Candidate& shown,
                               bool fits)
    : problem_(problem_over(problem, shown.mesh)), form_(form), shown_(shown), fits_(fits) {}

void AnalysisSearch::request(AnalysisKind kind) {
  {
    const std::lock_guard lock(mutex_);
    if (!found_.try_emplace(kind).second) return;
  }
  worker_.add([this, kind](const std::atomic<bool>& must_end) {
    Analysis analysis;
    analysis.failure = failure_of([&] { analysis = search(kind, must_end); });
    if (must_end) return;
    const std::lock_guard lock(mutex_);
    found_[kind] = std::make_shared<const Analysis>(std::move(analysis));
  });
}

std::shared_ptr<const Analysis> AnalysisSearch::found(AnalysisKind kind) const {
  const std::lock_guard lock(mutex_);
  const auto place = found_.find(kind);
  return place == found_.end() ? nullptr : place->second;
}

Analysis AnalysisSearch::search(AnalysisKind kind, const std::atomic<bool>& must_end) const {
  if (kind == AnalysisKind::prices && form_ == MeshKind::one_gradient)
    return {.prices = prices_of_lines(must_end)};
  StopWatch watch(0, [&](const Progress&) { return !must_end; });
  if (kind == AnalysisKind::regions) return {.regions = analyze_regions(problem_, watch)};
  const std::vector<EdgePrice> edges = analyze_edges(problem_, watch);
  if (kind == AnalysisKind::prices) return {.prices = prices_of_edges(edges)};
  const double limit = problem_.options.kappa * problem_.bounds.epsilon;
  return {.parts = motorcycle_graph(problem_.mesh(), edges, limit), .limit = limit};
}

std::vector<CurvePrice> AnalysisSearch::prices_of_lines(const std::atomic<bool>& must_end) const {
  const Mesh& mesh = problem_.mesh();
  const std::vector<std::vector<Halfedge>> lines = inner_lines(mesh);
  std::vector<double> prices(lines.size(), no_price);
  problem_.trial();
  parallel_for(lines.size(), [&](std::size_t n) {
    if (must_end) return;
    const Halfedge edge = lines[n].front();
    try {
      const EditedMesh made = edit_lines(mesh, {.face = mesh.face(edge), .edge = edge},
                                         HandEdit::merge, fits_, problem_);
      prices[n] = problem_.measure(made.mesh, &shown_).error - shown_.error;
    } catch (const InputError&) {
      // It must stay, as something beside it is protected.
    }
  });
  std::vector<CurvePrice> all;
  for (std::size_t n = 0; n < lines.size(); ++n)
    for (const Halfedge curve : lines[n]) all.push_back({curve, prices[n]});
  return all;
}

}  // namespace gradmesh
