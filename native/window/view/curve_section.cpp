#include <algorithm>

#include "window/eye/words.h"
#include "window/view/chart.h"
#include "window/view/panel.h"

namespace gradmesh {
namespace {

ImU32 color(ImGuiCol which, float opacity = 1) { return ImGui::GetColorU32(which, opacity); }

Message name_of(const std::string& amount) {
  if (amount == "gentle") return Message("Gentle");
  if (amount == "balanced") return Message("Balanced");
  return Message("Strong");
}

void show_forms(const Panel& panel) {
  Eye& eye = panel.eye;
  if (eye.session().shown().kinds().size() < 2) return;
  const float width = Ui::share(2);
  const auto choose = [&](const Message& label, const Message& tip, MeshKind form) {
    const bool is_chosen = eye.session().shown().form() == form;
    if (!panel.ui.choice(label, tip, is_chosen, width) || is_chosen) return;
    eye.attempt([&](Session& session) {
      session.hands().set_form(form);
      session.curves().request(form);
    });
  };
  choose(Message("One mesh gradient"),
         Message("The mesh stays one mesh gradient: whole lines go out of it"),
         MeshKind::one_gradient);
  Ui::beside();
  choose(Message("Blocks"),
         Message("The mesh becomes blocks, which can be coarse in one place and fine in another"),
         MeshKind::blocks);
}

/// Writes the names of the amounts at their marks, as far as they do not cover each other, and how
/// many handles are left at both ends.
void write_numbers(const Panel& panel, const StateCurve& curve, const Chart& chart, ImVec2 low,
                   ImVec2 high, float below) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float free_from = low.x;
  for (const StateCurve::Mark& mark : curve.marks) {
    const std::string name = panel.ui.said(name_of(mark.amount));
    const float width = ImGui::CalcTextSize(name.c_str()).x;
    const float x = chart.place(curve.states[std::size_t(mark.state)]).x;
    const float left = std::clamp(x - width / 2, low.x, high.x - width);
    if (left < free_from) continue;
    free_from = left + width + ImGui::GetStyle().ItemSpacing.x;
    list.AddText({left, low.y}, color(ImGuiCol_TextDisabled), name.c_str());
  }
  const auto at_end = [&](const CurveState& state, bool is_last) {
    const std::string words = panel.eye.looks.by_patches
                                  ? panel.ui.said(Message("{0} patches", state.counts.patches))
                                  : panel.ui.said(Message("{0} handles", state.counts.handles));
    const float left = is_last ? high.x - ImGui::CalcTextSize(words.c_str()).x : low.x;
    list.AddText({left, below}, color(ImGuiCol_TextDisabled), words.c_str());
  };
  at_end(curve.states.front(), false);
  at_end(curve.states.back(), true);
}

/// Draws the curve, the marks of the amounts, and the knob at what is shown.
void draw_curve(const StateCurve& curve, const Chart& chart, const Eye& eye, ImVec2 low,
                ImVec2 high, float track) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float em = ImGui::GetFontSize();
  for (const StateCurve::Mark& mark : curve.marks) {
    const float x = chart.place(curve.states[std::size_t(mark.state)]).x;
    list.AddLine({x, low.y + 1.3F * em}, {x, high.y}, color(ImGuiCol_Border), 1);
  }
  std::vector<ImVec2> line;
  for (const CurveState& state : curve.states) line.push_back(chart.place(state));
  list.AddPolyline(line.data(), int(line.size()), color(ImGuiCol_PlotLines), 0, 0.12F * em);
  const Candidate& now = eye.session().shown().now();
  const ImVec2 at = chart.place(now.counts(), now.error);
  list.AddLine({at.x, at.y}, {at.x, track}, color(ImGuiCol_PlotLines, 0.6F), 1);
  list.AddCircleFilled(at, 0.28F * em, IM_COL32(230, 120, 0, 255));
  list.AddRectFilled({low.x, track - 0.12F * em}, {high.x, track + 0.12F * em},
                     color(ImGuiCol_Border), 0.12F * em);
  list.AddCircleFilled({at.x, track}, 0.5F * em, color(ImGuiCol_PlotLines));
  list.AddCircleFilled({at.x, track}, 0.36F * em, color(ImGuiCol_FrameBg));
}

