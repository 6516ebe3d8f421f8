#pragma once

#include "window/eye/eye.h"
#include "window/eye/session_texture.h"
#include "window/toolkit/ui.h"
#include "window/tools/toolbox.h"

namespace gradmesh {

/// The picture of the mesh, and the pointer over it.
class PictureArea {
 public:
  /// Passes on what the pointer does, and draws what is seen then, in the room that is left of the
  /// window that Dear ImGui draws.
  void show(Eye& eye, Toolbox& toolbox, const Ui& ui);

 private:
  enum class Drag { none, pending, tool, pan, split };
  /// What a tool was told of the pointer last: it need not be told again.
  struct Told {
    const Tool* tool = nullptr;
    glm::dvec2 at{0.0};
    Held held = {};
    Affine to_pixels = {};
    int revision = -1;

    bool operator==(const Told&) const = default;
  };

  /// Draws what is told of the picture: halves by their names, worst places, the patch that forbids
  /// an edit.
  void draw_words(Eye& eye, const Pen& pen, const Ui& ui) const;
  void point(Eye& eye, Tool& tool, glm::dvec2 at);
  void take_wheel(Eye& eye, glm::dvec2 at) const;
  /// Goes on with a press of a button.
  void press(Eye& eye, Tool& tool, glm::dvec2 at, bool is_over);
  void drag_to(Eye& eye, Tool& tool, glm::dvec2 at);
  void release(Eye& eye, Tool& tool, glm::dvec2 at);

  SessionTexture picture_;
  Drag drag_ = Drag::none;
  /// The button that is held, as Dear ImGui numbers them.
  int button_ = 0;
  glm::dvec2 pressed_at_{0.0}, last_{0.0};
  bool was_over_ = false;
  Told told_;
};

}  // namespace gradmesh
