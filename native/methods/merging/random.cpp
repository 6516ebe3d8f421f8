#include "methods/merging/random.h"

#include <random>
#include <utility>

#include "methods/merging/edges.h"

namespace gradmesh {

std::vector<Halfedge> random_order(const Mesh& mesh, std::uint64_t seed) {
  std::vector<Halfedge> edges = inner_edges(mesh);
  std::mt19937_64 random(seed);
  // Not std::shuffle, whose draws differ between libraries.
  for (std::size_t i = edges.size(); i > 1; --i) std::swap(edges[i - 1], edges[random() % i]);
  return edges;
}

}  // namespace gradmesh
