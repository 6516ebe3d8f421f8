#include <imgui.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "ops/color.h"
#include "window/eye/words.h"
#include "window/view/panel.h"

namespace gradmesh {
namespace {

/// Hue in degrees, saturation and value in per cent.
struct Hsv {
  int hue, saturation, value;
};

/// Greys have no hue, and black no saturation: what was shown last stays.
Hsv hsv_of(const glm::dvec3& rgb) {
  float hue = 0, saturation = 0, value = 0;
  ImGui::ColorConvertRGBtoHSV(float(rgb.r), float(rgb.g), float(rgb.b), hue, saturation, value);
  ImGuiStorage& kept = *ImGui::GetStateStorage();
  float& kept_saturation = *kept.GetFloatRef(ImGui::GetID("kept saturation"));
  float& kept_hue = *kept.GetFloatRef(ImGui::GetID("kept hue"));
  if (value > 0) kept_saturation = saturation;
  if (saturation > 0) kept_hue = hue;
  return {int(std::lround(360 * kept_hue)), int(std::lround(100 * kept_saturation)),
          int(std::lround(100 * value))};
}

glm::dvec3 rgb_of(const Hsv& hsv) {
  float r = 0, g = 0, b = 0;
  ImGui::ColorConvertHSVtoRGB(float(hsv.hue % 360) / 360, float(hsv.saturation) / 100,
                              float(hsv.value) / 100, r, g, b);
  return {r, g, b};
}

std::string hex_of(const glm::dvec3& rgb) {
  char text[8];
  std::snprintf(text, sizeof text, "%02x%02x%02x", unsigned(std::lround(255 * rgb.r)),
                unsigned(std::lround(255 * rgb.g)), unsigned(std::lround(255 * rgb.b)));
  return text;
}

/// Returns the colour of six digits, or of three, which count twice each.
std::optional<glm::dvec3> rgb_of_hex(std::string text) {
  if (text.size() == 3) text = {text[0], text[0], text[1], text[1], text[2], text[2]};
  if (text.size() != 6) return std::nullopt;
  const long number = std::strtol(text.c_str(), nullptr, 16);
  return glm::dvec3(number >> 16, number >> 8 & 255, number & 255) / 255.0;
}

/// The fields by which a colour is chosen. Each tells what is chosen while a person moves it, and
/// when it is let go.
class ColorFields {
 public:
  ColorFields(const Panel& panel, const glm::dvec3& now) : panel_(panel), chosen_(now) {}

  void show() {
    swatch();
    Ui::beside();
    const float width = Ui::share(3);
    Hsv hsv = hsv_of(chosen_);
    const bool hue = number("hue", "%d°", hsv.hue, 360, width);
    Ui::beside();
    const bool saturation = number("saturation", "%d %%", hsv.saturation, 100, width);
    Ui::beside();
    const bool value = number("value", "%d %%", hsv.value, 100, width);
    if (hue || saturation || value) choose(rgb_of(hsv));
    hex();
    Ui::beside();
    if (panel_.ui.choice(Message("From the picture"),
                         Message("Click the picture, and the point gets the colour there. Show the "
                                 "original to take a colour from it"),
                         panel_.eye.picks_color))
      panel_.eye.picks_color = !panel_.eye.picks_color;
  }

  bool has_changed() const { return has_changed_; }
  bool is_let_go() const { return is_let_go_; }
  const glm::dvec3& chosen() const { return chosen_; }

 private:
  void choose(const glm::dvec3& rgb) {
    chosen_ = rgb;
    has_changed_ = true;
  }

  void swatch() {
    const float side = ImGui::GetFrameHeight();
    const ImVec4 shown{float(chosen_.r), float(chosen_.g), float(chosen_.b), 1};
    if (ImGui::ColorButton("swatch", shown,
                           ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                           {2 * side, side}))
      ImGui::OpenPopup("picker");
    panel_.ui.note("colour");
    panel_.ui.tip(Message("Choose the colour of the point"));
    if (!ImGui::BeginPopup("picker")) return;
    float rgb[] = {shown.x, shown.y, shown.z};
    if (ImGui::ColorPicker3("##picker", rgb,
                            ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoSidePreview |
                                ImGuiColorEditFlags_NoOptions))
      choose({rgb[0], rgb[1], rgb[2]});
    is_let_go_ = is_let_go_ || ImGui::IsItemDeactivatedAfterEdit();
    ImGui::EndPopup();
  }

  bool number(const char* name, const char* format, int& number, int most, float width) {
    ImGui::PushID(name);
    ImGui::SetNextItemWidth(width);
    const bool has_moved =
        ImGui::DragInt("##number", &number, 0.5F, 0, most, format, ImGuiSliderFlags_AlwaysClamp);
    is_let_go_ = is_let_go_ || ImGui::IsItemDeactivatedAfterEdit();
    ImGui::PopID();
    panel_.ui.note(name);
    if (!ImGui::IsItemActive())
      panel_.ui.tip(Message("Hue, saturation and value: drag, or double-click to type"));
    return has_moved;
  }

  void hex() {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "%s", hex_of(chosen_).c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("#");
    Ui::beside();
    ImGui::SetNextItemWidth(5 * ImGui::GetFontSize());
    ImGui::InputText("##hex", text.data(), text.size(), ImGuiInputTextFlags_CharsHexadecimal);
    panel_.ui.note("hex");
    if (!ImGui::IsItemDeactivatedAfterEdit()) return;
    if (const auto rgb = rgb_of_hex(text.data())) choose(*rgb);
    is_let_go_ = has_changed_;
  }

  const Panel& panel_;
  glm::dvec3 chosen_;
  bool has_changed_ = false, is_let_go_ = false;
};

}  // namespace

void show_color(const Panel& panel) {
  Eye& eye = panel.eye;
  const Point point = eye.element.point;
  const Mesh& mesh = eye.session().mesh();
  if (!point.valid()) return;
  const std::vector<Halfedge> corners = corners_at(mesh, point);
  if (corners.empty()) return;
  panel.ui.heading(Message("Colour of the point"));
  ColorFields fields(panel, eye.chosen_color.value_or(glm::dvec3(mesh[corners.front()].color)));
  fields.show();
  if (fields.has_changed()) eye.propose_color(fields.chosen());
  if (fields.is_let_go() && eye.chosen_color) eye.make_color();
}

}  // namespace gradmesh
