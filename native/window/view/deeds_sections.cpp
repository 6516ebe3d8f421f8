#include <imgui.h>

#include <algorithm>

#include "reference/weights.h"
#include "window/eye/words.h"
#include "window/view/panel.h"

namespace gradmesh {
namespace {

void show_history(const Panel& panel) {
  const Session& session = panel.eye.session();
  const float width = Ui::share(2);
  if (panel.ui.button(Message("Undo"), words_of_undo(session), session.history().can_undo(), width))
    panel.eye.attempt([](Session& s) { s.undo(); });
  Ui::beside();
  if (panel.ui.button(Message("Redo"), words_of_redo(session), session.history().can_redo(), width))
    panel.eye.attempt([](Session& s) { s.redo(); });
}

void show_fits(const Panel& panel) {
  panel.ui.check(
      Message("Fit what is around"),
      Message("Move points and handles near a change so that the picture stays what it was"),
      panel.eye.fits);
  Ui::beside();
  if (panel.ui.button(Message("Fit all"),
                      Message("Move all points and handles so that the picture is closest")))
    panel.eye.attempt([](Session& s) { s.hands().fit(); });
}

/// Shows how often errors in what is marked count, and lets a person choose how often.
void show_weights(const Panel& panel) {
  Eye& eye = panel.eye;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(panel.ui.said(Message("Errors there ×")).c_str());
  const auto is_everywhere = [&](double factor) {
    return !eye.marked().empty() && std::ranges::all_of(eye.marked(), [&](Face face) {
      return eye.session().shown().weight_at(face) == factor;
    });
  };
  const auto add = [&](const char* label, double factor) {
    Ui::beside();
    const bool is_pressed =
        panel.ui.choice(Message("{0}", std::string(label)),
                        Message("How often errors in the marked patches count. More: they stay "
                                "more exact (blue lines). Less: other places do (orange lines)"),
                        is_everywhere(factor), 0, !eye.marked().empty());
    panel.ui.note(std::string("weight ") + label);
    if (is_pressed) eye.attempt([&](Session& s) { s.protection().weigh(eye.marked(), factor); });
  };
  add("¼", 0.25);
  add("½", 0.5);
  add("1", 1);
  add("2", 2);
  add("4", 4);
  if (eye.session().shown().is_weighted() &&
      panel.ui.button(Message("Errors count alike everywhere"),
                      Message("Let errors count once everywhere again")))
    eye.attempt([](Session& s) { s.protection().weigh_alike(); });
}

}  // namespace

void show_meshes(const Panel& panel) {
  Eye& eye = panel.eye;
  if (eye.ids().size() < 2) return;
  ImGui::SetNextItemWidth(-1);
  const bool is_open = ImGui::BeginCombo("##meshes", eye.id().c_str());
  panel.ui.note("meshes");
  if (!is_open)
    return panel.ui.tip(Message("Choose the mesh to work on. Changes of the others stay"));
  for (std::size_t i = 0; i < eye.ids().size(); ++i) {
    ImGui::PushID(int(i));
    if (ImGui::Selectable(eye.ids()[i].c_str(), eye.id() == eye.ids()[i])) eye.choose(i);
    panel.ui.note("mesh " + std::to_string(i + 1));
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

void show_tools(const Panel& panel) {
  panel.ui.heading(Message("What the pointer does"));
  const auto& tools = panel.toolbox.tools();
  std::vector<Message> names;
  for (const auto& tool : tools) names.push_back(tool->name());
  const int in_a_row = panel.ui.in_a_row(names, 3);
  const float width = Ui::share(in_a_row);
  for (std::size_t i = 0; i < tools.size(); ++i) {
    if (i % std::size_t(in_a_row) != 0) Ui::beside();
    const Tool& tool = *tools[i];
    if (panel.ui.choice(tool.name(), tool.tip(), &tool == &panel.toolbox.in_hand(), width))
      panel.toolbox.take(i, panel.eye);
  }
  show_fits(panel);
  show_history(panel);
}

void show_marked(const Panel& panel) {
  Eye& eye = panel.eye;
  const bool has_marks = !eye.marked().empty(), is_release = eye.marks_are_protected();
  panel.ui.heading(Message("Marked patches"));
  const Message merge = Message("Merge"), here = Message("Only here");
  const Message protect = is_release ? Message("Release") : Message("Protect");
  const int in_a_row = panel.ui.in_a_row({merge, protect, here}, 3);
  const float width = Ui::share(in_a_row);
  if (panel.ui.button(merge, Message("Make one patch of all that are marked (Enter)"),
                      eye.to_merge().size() > 1, width))
    eye.merge_marked();
  Ui::beside();
  if (panel.ui.button(protect,
                      is_release ? Message("Release the marked patches (P)")
                                 : Message("Protect the marked patches: they stay as they are (P)"),
                      has_marks, width))
    eye.protect_marked();
  if (in_a_row > 2) Ui::beside();
  if (panel.ui.button(here, Message("Protect all other patches: only the marked ones change (O)"),
                      has_marks, width))
    eye.protect_others();
  show_weights(panel);
}

void show_worst_places(const Panel& panel) {
  panel.ui.heading(Message("Where it differs most"));
  const std::vector<WorstPlace>& places = panel.eye.worst_places();
  const float width = Ui::share(Eye::worst_count);
  for (std::size_t i = 0; i < std::size_t(Eye::worst_count); ++i) {
    if (i > 0) Ui::beside();
    const bool is_there = i < places.size();
    const Message tip = is_there ? Message("Error {0} in a small part; a click goes there",
                                           error_of(places[i].error, 3))
                                 : Message("There are fewer places that differ");
    ImGui::PushID(int(i));
    if (panel.ui.button(Message("{0}", i + 1), tip, is_there, width)) panel.eye.look_at(places[i]);
    panel.ui.note("worst " + std::to_string(i + 1));
    ImGui::PopID();
  }
}

}  // namespace gradmesh
