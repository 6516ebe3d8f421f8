#include "methods/merging/motorcycle.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "mesh/boundary.h"
#include "mesh/region.h"
#include "methods/merging/grid.h"
#include "ops/merge/merge.h"

namespace gradmesh {
namespace {

/// The four half-edges that start at a regular point inside the mesh, in circular order.
using Fan = std::array<Halfedge, 4>;

std::optional<Fan> fan_at(const Mesh& mesh, Halfedge leaf) {
  Fan fan;
  Halfedge h = leaf;
  for (Halfedge& spoke : fan) {
    spoke = h;
    h = leaf_across(mesh, mesh.prev(h));
    if (!h.valid()) return std::nullopt;
  }
  return h == leaf ? std::optional(fan) : std::nullopt;
}

class Tracer {
 public:
  explicit Tracer(const Mesh& mesh) : mesh_(mesh), marked_(mesh.halfedge_slots(), false) {}

  void mark(Halfedge edge) { marked_[mesh_.curve(edge).value] = true; }
  bool is_marked(Halfedge edge) const { return marked_[mesh_.curve(edge).value]; }

  /// Traces paths until the marked edges leave rectangles everywhere. Returns the edges added.
  std::vector<Halfedge> run() {
    bool traced = true;
    while (traced) {
      traced = false;
      for (const Point p : mesh_.points())
        if (const Halfedge h = mesh_[p].halfedge; mesh_.is_leaf(h))
          if (const std::optional<Fan> fan = fan_at(mesh_, h)) traced = extend(*fan) || traced;
    }
    return added_;
  }

 private:
  using Path = std::vector<Halfedge>;

  /// Starts paths at a point where a marked edge ends, or where two marked edges make a bend; the
  /// shorter of the two ways to do so is taken. At other points the edges meet in right angles
  /// already.
  bool extend(const Fan& fan) {
    std::vector<int> marked;
    for (int k = 0; k < 4; ++k)
      if (is_marked(fan[k])) marked.push_back(k);
    const auto from = [&](int k) { return path(fan[k % 4]); };
    if (marked.size() == 1) {
      Path straight = from(marked[0] + 2), across = from(marked[0] + 1);
      const Path other = from(marked[0] + 3);
      across.insert(across.end(), other.begin(), other.end());
      take(straight.size() <= across.size() ? straight : across);
      return true;
    }
    if (marked.size() == 2 && (marked[1] - marked[0]) % 2 == 1) {
      const Path first = from(marked[0] + 2), second = from(marked[1] + 2);
      take(first.size() <= second.size() ? first : second);
      return true;
    }
    return false;
  }

  /// Returns the edges straight on from a spoke, up to a marked edge, the boundary or an irregular
  /// point.
  Path path(Halfedge spoke) const {
    Path edges;
    for (Halfedge h = spoke; h.valid();) {
      edges.push_back(h);
      const std::optional<Fan> end = fan_at(mesh_, mesh_[h].twin);
      if (!end || std::any_of(end->begin() + 1, end->end(),
                              [&](Halfedge other) { return is_marked(other); }))
        break;
      h = (*end)[2];
      if (h == spoke) break;  // once round a ring
    }
    return edges;
  }

  void take(const Path& path) {
    for (const Halfedge h : path) {
      mark(h);
      added_.push_back(mesh_.curve(h));
    }
  }

  const Mesh& mesh_;
  std::vector<bool> marked_;
  std::vector<Halfedge> added_;
};

}  // namespace

MotorcycleGraph motorcycle_graph(const Mesh& mesh, const std::vector<EdgePrice>& prices,
                                 double limit) {
  MotorcycleGraph graph;
  Tracer marks(mesh);
  for (const EdgePrice& p : prices) {
    const bool mergeable = p.obstacle == MergeObstacle::none;
    if (mergeable && p.error <= limit) continue;
    (mergeable ? graph.costly : graph.unmergeable).push_back(p.edge);
    marks.mark(p.edge);
  }
  graph.traced = marks.run();

  const std::vector<int> part =
      face_components(mesh, [&](Halfedge h) { return marks.is_marked(h); });
  std::vector<std::vector<Halfedge>> edges(mesh.face_slots());
  std::vector<double> sum(mesh.face_slots(), 0);
  for (const EdgePrice& p : prices)
    if (!marks.is_marked(p.edge)) {
      const int i = part[mesh.face(p.edge).value];
      edges[i].push_back(p.edge);
      sum[i] += p.error;
    }
  std::vector<int> order(edges.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](int a, int b) { return sum[a] < sum[b]; });
  for (const int i : order)
    if (!edges[i].empty()) graph.parts.push_back(std::move(edges[i]));
  return graph;
}

std::vector<Halfedge> motorcycle_order(const Mesh& mesh, const MotorcycleGraph& graph,
                                       std::uint64_t seed) {
  std::vector<int> part(mesh.halfedge_slots(), -1);
  for (std::size_t i = 0; i < graph.parts.size(); ++i)
    for (const Halfedge edge : graph.parts[i]) part[mesh.curve(edge).value] = int(i);
  std::vector<Halfedge> order = grid_order(mesh, seed);
  const auto part_of = [&](Halfedge h) { return part[mesh.curve(h).value]; };
  std::erase_if(order, [&](Halfedge h) { return part_of(h) < 0; });
  std::ranges::stable_sort(order, [&](Halfedge a, Halfedge b) { return part_of(a) < part_of(b); });
  return order;
}

void select_motorcycle(MergeTrial& trial, PriceTable& analysis, const MotorcycleOptions& options,
                       StopWatch& watch) {
  const std::size_t depth = trial.depth();
  const auto order = [&](const Mesh& mesh) {
    PriceTable afresh{analysis.key, {}};
    const std::vector<EdgePrice> prices =
        price_edges(trial, trial.depth() == depth ? analysis : afresh, watch);
    const auto graph = motorcycle_graph(mesh, prices, options.kappa * trial.epsilon());
    return motorcycle_order(mesh, graph, options.seed);
  };
  try_edges(trial, order, watch);
}

}  // namespace gradmesh
