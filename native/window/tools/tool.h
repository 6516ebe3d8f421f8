#pragma once

#include <glm/vec2.hpp>

#include "base/message.h"
#include "window/eye/eye.h"
#include "window/toolkit/sdl_window.h"

namespace gradmesh {

/// Draws over the picture, in its pixels.
class Pen {
 public:
  enum class Ink { outline, picked, forbids };

  Pen(ImDrawList& list, glm::dvec2 corner, double density)
      : list_(list), corner_(corner), density_(density) {}

  void line(const std::vector<glm::dvec2>& points, bool is_closed, Ink ink) const;
  void dot(glm::dvec2 place, Ink ink) const;
  void circle(glm::dvec2 middle, double radius, Ink ink) const;
  /// Writes words on a ground on which they can be read. `aside` says where they begin: 0 to the
  /// right of the place, 0.5 around it, 1 to the left of it.
  void words(glm::dvec2 place, const std::string& text, double aside) const;

 private:
  ImDrawList& list_;
  const glm::dvec2 corner_;
  const double density_;
};

/// Returns points around a face, in the picture's pixels.
std::vector<glm::dvec2> points_around(const Mesh& mesh, Face face, const Affine& to_pixels);

/// What the pointer does over the picture. Places are in the picture's pixels. Nothing of a tool
/// outlives a gesture but what it has done to the Eye.
class Tool {
 public:
  Tool() = default;
  Tool(const Tool&) = delete;
  Tool& operator=(const Tool&) = delete;
  virtual ~Tool() = default;

  virtual Message name() const = 0;
  virtual Message tip() const = 0;
  /// What SDL calls the key that takes it.
  virtual const char* key() const = 0;

  /// The pointer is over a place, and no button is pressed.
  virtual void point(Eye& eye, glm::dvec2 at, const Held& held) = 0;
  /// The pointer has left the picture.
  virtual void leave(Eye& eye) { eye.forget_proposal(); }
  virtual void click(Eye& eye, glm::dvec2 at, const Held& held) = 0;
  /// The pointer is dragged from one place to the next; `is_first` if it was pressed there.
  virtual void drag(Eye& eye, glm::dvec2 from, glm::dvec2 to, const Held& held, bool is_first) = 0;
  /// The button is let go after a drag.
  virtual void drop(Eye& eye, const Held& held) = 0;
  /// Draws what is seen of a gesture that goes on, and of what the tool has picked.
  virtual void draw(const Eye&, const Pen&) const {}
  /// Returns what a click would do, or else what a person may do; nothing if it is something that
  /// holds for every tool.
  virtual std::optional<Message> hint(const Eye& eye) const = 0;
};

}  // namespace gradmesh
