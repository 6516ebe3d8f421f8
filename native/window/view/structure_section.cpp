#include <imgui.h>

#include "window/eye/words.h"
#include "window/view/panel.h"

namespace gradmesh {
namespace {

/// Draws what is near an element, each as a button that goes there.
class Neighbours {
 public:
  explicit Neighbours(const Panel& panel) : panel_(panel) {}

  void add(const Message& label, Halfedge halfedge) { add(label, halfedge, &Element::halfedge); }
  void add(const Message& label, Face face) { add(label, face, &Element::face); }
  void add(const Message& label, Point point) { add(label, point, &Element::point); }

 private:
  template <class Index>
  void add(const Message& label, Index index, Index Element::*member) {
    if (!index.valid()) return;
    // As many in a row as have room.
    const std::string words = panel_.ui.said(label);
    const float width = ImGui::CalcTextSize(words.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    const float room = ImGui::GetContentRegionMax().x + ImGui::GetWindowPos().x;
    if (!is_first_ && ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width < room)
      Ui::beside();
    is_first_ = false;
    if (!panel_.ui.button(label, Message("Go there"))) return;
    panel_.eye.element = {};
    panel_.eye.element.*member = index;
  }

  const Panel& panel_;
  bool is_first_ = true;
};

Message name_of(const Mesh& mesh, Halfedge h) {
  if (mesh.is_bar(h)) return Message("Half-edge {0}, a bar of {1}", h.value, mesh[h].parent.value);
  if (mesh.is_stem(h))
    return Message("Half-edge {0}, a stem on {1}", h.value, mesh[h].parent.value);
  if (!mesh.other_side(h).valid()) return Message("Half-edge {0}, at the border", h.value);
  return Message("Half-edge {0}", h.value);
}

void show_face(const Panel& panel, Face face) {
  const Mesh& mesh = panel.eye.session().mesh();
  panel.ui.text(panel.ui.said(mesh.is_fixed(face) ? Message("Patch {0}, protected", face.value)
                                                  : Message("Patch {0}", face.value)));
  Neighbours near(panel);
  const auto sides = mesh.sides(face);
  near.add(Message("Top"), sides[0]);
  near.add(Message("Right"), sides[1]);
  near.add(Message("Bottom"), sides[2]);
  near.add(Message("Left"), sides[3]);
}

void show_halfedge(const Panel& panel, Halfedge h) {
  const Mesh& mesh = panel.eye.session().mesh();
  panel.ui.text(panel.ui.said(name_of(mesh, h)));
  if (const auto known = panel.eye.session().shown().analysis(AnalysisKind::prices))
    for (const CurvePrice& price : known->prices)
      if (price.curve == mesh.curve(h))
        panel.ui.text(
            panel.ui.said(Message("Taking it out costs {0}", signed_fixed(price.error, 4))));
  Neighbours near(panel);
  if (mesh.is_leaf(h)) {
    near.add(Message("Next"), mesh.next(h));
    near.add(Message("Previous"), mesh.prev(h));
  }
  near.add(Message("Twin"), mesh.other_side(h));
  near.add(Message("Parent"), mesh[h].parent);
  near.add(Message("First child"), mesh[h].first_child);
  if (mesh.is_leaf(h)) near.add(Message("Patch"), mesh.face(h));
  near.add(Message("Start"), mesh.origin(h));
  near.add(Message("End"), mesh.end(h));
}

void show_point(const Panel& panel, Point point) {
  const Mesh& mesh = panel.eye.session().mesh();
  const glm::dvec2 at = panel.eye.editing().view.point(mesh.position(point));
  const Message x = fixed(at.x, 2), y = fixed(at.y, 2);
  panel.ui.text(panel.ui.said(mesh[point].is_junction()
                                  ? Message("T-junction {0} at {1}, {2}", point.value, x, y)
                                  : Message("Point {0} at {1}, {2}", point.value, x, y)));
  Neighbours near(panel);
  near.add(Message("Half-edge"), mesh[point].halfedge);
  near.add(Message("Stem"), mesh[point].stem);
}

}  // namespace

void show_structure(const Panel& panel) {
  const auto [face, halfedge, point] = panel.eye.element;
  if (!face.valid() && !halfedge.valid() && !point.valid()) return;
  const bool is_open = ImGui::TreeNodeEx("details", ImGuiTreeNodeFlags_NoTreePushOnOpen, "%s",
                                         panel.ui.said(Message("Details")).c_str());
  panel.ui.note("details");
  panel.ui.tip(Message("Numbers of what is picked, and its neighbours"));
  if (!is_open) return;
  if (face.valid()) show_face(panel, face);
  if (halfedge.valid()) show_halfedge(panel, halfedge);
  if (point.valid()) show_point(panel, point);
}

}  // namespace gradmesh
