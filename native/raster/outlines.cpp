#include "raster/outlines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/clamped_int.h"

namespace gradmesh {
namespace {

constexpr int most_steps = 2048;

using PixelCurve = Cubic<glm::dvec2>;

/// Returns the number of straight pieces of a curve. A cubic's second derivative is at most 6 times
/// the second difference of its control points, and a chord over 1/n of the curve is off by at most
/// an eighth of that over n^2.
int steps_of(const PixelCurve& curve) {
  const glm::dvec2 b1 = curve.bezier1(), b2 = curve.bezier2();
  const glm::dvec2 first = curve.p0 - 2.0 * b1 + b2, second = b1 - 2.0 * b2 + curve.p1;
  const double bend = 6 * std::sqrt(std::max(glm::dot(first, first), glm::dot(second, second)));
  return clamped_int(std::ceil(std::sqrt(bend / (8 * flatness))), 1, most_steps);
}

PixelCurve in_pixels(const Cubic<Value>& curve, const Affine& to_pixels) {
  return {to_pixels.point(curve.p0.position), to_pixels.vector(curve.m0.position),
          to_pixels.vector(curve.m1.position), to_pixels.point(curve.p1.position)};
}

}  // namespace

void Outlines::start(const Mesh& mesh, const Frame& frame) {
  mesh_ = &mesh;
  frame_ = &frame;
  cuts_.clear();
  ++starts_;
  if (ranges_.size() < mesh.halfedge_slots()) ranges_.resize(mesh.halfedge_slots());
}

void Outlines::add_stems(Halfedge side, bool backwards) {
  for (Halfedge c = (*mesh_)[side].first_child; c.valid(); c = (*mesh_)[c].next_sibling)
    if (!mesh_->is_bar(c)) {
      const double t = (*mesh_)[c].interval.first;
      cuts_.push_back({backwards ? 1 - t : t,
                       snap(frame_->to_pixels.point(mesh_->position(mesh_->origin(c))))});
    }
}

Outlines::Range Outlines::cuts_of(Halfedge curve) {
  Range& range = ranges_[curve.value];
  if (range.start == starts_) return range;
  range.start = starts_;
  range.begin = std::uint32_t(cuts_.size());

  const PixelCurve cubic = in_pixels(mesh_->curve_of(curve), frame_->to_pixels);
  const Halfedge twin = (*mesh_)[curve].twin;
  cuts_.push_back({0, snap(cubic.p0)});
  cuts_.push_back({1, snap(cubic.p1)});
  add_stems(curve, false);
  if (twin.valid()) add_stems(twin, true);
  const int steps = steps_of(cubic);
  for (int i = 1; i < steps; ++i) {
    const double t = double(i) / steps;
    cuts_.push_back({t, snap(cubic.at(t))});
  }
  // T-junctions of both sides in one place are one cut, and an even cut beside one is none.
  const auto first = cuts_.begin() + range.begin;
  std::stable_sort(first, cuts_.end(), [](const Cut& a, const Cut& b) { return a.t < b.t; });
  const auto same = [](const Cut& a, const Cut& b) { return b.t - a.t < 1e-9; };
  cuts_.erase(std::unique(first, cuts_.end(), same), cuts_.end());
  range.end = std::uint32_t(cuts_.size());
  return range;
}

const std::vector<Outlines::Cut>& Outlines::along(Halfedge leaf) {
  const Halfedge curve = mesh_->curve(leaf);
  const bool backwards = mesh_->curve_side(leaf) != curve;
  Interval span = mesh_->span(leaf);
  if (backwards) span = {1 - span.second, 1 - span.first};
  const Range range = cuts_of(curve);
  along_.clear();
  for (std::uint32_t i = range.begin; i < range.end; ++i) {
    const Cut& cut = cuts_[i];
    if (cut.t > span.first - 1e-9 && cut.t < span.second + 1e-9)
      along_.push_back({std::clamp((cut.t - span.first) / span.length(), 0.0, 1.0), cut.point});
  }
  if (backwards) {
    std::ranges::reverse(along_);
    for (Cut& cut : along_) cut.t = 1 - cut.t;
  }
  return along_;
}

}  // namespace gradmesh
