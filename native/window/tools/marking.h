#pragma once

#include "window/tools/tool.h"

namespace gradmesh {

/// A tool whose drags mark patches: a straight drag what is in a rectangle, a curved one what it
/// goes around, and with Alt every patch that the pointer touches. With Shift, besides those that
/// are marked.
class Marking : public Tool {
 public:
  void drag(Eye& eye, glm::dvec2 from, glm::dvec2 to, const Held& held, bool is_first) override;
  void drop(Eye& eye, const Held& held) override;
  void draw(const Eye& eye, const Pen& pen) const override;
  /// Returns what can be done with the patches that are marked; nothing if none are.
  std::optional<Message> hint(const Eye& eye) const override;

 protected:
  /// True if drags touch patches without Alt, too.
  virtual bool brushes() const { return false; }

 private:
  /// Returns the rectangle of a straight drag, and the way of the pointer otherwise.
  std::vector<glm::dvec2> outline() const;

  std::vector<glm::dvec2> way_;
  /// What a drag along that way marks.
  std::vector<Face> inside_;
};

}  // namespace gradmesh
