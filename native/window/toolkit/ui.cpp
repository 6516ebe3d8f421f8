#include "window/toolkit/ui.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

namespace gradmesh {

void Ui::heading(const Message& words) {
  ImGui::Dummy({0, 0.2F * ImGui::GetFontSize()});
  ImGui::TextDisabled("%s", said(words).c_str());
  note(words.english());
}

void Ui::text(const std::string& words) {
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(words.c_str());
  ImGui::PopTextWrapPos();
}

bool Ui::button(const Message& label, const Message& tip_words, bool is_enabled, float width) {
  ImGui::PushID(label.english().c_str());
  ImGui::BeginDisabled(!is_enabled);
  const std::string words = said(label);
  const bool is_pressed = ImGui::Button(words.c_str(), {width, 0});
  if (width > 0) check_fits(words, width);
  ImGui::EndDisabled();
  ImGui::PopID();
  note(label.english());
  tip(tip_words);
  return is_pressed;
}

bool Ui::choice(const Message& label, const Message& tip_words, bool is_chosen, float width,
                bool is_enabled) {
  const ImVec4* const colors = ImGui::GetStyle().Colors;
  ImGui::PushStyleColor(ImGuiCol_Button, colors[is_chosen ? ImGuiCol_Header : ImGuiCol_Button]);
  if (is_chosen) ImGui::PushStyleColor(ImGuiCol_ButtonHovered, colors[ImGuiCol_HeaderHovered]);
  const bool is_pressed = button(label, tip_words, is_enabled, width);
  ImGui::PopStyleColor(is_chosen ? 2 : 1);
  return is_pressed;
}

bool Ui::check(const Message& label, const Message& tip_words, bool& is_on) {
  ImGui::PushID(label.english().c_str());
  const bool has_changed = ImGui::Checkbox(said(label).c_str(), &is_on);
  ImGui::PopID();
  note(label.english());
  tip(tip_words);
  return has_changed;
}

void Ui::tip(const Message& words) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(22 * ImGui::GetFontSize());
  ImGui::TextUnformatted(said(words).c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

int Ui::in_a_row(const std::vector<Message>& labels, int most) const {
  float widest = 0;
  for (const Message& label : labels)
    widest = std::max(widest, ImGui::CalcTextSize(said(label).c_str()).x);
  const float margin = ImGui::GetStyle().FramePadding.x;
  while (most > 1 && widest + margin > share(most)) --most;
  return most;
}

float Ui::width_of(const std::string& words) {
  return ImGui::CalcTextSize(words.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
}

float Ui::share(int count) {
  const float between = ImGui::GetStyle().ItemSpacing.x * float(count - 1);
  return (ImGui::GetContentRegionAvail().x - between) / float(count);
}

void Ui::beside() { ImGui::SameLine(); }

bool Ui::close_popup() {
  const int open = ImGui::GetCurrentContext()->OpenPopupStack.Size;
  if (open > 0) ImGui::ClosePopupToLevel(open - 1, true);
  return open > 0;
}

void Ui::note(const std::string& name) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  places_[name] = {(low.x + high.x) / 2, (low.y + high.y) / 2};
  const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  // Widths are rounded to pixels.
  if (high.x > end + 1) clipped_.insert(name);
}

void Ui::check_fits(const std::string& words, float width) {
  if (ImGui::CalcTextSize(words.c_str()).x > width) clipped_.insert(words);
}

std::optional<glm::dvec2> Ui::place_of(const std::string& label) const {
  const auto found = places_.find(label);
  return found == places_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace gradmesh
