#include "window/view/eye_window.h"

#include <imgui.h>

#include <algorithm>

#include "window/toolkit/theme.h"
#include "window/view/panel.h"
#include "window/view/shortcuts.h"

namespace gradmesh {
namespace {

constexpr ImGuiWindowFlags fixed_flags =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

void begin(const char* name, float left, float top, float width, float height,
           ImGuiWindowFlags more = 0) {
  ImGui::SetNextWindowPos({left, top});
  ImGui::SetNextWindowSize({width, height});
  ImGui::Begin(name, nullptr, fixed_flags | more);
}

}  // namespace

bool EyeWindow::show(const Happened& happened) {
  ui_.begin_frame();
  set_theme(is_dark_, float(eye_.density));
  take_keys(happened);
  eye_.look_for_news(ImGui::IsMouseDown(ImGuiMouseButton_Left));
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float em = ImGui::GetFontSize(), panel = 26 * em, line = 3.6F * em;
  show_panel(size.x - panel, panel, size.y);
  show_picture(size.x - panel, size.y - line);
  show_hint(size.y, size.x - panel, line);
  show_question();
  return end_ == End::not_yet;
}

void EyeWindow::take_keys(const Happened& happened) {
  if (happened.must_close) ask_to_close();
  if (ImGui::GetIO().WantTextInput) return;
  for (const Key& key : happened.keys) {
    if (must_ask_) {
      answer(key);
      continue;
    }
    if (key.is_down && key.name == "Escape" && Ui::close_popup()) continue;
    const WindowKey meant = press(key, eye_, toolbox_);
    if (meant == WindowKey::apply && !eye_.changed().empty()) end_ = End::apply;
    if (meant == WindowKey::escape) ask_to_close();
  }
}

void EyeWindow::answer(const Key& key) {
  if (!key.is_down) return;
  const bool applies = key.held.control && (key.name == "Return" || key.name == "Keypad Enter");
  if (applies) end_ = End::apply;
  if (applies || key.name == "Escape") must_ask_ = false;
}

void EyeWindow::ask_to_close() {
  if (eye_.has_hand_work())
    must_ask_ = true;
  else
    end_ = End::cancel;
}

void EyeWindow::show_panel(float left, float width, float height) {
  const float end = ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().WindowPadding.y;
  begin("panel", left, 0, width, height - end);
  const Panel panel{ui_, eye_, toolbox_};
  show_meshes(panel);
  show_color(panel);
  show_structure(panel);
  show_curve(panel);
  show_looks(panel);
  show_tools(panel);
  show_marked(panel);
  show_worst_places(panel);
  ui_.check(Message("Dark"), Message("Dark or light, from now on"), is_dark_);
  ImGui::End();
  begin("ends", left, height - end, width, end, ImGuiWindowFlags_NoScrollbar);
  show_ends();
  ImGui::End();
}

void EyeWindow::show_ends() {
  const float width = Ui::share(2);
  if (ui_.button(Message("Cancel"), Message("Leave the document as it was (Escape)"), true, width))
    ask_to_close();
  Ui::beside();
  if (ui_.button(Message("Apply"), Message("Write what is shown into the document (Ctrl+Enter)"),
                 !eye_.changed().empty(), width))
    end_ = End::apply;
}

void EyeWindow::show_question() {
  if (!must_ask_) return;
  const std::string title = ui_.said(Message("Simplify by Eye"));
  ImGui::OpenPopup(title.c_str());
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  if (!ImGui::BeginPopupModal(title.c_str(), nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
  ImGui::TextUnformatted(ui_.said(Message("Write the changed mesh into the document?")).c_str());
  const Message discard = Message("Discard"), back = Message("Go Back"), apply = Message("Apply");
  float width = 0;
  for (const Message& label : {discard, back, apply})
    width = std::max(width, Ui::width_of(ui_.said(label)));
  const auto offer = [&](const Message& label, const Message& tip, End end) {
    if (!ui_.button(label, tip, true, width)) return;
    end_ = end;
    must_ask_ = false;
    ImGui::CloseCurrentPopup();
  };
  offer(discard, Message("Leave the document as it was"), End::cancel);
  Ui::beside();
  offer(back, Message("Go on with the mesh (Escape)"), End::not_yet);
  Ui::beside();
  offer(apply, Message("Write what is shown into the document (Ctrl+Enter)"), End::apply);
  ImGui::EndPopup();
}

void EyeWindow::show_picture(float width, float height) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  begin("picture", 0, 0, width, height,
        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  area_.show(eye_, toolbox_, ui_);
  ImGui::End();
  ImGui::PopStyleVar();
}

void EyeWindow::show_hint(float end, float width, float least) {
  const auto sentence = [&] {
    if (eye_.picks_color)
      return ui_.said(
          Message("Click the picture where it has the colour that the point shall have "
                  "(Escape: none)."));
    if (eye_.refusal()) return ui_.said(*eye_.refusal());
    if (eye_.why_not()) return ui_.said(Message("Here nothing can be done: {0}", *eye_.why_not()));
    const auto hint = toolbox_.in_hand().hint(eye_);
    return hint ? ui_.said(*hint) : std::string();
  };
  const std::string words = sentence();
  const ImVec2 margin = ImGui::GetStyle().WindowPadding;
  // What is longer lies over the picture, which keeps its size.
  const ImVec2 needed = ImGui::CalcTextSize(words.c_str(), nullptr, false, width - 2 * margin.x);
  const float height = std::max(least, needed.y + 2 * margin.y);
  begin("hint", 0, end - height, width, height, ImGuiWindowFlags_NoScrollbar);
  ui_.text(words);
  ImGui::End();
}

}  // namespace gradmesh