/// Shows the curve, which is a slider too: a drag goes along it.
void show_slider(const Panel& panel) {
  Eye& eye = panel.eye;
  const float em = ImGui::GetFontSize(), margin = 0.6F * em;
  const ImVec2 size{ImGui::GetContentRegionAvail().x, 9.2F * em};
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("curve", size);
  panel.ui.note("curve");
  const ImVec2 low{corner.x + margin, corner.y + margin};
  const ImVec2 high{corner.x + size.x - margin, corner.y + size.y - 3.2F * em};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + size.x, high.y + margin}, color(ImGuiCol_FrameBg), 3);
  const auto found = eye.curve();
  if (!found || found->curve.states.size() < 2) {
    const std::string words = panel.ui.said(
        found && found->failure       ? *found->failure
        : found && found->is_complete ? Message("There is nothing that could be taken out.")
        : eye.session().shown().is_made_by_hand()
            ? Message("Simpler meshes are looked for, of the mesh as you made it …")
            : Message("Simpler meshes are looked for …"));
    list.AddText(ImGui::GetFont(), em, low, color(ImGuiCol_TextDisabled), words.c_str(), nullptr,
                 size.x - 2 * margin);
    return;
  }
  const float track = corner.y + size.y - 1.9F * em;
  // Names of amounts have a line above the curve.
  const Chart chart(found->curve.states, {low.x, low.y + 1.3F * em}, high, eye.looks.by_patches);
  if (ImGui::IsItemActive()) eye.slide(chart.state_at(ImGui::GetIO().MousePos.x), true);
  if (ImGui::IsItemDeactivated()) eye.slide(chart.state_at(ImGui::GetIO().MousePos.x));
  draw_curve(found->curve, chart, eye, low, high, track);
  write_numbers(panel, found->curve, chart, low, high, track + 0.6F * em);
  if (ImGui::IsItemActive()) return;
  const CurveState& pointed =
      found->curve.states[std::size_t(chart.state_at(ImGui::GetIO().MousePos.x))];
  panel.ui.tip(
      Message("{0} handles, {1} patches, error {2}. Drag the knob: left the mesh as it "
              "is, right the simplest (arrow keys)",
              pointed.counts.handles, pointed.counts.patches, error_of(pointed.error, 4)));
}

void show_amounts(const Panel& panel) {
  Eye& eye = panel.eye;
  const auto found = eye.curve();
  const float width = Ui::share(3);
  // Two amounts may be the same state, of which one is lit.
  const StateCurve::Mark* same = nullptr;
  std::vector<Message> alike;
  for (const std::string amount : {"gentle", "balanced", "strong"}) {
    if (amount != "gentle") Ui::beside();
    const StateCurve::Mark* mark = nullptr;
    if (found)
      for (const StateCurve::Mark& each : found->curve.marks)
        if (each.amount == amount) mark = &each;
    const Message tip =
        mark ? Message("{0} handles", found->curve.states[std::size_t(mark->state)].counts.handles)
             : Message("This amount is still looked for");
    if (mark && same && mark->state == same->state)
      alike.push_back(Message("{0} is the same as {1}.", name_of(amount), name_of(same->amount)));
    else if (mark)
      same = mark;
    const bool is_shown = mark && mark == same && mark->state == eye.session().shown().state();
    if (panel.ui.choice(name_of(amount), tip, is_shown, width, mark != nullptr))
      eye.slide(mark->state);
  }
  for (const Message& words : alike) panel.ui.text(panel.ui.said(words));
}

}  // namespace

void show_curve(const Panel& panel) {
  for (const Message& line : words_of_mesh(panel.eye)) panel.ui.text(panel.ui.said(line));
  panel.ui.heading(Message("How simple"));
  show_forms(panel);
  show_slider(panel);
  show_amounts(panel);
  if (panel.eye.session().shown().is_made_by_hand())
    panel.ui.text(panel.ui.said(Message("Hand edits stay, and errors are measured against them.")));
  panel.ui.check(Message("By patches"), Message("Draw the curve by patches, not by handles"),
                 panel.eye.looks.by_patches);
}

}  // namespace gradmesh
