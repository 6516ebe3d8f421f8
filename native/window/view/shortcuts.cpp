#include "window/view/shortcuts.h"

#include <functional>
#include <map>

namespace gradmesh {
namespace {

using Actions = std::map<std::string, std::function<void(Eye&)>>;

void next_known(Eye& eye) {
  auto& known = eye.looks.known;
  if (!known)
    known = AnalysisKind::prices;
  else if (*known == AnalysisKind::parts)
    known.reset();
  else
    known = AnalysisKind(int(*known) + 1);
  eye.looks.region = 0;
}

void look(Eye& eye, SessionView::Ground ground) { eye.looks.ground = ground; }

const Actions& actions() {
  using Ground = SessionView::Ground;
  static const Actions all = {
      // along the curve
      {"Right", [](Eye& eye) { eye.step(1); }},
      {"Left", [](Eye& eye) { eye.step(-1); }},
      {"PageDown", [](Eye& eye) { eye.step(5); }},
      {"PageUp", [](Eye& eye) { eye.step(-5); }},
      {"Home", [](Eye& eye) { eye.slide(0); }},
      {"End", [](Eye& eye) { eye.slide(1 << 30); }},
      // from where
      {"+", [](Eye& eye) { eye.viewport().zoom(Viewport::zoom_step); }},
      {"=", [](Eye& eye) { eye.viewport().zoom(Viewport::zoom_step); }},
      {"-", [](Eye& eye) { eye.viewport().zoom(1 / Viewport::zoom_step); }},
      {"1", [](Eye& eye) { eye.viewport().zoom_to(eye.density); }},
      {"2", [](Eye& eye) { eye.viewport().zoom_to(2 * eye.density); }},
      {"3", [](Eye& eye) { eye.viewport().fit(); }},
      {"4", [](Eye& eye) { eye.viewport().fit(); }},
      {"5", [](Eye& eye) { eye.viewport().fit(); }},
      // what is seen
      {"7", [](Eye& eye) { look(eye, Ground::result); }},
      {"8", [](Eye& eye) { look(eye, Ground::original); }},
      {"9", [](Eye& eye) { look(eye, Ground::halves); }},
      {"0", [](Eye& eye) { look(eye, Ground::error); }},
      {"L", [](Eye& eye) { eye.looks.lines = !eye.looks.lines; }},
      {"H", [](Eye& eye) { eye.looks.handles = !eye.looks.handles; }},
      {"S", next_known},
      {",", [](Eye& eye) { eye.step_region(-1); }},
      {".", [](Eye& eye) { eye.step_region(1); }},
      // by hand
      {"Return",
       [](Eye& eye) {
         if (eye.to_merge().size() > 1) eye.merge_marked();
       }},
      {"P",
       [](Eye& eye) {
         if (!eye.marked().empty()) eye.protect_marked();
       }},
      {"O",
       [](Eye& eye) {
         if (!eye.marked().empty()) eye.protect_others();
       }},
  };
  return all;
}

WindowKey press_with_control(const std::string& name, bool has_shift, Eye& eye) {
  if (name == "Return") return WindowKey::apply;
  if (name == "Z" && !has_shift) eye.attempt([](Session& session) { session.undo(); });
  if (name == "Y" || (name == "Z" && has_shift))
    eye.attempt([](Session& session) { session.redo(); });
  return WindowKey::none;
}

/// Lets go of what was taken last: marks, a tool; or else of the window.
WindowKey let_go(Eye& eye, Toolbox& toolbox) {
  if (eye.picks_color)
    eye.picks_color = false;
  else if (!eye.marked().empty())
    eye.unmark();
  else if (eye.circles_worst)
    eye.circles_worst = false;
  else if (!toolbox.take_first(eye))
    return WindowKey::escape;
  return WindowKey::none;
}

}  // namespace

WindowKey press(const Key& key, Eye& eye, Toolbox& toolbox) {
  // Keys of the block of figures do what those beside it do.
  const std::string block = "Keypad ";
  std::string name = key.name.starts_with(block) ? key.name.substr(block.size()) : key.name;
  if (name == "Enter") name = "Return";
  if (name == "F") eye.looks.flickers = key.is_down;
  if (!key.is_down) return WindowKey::none;
  if (key.held.control) return press_with_control(name, key.held.shift, eye);
  if (name == "Escape") return let_go(eye, toolbox);
  if (toolbox.take(name, eye)) return WindowKey::none;
  if (const auto found = actions().find(name); found != actions().end()) found->second(eye);
  return WindowKey::none;
}

}  // namespace gradmesh
