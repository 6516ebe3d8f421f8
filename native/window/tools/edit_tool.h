#pragma once

#include "window/tools/marking.h"

namespace gradmesh {

/// Takes lines out of a mesh, or puts them in: shows what a click does where the pointer is. With
/// Ctrl, both lines go in. With Shift, a click marks a patch.
class EditTool final : public Marking {
 public:
  explicit EditTool(HandEdit edit) : edit_(edit) {}

  Message name() const override;
  Message tip() const override;
  const char* key() const override;
  void point(Eye& eye, glm::dvec2 at, const Held& held) override;
  void leave(Eye& eye) override;
  void click(Eye& eye, glm::dvec2 at, const Held& held) override;
  void drag(Eye& eye, glm::dvec2 from, glm::dvec2 to, const Held& held, bool is_first) override;
  std::optional<Message> hint(const Eye& eye) const override;

 private:
  /// What was proposed last: of which session, where, and what.
  struct Asked {
    int revision = -1;
    HandEdit edit;
    Halfedge edge;
    glm::dvec2 at;

    bool operator==(const Asked&) const = default;
  };

  void propose(Eye& eye, glm::dvec2 at, HandEdit edit);

  const HandEdit edit_;
  Asked asked_{};
};

}  // namespace gradmesh
