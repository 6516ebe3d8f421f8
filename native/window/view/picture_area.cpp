#include "window/view/picture_area.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "window/toolkit/imgui_versions.h"

namespace gradmesh {
namespace {

/// How many pixels a step of the wheel moves the picture.
constexpr double pan_step = 60;

Held held_now() {
  const ImGuiIO& io = ImGui::GetIO();
  return {io.KeyCtrl, io.KeyShift, io.KeyAlt};
}

}  // namespace

void PictureArea::show(Eye& eye, Toolbox& toolbox, const Ui& ui) {
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  eye.viewport().resize({std::floor(room.x), std::floor(room.y)});
  ImGui::InvisibleButton("picture", {std::max(room.x, 1.0F), std::max(room.y, 1.0F)},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  const bool is_over = ImGui::IsItemHovered();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const glm::dvec2 at(mouse.x - corner.x, mouse.y - corner.y);
  Tool& tool = toolbox.in_hand();
  if (is_over) take_wheel(eye, at);
  press(eye, tool, at, is_over);
  if (drag_ == Drag::none && is_over) point(eye, tool, at);
  if (drag_ == Drag::none && !is_over && was_over_) tool.leave(eye);
  was_over_ = is_over;

  const Texture& texture = picture_.of(eye.session(), eye.view(), eye.revision());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddImage(texture_id(texture), corner,
                {corner.x + float(texture.width), corner.y + float(texture.height)});
  if (eye.looks.flickers) return;
  const Pen pen(list, {corner.x, corner.y}, eye.density);
  tool.draw(eye, pen);
  draw_words(eye, pen, ui);
}

void PictureArea::draw_words(Eye& eye, const Pen& pen, const Ui& ui) const {
  const double em = ImGui::GetFontSize();
  const glm::dvec2 size = eye.viewport().size();
  if (eye.looks.ground == SessionView::Ground::halves) {
    const glm::dvec2 line(eye.looks.split * size.x, 0), aside(0.8 * em, 0.5 * em);
    pen.words(line + glm::dvec2(-aside.x, aside.y), ui.said(Message("Original")), 1);
    pen.words(line + aside, ui.said(Message("Result")), 0);
    pen.words({line.x, size.y / 2}, "‹ ›", 0.5);
  }
  if (eye.forbids().valid())
    pen.line(points_around(eye.session().mesh(), eye.forbids(), eye.to_pixels()), true,
             Pen::Ink::forbids);
  if (!eye.circles_worst) return;
  constexpr double radius = 18;
  int number = 0;
  for (const WorstPlace& worst : eye.worst_places()) {
    const glm::dvec2 at = eye.to_pixels().point(worst.place);
    pen.circle(at, radius, Pen::Ink::picked);
    pen.words(at + glm::dvec2(0, radius * eye.density), std::to_string(++number), 0.5);
  }
}

void PictureArea::point(Eye& eye, Tool& tool, glm::dvec2 at) {
  const auto now = [&] { return Told{&tool, at, held_now(), eye.to_pixels(), eye.revision()}; };
  if (told_ == now()) return;
  tool.point(eye, at, held_now());
  told_ = now();
}

void PictureArea::take_wheel(Eye& eye, glm::dvec2 at) const {
  // As in Inkscape: the wheel moves up and down, with Shift to the sides, with Ctrl it zooms.
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseWheel == 0 && io.MouseWheelH == 0) return;
  if (io.KeyCtrl) return eye.viewport().zoom(std::pow(Viewport::zoom_step, io.MouseWheel), at);
  glm::dvec2 by(io.MouseWheelH, io.MouseWheel);
  if (io.KeyShift) std::swap(by.x, by.y);
  eye.viewport().pan(pan_step * eye.density * by);
}

void PictureArea::press(Eye& eye, Tool& tool, glm::dvec2 at, bool is_over) {
  for (const int button : {ImGuiMouseButton_Left, ImGuiMouseButton_Middle})
    if (drag_ == Drag::none && is_over && ImGui::IsMouseClicked(button)) {
      drag_ = Drag::pending;
      button_ = button;
      pressed_at_ = last_ = at;
    }
  if (drag_ == Drag::none) return;
  if (at != last_) drag_to(eye, tool, at);
  if (!ImGui::IsMouseDown(button_)) release(eye, tool, at);
}

void PictureArea::drag_to(Eye& eye, Tool& tool, glm::dvec2 at) {
  // A button that is pressed and moved by fewer pixels clicks.
  constexpr double steady = 4, near_line = 12;
  const bool is_first = drag_ == Drag::pending;
  if (is_first) {
    if (glm::length(at - pressed_at_) <= steady * eye.density) return;
    const double line = eye.looks.split * eye.viewport().size().x;
    const bool is_on_line = eye.looks.ground == SessionView::Ground::halves &&
                            std::abs(pressed_at_.x - line) < near_line * eye.density;
    const bool pans = button_ == ImGuiMouseButton_Middle || is_held_down(ImGuiKey_Space);
    drag_ = pans ? Drag::pan : is_on_line ? Drag::split : Drag::tool;
    last_ = pressed_at_;
  }
  if (drag_ == Drag::pan) eye.viewport().pan(at - last_);
  if (drag_ == Drag::split) eye.looks.split = std::clamp(at.x / eye.viewport().size().x, 0.0, 1.0);
  if (drag_ == Drag::tool) tool.drag(eye, last_, at, held_now(), is_first);
  last_ = at;
}

void PictureArea::release(Eye& eye, Tool& tool, glm::dvec2 at) {
  const Drag ended = std::exchange(drag_, Drag::none);
  if (ended == Drag::tool) tool.drop(eye, held_now());
  if (ended != Drag::pending) return;
  if (button_ == ImGuiMouseButton_Middle)
    eye.viewport().zoom(Viewport::zoom_step, at);
  else if (eye.picks_color)
    eye.pick_color(at);
  else
    tool.click(eye, at, held_now());
}

}  // namespace gradmesh
