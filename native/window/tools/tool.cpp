#include "window/tools/tool.h"

#include <imgui.h>

namespace gradmesh {
namespace {

/// Colours that are seen on light and dark pictures, the dark one below.
constexpr ImU32 below = IM_COL32(20, 20, 20, 150), outline_color = IM_COL32(0, 153, 255, 255),
                picked_color = IM_COL32(255, 200, 0, 255);

ImU32 color_of(Pen::Ink ink) { return ink == Pen::Ink::outline ? outline_color : picked_color; }

}  // namespace

void Pen::line(const std::vector<glm::dvec2>& points, bool is_closed, Ink ink) const {
  std::vector<ImVec2> places;
  for (const glm::dvec2 p : points)
    places.emplace_back(float(corner_.x + p.x), float(corner_.y + p.y));
  const ImDrawFlags flags = is_closed ? ImDrawFlags_Closed : ImDrawFlags_None;
  const float width = float(2 * density_);
  list_.AddPolyline(places.data(), int(places.size()), below, flags, 2 * width);
  list_.AddPolyline(places.data(), int(places.size()), color_of(ink), flags, width);
}

void Pen::dot(glm::dvec2 place, Ink ink) const {
  const ImVec2 at{float(corner_.x + place.x), float(corner_.y + place.y)};
  list_.AddCircleFilled(at, float(6 * density_), below);
  list_.AddCircleFilled(at, float(4.5 * density_), color_of(ink));
}

}  // namespace gradmesh
