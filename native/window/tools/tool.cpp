#include "window/tools/tool.h"

#include <imgui.h>

namespace gradmesh {
namespace {

/// Colours that are seen on light and dark pictures, the dark one below.
constexpr ImU32 below = IM_COL32(20, 20, 20, 150), ground_of_words = IM_COL32(20, 20, 20, 190),
                outline_color = IM_COL32(0, 153, 255, 255),
                picked_color = IM_COL32(255, 200, 0, 255),
                forbids_color = IM_COL32(230, 40, 30, 255);

ImU32 color_of(Pen::Ink ink) {
  if (ink == Pen::Ink::forbids) return forbids_color;
  return ink == Pen::Ink::outline ? outline_color : picked_color;
}

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

void Pen::circle(glm::dvec2 middle, double radius, Ink ink) const {
  const ImVec2 at{float(corner_.x + middle.x), float(corner_.y + middle.y)};
  const float width = float(2 * density_), size = float(radius * density_);
  list_.AddCircle(at, size, below, 0, 2 * width);
  list_.AddCircle(at, size, color_of(ink), 0, width);
}

void Pen::words(glm::dvec2 place, const std::string& text, double aside) const {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float margin = float(4 * density_);
  const ImVec2 at{float(corner_.x + place.x) - float(aside) * size.x, float(corner_.y + place.y)};
  list_.AddRectFilled({at.x - margin, at.y - margin / 2},
                      {at.x + size.x + margin, at.y + size.y + margin / 2}, ground_of_words,
                      margin);
  list_.AddText(at, IM_COL32_WHITE, text.c_str());
}

std::vector<glm::dvec2> points_around(const Mesh& mesh, Face face, const Affine& to_pixels) {
  std::vector<glm::dvec2> around;
  for (const Halfedge side : mesh.sides(face))
    for (const glm::dvec2 p : points_along(mesh.side_of(side), to_pixels)) around.push_back(p);
  return around;
}

}  // namespace gradmesh
