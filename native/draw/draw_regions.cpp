#include <algorithm>

#include "draw/draw.h"
#include "draw/legend.h"
#include "mesh/boundary.h"

namespace gradmesh {
namespace {

constexpr const char *region_color = "#0072b2", *patch_color = "#d55e00";
/// How many lines of a list are shown on either side of the chosen one.
constexpr int lines_around = 8;

/// Returns the rows and columns of a region, "2 × 3", or the number of patches if T-junctions are
/// inside.
std::string describe(const Subject& subject, const RegionPrice& region) {
  const auto [face, top, rows, columns] = region.region;
  if (region.size() != rows * columns) return subject.say(Message("{0} patches", region.size()));
  return std::to_string(rows) + " \u00d7 " + std::to_string(columns);
}

Shape region_area(const Subject& subject, const RegionPrice& region, double opacity) {
  std::string path;
  for (const Face patch : region.patches) path += subject.outline(patch) + " ";
  return {path, {.fill = region_color, .fill_opacity = opacity}, ""};
}

/// Returns the sides of the region's patches that have no patch of the region on their other side.
Shape region_border(const Subject& subject, const RegionPrice& region, double width) {
  const Mesh& mesh = subject.mesh();
  PathText path = subject.path();
  for (const Halfedge side : outer_sides(mesh, region.patches)) {
    const Cubic<Value> curve = mesh.side_of(side);
    path.move(curve.p0.position);
    path.curve(curve);
  }
  return {path.text(), {.stroke = region_color, .stroke_width = width}, describe(subject, region)};
}

void list(Legend& legend, const Subject& subject, const std::vector<RegionPrice>& regions,
          int shown) {
  const int count = int(regions.size());
  const bool one = shown >= 0 && shown < count;
  const int first =
      one ? std::clamp(shown - lines_around, 0, std::max(0, count - 2 * lines_around)) : 0;
  const int last = std::min(count, first + 2 * lines_around);
  if (first > 0) legend.entry({"...", subject.say(Message("{0} smaller", first)), ""}, false);
  for (int i = first; i < last; ++i)
    legend.entry(
        {std::to_string(i + 1), describe(subject, regions[i]), short_number(regions[i].error)},
        i == shown);
  if (last < count)
    legend.entry({"...", subject.say(Message("{0} larger", count - last)), ""}, false);
}

}  // namespace

Drawing draw_regions(const Subject& subject, Face patch, const std::vector<RegionPrice>& regions,
                     int shown) {
  Drawing drawing = blank_drawing(subject);
  Layer curves{subject.say(Message("Curves")), {}, {}};
  for (const Halfedge h : subject.mesh().curves())
    curves.shapes.push_back(
        {subject.curve(h), {.stroke = "#5b6170", .stroke_width = subject.line_width()}, ""});
  drawing.layers.push_back(std::move(curves));

  const bool one = shown >= 0 && shown < int(regions.size());
  // Many areas upon one another stay translucent.
  const double opacity = one ? 0.35 : std::clamp(1.5 / double(regions.size() + 1), 0.03, 0.35);
  const double width = (one ? 3 : 0.8) * subject.line_width();
  Layer layer{subject.say(Message("Regions")), {}, {}};
  for (int i = 0; i < int(regions.size()); ++i)
    if (!one || i == shown) layer.shapes.push_back(region_area(subject, regions[i], opacity));
  for (int i = 0; i < int(regions.size()); ++i)
    if (!one || i == shown) layer.shapes.push_back(region_border(subject, regions[i], width));
  const Style chosen{.fill = patch_color,
                     .fill_opacity = 0.85,
                     .stroke = patch_color,
                     .stroke_width = 2 * subject.line_width()};
  layer.shapes.push_back(
      {subject.outline(patch), chosen, subject.say(Message("Patch {0}", patch.value))});
  drawing.layers.push_back(std::move(layer));

  Legend legend(subject, drawing, subject.say(Message("Regions of patch {0}", patch.value)));
  legend.gap();
  legend.area(chosen, subject.say(Message("the patch")));
  legend.area({.fill = region_color,
               .fill_opacity = 0.3,
               .stroke = region_color,
               .stroke_width = 2 * subject.line_width()},
              subject.say(one ? Message("the region shown") : Message("all its regions")));
  legend.gap();
  legend.text(subject.say(regions.empty() ? Message("No region within epsilon holds it.")
                                          : Message("Rows × columns, and the error:")));
  list(legend, subject, regions, shown);
  std::move(legend).add_to(drawing);
  return drawing;
}

}  // namespace gradmesh
