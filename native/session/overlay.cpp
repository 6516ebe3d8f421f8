#include "session/overlay.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/clamped_int.h"
#include "draw/backdrop.h"
#include "draw/heat_scale.h"
#include "draw/part_tints.h"
#include "mesh/boundary.h"
#include "session/pointing.h"

namespace gradmesh {
namespace {

/// As drawings of the same things have them (draw/), so that they can be told apart without seeing
/// red or green.
const Ink thin_ink{glm::dvec3(0.36, 0.38, 0.44), 0.9, 1.0};
const Ink unmergeable_ink{glm::dvec3(0.0, 0.47, 0.71), 1.0, 1.8};
const Ink costly_ink{glm::dvec3(0.78, 0.06, 0.18), 1.0, 3.0};
const Ink traced_ink{glm::dvec3(0.11, 0.11, 0.14), 1.0, 2.0};
const Ink region_ink{glm::dvec3(0.0, 0.45, 0.70), 0.35, 3.0};
const Ink patch_ink{glm::dvec3(0.84, 0.37, 0.0), 0.7, 2.0};
constexpr double width_of_prices = 3.2;
/// Below prices, whose pale colours would not be seen on white.
const Ink rim_ink{glm::dvec3(0.2, 0.2, 0.25), 0.45, 4.8};

/// Lines are lighter than tints of the same colour.
Ink opaque(Ink ink) {
  ink.opacity = 1;
  return ink;
}

}  // namespace

void Overlay::fade(Image& picture) {
  constexpr double left = 0.45;
  make_gray(picture);
  for (std::uint8_t& sample : picture.samples)
    sample = std::uint8_t(std::lround(255 - left * (255 - sample)));
}

void Overlay::draw_curves(const std::vector<Halfedge>& curves, const Ink& ink) {
  std::vector<std::vector<glm::dvec2>> lines;
  for (const Halfedge curve : curves)
    lines.push_back(points_along(mesh_.curve_of(curve), to_pixels_));
  canvas_.lines(lines, ink);
}

void Overlay::draw_sides(const std::vector<Halfedge>& sides, const Ink& ink) {
  std::vector<std::vector<glm::dvec2>> lines;
  for (const Halfedge side : sides) lines.push_back(points_along(mesh_.side_of(side), to_pixels_));
  canvas_.lines(lines, ink);
}

void Overlay::tint(const std::vector<Face>& faces, const Ink& ink) {
  std::vector<bool> is_one(mesh_.face_slots(), false);
  for (const Face face : faces) is_one[std::size_t(face.value)] = true;
  canvas_.tint([&](int x, int y) {
    const Face face = TopFace(*top_.at(x, y)).face();
    return face.valid() && is_one[std::size_t(face.value)] ? &ink : nullptr;
  });
}

void Overlay::draw_prices(const std::vector<CurvePrice>& prices) {
  const std::vector<Halfedge> curves = mesh_.curves();
  draw_curves(curves, thin_ink);
  // One drawing for each colour, as many as can be told apart, from the cheap to the costly.
  const HeatScale scale = scale_of(prices);
  constexpr int steps = 32;
  std::map<int, std::vector<Halfedge>> by_step;
  std::vector<Halfedge> unmergeable;
  for (const CurvePrice& price : prices)
    if (std::isfinite(price.error))
      by_step[clamped_int(std::round(steps * scale.position(price.error)), 0, steps)].push_back(
          price.curve);
    else
      unmergeable.push_back(price.curve);
  draw_curves(unmergeable, unmergeable_ink);
  for (const auto& [step, of_step] : by_step) draw_curves(of_step, rim_ink);
  for (const auto& [step, of_step] : by_step)
    draw_curves(of_step, {HeatScale::rgb_at(double(step) / steps), 1.0, width_of_prices});
}

void Overlay::draw_region(Face patch, const RegionPrice* region) {
  draw_curves(mesh_.curves(), thin_ink);
  if (region) {
    tint(region->patches, region_ink);
    draw_sides(outer_sides(mesh_, region->patches), opaque(region_ink));
  }
  tint({patch}, patch_ink);
  draw_sides(outer_sides(mesh_, {patch}), opaque(patch_ink));
}

void Overlay::draw_parts(const MotorcycleGraph& graph) {
  const PartTints tints(mesh_, graph);
  std::vector<Ink> inks(graph.parts.size());
  for (std::size_t i = 0; i < inks.size(); ++i) inks[i] = {tints.color(int(i)), part_opacity};
  canvas_.tint([&](int x, int y) {
    const Face face = TopFace(*top_.at(x, y)).face();
    const int part = face.valid() ? tints.part(face) : -1;
    return part < 0 ? nullptr : &inks[std::size_t(part)];
  });
  draw_curves(mesh_.curves(), thin_ink);
  draw_curves(graph.unmergeable, unmergeable_ink);
  draw_curves(graph.traced, traced_ink);
  draw_curves(graph.costly, costly_ink);
}

}  // namespace gradmesh
