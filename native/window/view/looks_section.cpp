#include <imgui.h>

#include <array>
#include <cmath>

#include "window/eye/words.h"
#include "window/view/panel.h"

namespace gradmesh {
namespace {

using Ground = SessionView::Ground;

struct Choice {
  Message label, tip;
};

Choice choice_of(Ground ground) {
  switch (ground) {
    case Ground::result:
      return {Message("Result"), Message("The mesh as it would be written (key 7)")};
    case Ground::original:
      return {Message("Original"),
              Message("The picture that counts (key 8; hold F to see it for a moment)")};
    case Ground::halves:
      return {Message("Both"), Message("The original left of the line, the result right of it; "
                                       "drag the line (key 9)")};
    case Ground::error:
      break;
  }
  return {Message("Error"), Message("Where the result differs, the darker the more (key 0)")};
}

void show_grounds(const Panel& panel) {
  constexpr std::array all{Ground::result, Ground::original, Ground::halves, Ground::error};
  std::vector<Message> labels;
  for (const Ground ground : all) labels.push_back(choice_of(ground).label);
  const int in_a_row = panel.ui.in_a_row(labels, 4);
  const float width = Ui::share(in_a_row);
  int place = 0;
  for (const Ground ground : all) {
    if (place++ % in_a_row != 0) Ui::beside();
    const auto [label, tip] = choice_of(ground);
    if (panel.ui.choice(label, tip, panel.eye.looks.ground == ground, width))
      panel.eye.looks.ground = ground;
  }
}

Message name_of(std::optional<AnalysisKind> kind) {
  if (!kind) return Message("Nothing else");
  if (*kind == AnalysisKind::prices) return Message("What lines cost");
  if (*kind == AnalysisKind::regions) return Message("Regions of a patch");
  return Message("Parts (motorcycle graph)");
}

/// Shows how large the picture is: 100 % is a pixel of an ordinary screen for each of the page.
void show_zoom(const Panel& panel) {
  Viewport& viewport = panel.eye.viewport();
  const float side = 1.7F * ImGui::GetFontSize();
  if (panel.ui.button(Message("{0}", std::string("−")), Message("Smaller (minus)"), true, side))
    viewport.zoom(1 / Viewport::zoom_step);
  Ui::beside();
  const int per_cent = int(std::lround(100 * viewport.scale() / panel.eye.density));
  if (panel.ui.button(Message("{0} %", per_cent), Message("As large as on the page (1)"), true,
                      Ui::width_of("100 %")))
    viewport.zoom_to(panel.eye.density);
  panel.ui.note("zoom");
  Ui::beside();
  if (panel.ui.button(Message("{0}", std::string("+")), Message("Larger (plus)"), true, side))
    viewport.zoom(Viewport::zoom_step);
  Ui::beside();
  if (panel.ui.button(Message("All"), Message("Show all of the mesh (3)"))) viewport.fit();
}

/// Shows what of the mesh is to be found out and seen.
void show_kinds(const Panel& panel) {
  Looks& looks = panel.eye.looks;
  ImGui::SetNextItemWidth(-1);
  const std::string chosen = panel.ui.said(name_of(looks.known));
  const bool is_open = ImGui::BeginCombo("##known", chosen.c_str());
  panel.ui.check_fits(chosen, ImGui::GetItemRectSize().x - ImGui::GetFrameHeight());
  panel.ui.note("known");
  if (!is_open) {
    panel.ui.tip(Message("Shows what merging would cost, in colours over the mesh (S)"));
    return;
  }
  using Kind = std::optional<AnalysisKind>;
  for (const Kind kind : {Kind(), Kind(AnalysisKind::prices), Kind(AnalysisKind::regions),
                          Kind(AnalysisKind::parts)}) {
    if (ImGui::Selectable(panel.ui.said(name_of(kind)).c_str(), kind == looks.known)) {
      looks.known = kind;
      looks.region = 0;
    }
    panel.ui.note(name_of(kind).english());
  }
  ImGui::EndCombo();
}

void show_prices(const Panel& panel, const Analysis& known) {
  bool has_scale = false;
  for (const CurvePrice& price : known.prices) has_scale = has_scale || std::isfinite(price.error);
  if (!has_scale) return panel.ui.text(panel.ui.said(Message("No line can be taken out.")));
  const HeatScale scale = scale_of(known.prices);
  constexpr int steps = 3;
  const float em = ImGui::GetFontSize();
  for (int i = 0; i <= steps; ++i) {
    const double position = double(i) / steps;
    const glm::dvec3 rgb = HeatScale::rgb_at(position);
    if (i > 0 && i != 2) Ui::beside();
    ImGui::ColorButton(("##" + std::to_string(i)).c_str(),
                       {float(rgb.r), float(rgb.g), float(rgb.b), 1},
                       ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop, {em, em});
    Ui::beside();
    ImGui::TextUnformatted(panel.ui.said(short_error(scale.error_at(position))).c_str());
  }
}

void show_regions(const Panel& panel) {
  const bool are_many = panel.eye.regions().size() > 1;
  if (panel.ui.button(Message("{0}", std::string("‹")),
                      Message("A larger region of the patch that is marked or pointed at (comma)"),
                      are_many))
    panel.eye.step_region(-1);
  Ui::beside();
  if (panel.ui.button(
          Message("{0}", std::string("›")),
          Message("A smaller region of the patch that is marked or pointed at (full stop)"),
          are_many))
    panel.eye.step_region(1);
  Ui::beside();
  panel.ui.text(panel.ui.said(words_of_regions(panel.eye)));
}

/// Says what the colours mean of what is known.
void show_legend(const Panel& panel) {
  const auto known = panel.eye.known();
  if (!known) return panel.ui.text(panel.ui.said(Message("This is being found out …")));
  if (known->failure) return panel.ui.text(panel.ui.said(*known->failure));
  switch (*panel.eye.looks.known) {
    case AnalysisKind::prices:
      return show_prices(panel, *known);
    case AnalysisKind::regions:
      return show_regions(panel);
    case AnalysisKind::parts:
      return panel.ui.text(panel.ui.said(words_of_parts(*known)));
  }
}

}  // namespace

void show_looks(const Panel& panel) {
  panel.ui.heading(Message("What is shown"));
  show_grounds(panel);
  panel.ui.check(Message("Lines"), Message("Show the lines of the mesh (L)"),
                 panel.eye.looks.lines);
  Ui::beside();
  panel.ui.check(Message("Handles"), Message("Show what can be dragged in Inkscape (H)"),
                 panel.eye.looks.handles);
  Ui::beside();
  show_zoom(panel);
  show_kinds(panel);
  if (panel.eye.looks.known) show_legend(panel);
}

}  // namespace gradmesh
