#pragma once

#include "window/tools/tool.h"

namespace gradmesh {

/// Drags points and handles of the mesh. The picture follows; nothing is fitted.
class ShapeTool final : public Tool {
 public:
  Message name() const override { return Message("Move"); }
  Message tip() const override {
    return Message("Drag a point or a handle of the mesh; the picture follows (G)");
  }
  const char* key() const override { return "G"; }
  void point(Eye& eye, glm::dvec2 at, const Held& held) override;
  void click(Eye&, glm::dvec2, const Held&) override {}
  void drag(Eye& eye, glm::dvec2 from, glm::dvec2 to, const Held& held, bool is_first) override;
  void drop(Eye& eye, const Held& held) override;
  void draw(const Eye& eye, const Pen& pen) const override;
  std::optional<Message> hint(const Eye& eye) const override;

 private:
  /// Returns where what is taken hold of is.
  glm::dvec2 place_of_grip(const Eye& eye) const;

  std::optional<Grip> grip_;
  /// Where it is while it is dragged, and how far that is from the pointer.
  glm::dvec2 at_{0.0}, aside_{0.0};
};

}  // namespace gradmesh
