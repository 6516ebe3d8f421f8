#include "methods/best/handle_drops.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "methods/merging/portions.h"
#include "methods/plain/flaws.h"
#include "pricing/parallel_trials.h"

namespace gradmesh {
namespace {

/// Returns how far a curve goes from its chord, in pixels, or a little more.
double bulge(const Cubic<Value>& curve, const Frame& frame) {
  const Cubic<glm::dvec2> line = in_pixels(curve, frame);
  const glm::dvec2 chord = line.p1 - line.p0;
  return (glm::length(line.m0 - chord) + glm::length(line.m1 - chord)) / 4;
}

/// Returns how many leaves lie along the divided sides of a curve.
int leaves_along(const Mesh& mesh, Halfedge curve) {
  int count = 0;
  for (const Halfedge side : {curve, mesh[curve].twin})
    if (side.valid() && mesh.is_parent(side))
      for ([[maybe_unused]] const Halfedge leaf : mesh.leaves(side)) ++count;
  return count;
}

double largest(const glm::dvec4& v) { return std::max({v.r, v.g, v.b, v.a}); }

}  // namespace

bool HandleDrops::drop_some(double limit) {
  constexpr int fits = 2;
  const std::vector<HandleDrop> steps = cheapest_first();
  std::size_t count = std::min(most_, first_portion(steps.size()));
  int too_much = 0;
  for (std::size_t first = 0; first < steps.size() && !should_stop_();) {
    const auto begin = steps.begin() + std::ptrdiff_t(first);
    const std::vector<HandleDrop> some(
        begin, begin + std::ptrdiff_t(std::min(count, steps.size() - first)));
    if (trial_.try_drops(some, limit, fits, keeps_)) {
      most_ = 2 * some.size();
      return true;
    }
    if (count > 1) {
      count = smaller_portion(count);
    } else if (++first; ++too_much >= most_in_a_row) {
      break;
    }
  }
  return false;
}

std::vector<HandleDrop> HandleDrops::cheapest_first() const {
  const std::vector<Way> all = ways();
  std::vector<std::pair<double, std::size_t>> order(all.size());
  ParallelTrials<FitTrial>(trial_).for_each(
      all.size(), [&](std::size_t) { return should_stop_(); },
      [&](FitTrial& own, std::size_t i) {
        order[i] = {own.price(all[i].step) / all[i].saves, i};
      });
  std::ranges::sort(order);
  std::vector<HandleDrop> steps;
  for (const auto& [price, i] : order) steps.push_back(all[i].step);
  return steps;
}

std::vector<HandleDrops::Way> HandleDrops::ways() const {
  const Mesh& mesh = trial_.mesh();
  const Plainness now(mesh);
  std::vector<Way> ways;
  for (const Halfedge h : mesh.curves())
    // Each leaf along a divided side has two handles of its own in its block.
    if (!is_beside_fixed(h) && may_be_straight(h, now))
      ways.push_back({{h, {}}, 2 + 2 * leaves_along(mesh, h)});
  for (const Face f : mesh.faces())
    if (!now.is_coons(f) && !mesh.is_fixed(f)) ways.push_back({{{}, f}, 4});
  return ways;
}

/// Returns true if a patch beside the curve must stay as it is.
bool HandleDrops::is_beside_fixed(Halfedge curve) const {
  const Mesh& mesh = trial_.mesh();
  for (const Halfedge side : {curve, mesh[curve].twin})
    if (side.valid())
      for (const Halfedge leaf : mesh.leaves(side))
        if (mesh.is_fixed(mesh.face(leaf))) return true;
  return false;
}

bool HandleDrops::may_be_straight(Halfedge curve, const Plainness& now) const {
  const Mesh& mesh = trial_.mesh();
  if (now.is_straight(curve) || makes_corner(curve, 0, now) || makes_corner(curve, 1, now))
    return false;
  return !is_outline(mesh, curve) ||
         bulge(mesh.curve_of(curve), trial_.reference().frame()) <= seen_gap;
}

bool HandleDrops::makes_corner(Halfedge curve, int end, const Plainness& now) const {
  const Mesh& mesh = trial_.mesh();
  const auto opposite = at_first_.opposite(mesh[curve].handles[std::size_t(end)]);
  if (!opposite || !now.is_straight(opposite->curve)) return false;
  const Point at = end == 0 ? mesh.origin(curve) : mesh.end(curve);
  const auto away = [&](Halfedge line) {
    const Point other = mesh.origin(line) == at ? mesh.end(line) : mesh.origin(line);
    return glm::normalize(mesh.position(other) - mesh.position(at));
  };
  const glm::dvec2 a = away(curve), b = away(opposite->curve);
  double contrast = 0;
  for (const Halfedge beside : now.curves_at(at)) {
    if (beside == curve || beside == opposite->curve) continue;
    const Cubic<Value> line = mesh.curve_of(beside);
    contrast = std::max(contrast, largest(glm::abs(line.p1.color - line.p0.color)));
  }
  return contrast * std::abs(a.x * b.y - a.y * b.x) > seen_corner;
}

}  // namespace gradmesh
