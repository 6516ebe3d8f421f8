#pragma once

#include "window/tools/tool.h"

namespace gradmesh {

/// Moves the picture, and picks what of the structure is looked at: the closest point, half-edge or
/// patch.
class LookTool final : public Tool {
 public:
  Message name() const override { return Message("Look"); }
  Message tip() const override {
    return Message(
        "Drag to move the picture. Click a point, a side or a patch to see its numbers (I)");
  }
  const char* key() const override { return "I"; }
  void point(Eye& eye, glm::dvec2 at, const Held& held) override;
  void click(Eye& eye, glm::dvec2 at, const Held& held) override;
  void drag(Eye& eye, glm::dvec2 from, glm::dvec2 to, const Held& held, bool is_first) override;
  void drop(Eye&, const Held&) override {}
  void draw(const Eye& eye, const Pen& pen) const override;
  std::optional<Message> hint(const Eye& eye) const override;
};

}  // namespace gradmesh
