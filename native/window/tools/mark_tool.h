#pragma once

#include "window/tools/marking.h"

namespace gradmesh {

/// Marks patches, by clicks too.
class MarkTool final : public Marking {
 public:
  explicit MarkTool(bool brushes) : brushes_(brushes) {}

  Message name() const override { return brushes_ ? Message("Brush") : Message("Mark"); }
  Message tip() const override;
  const char* key() const override { return brushes_ ? "T" : "K"; }
  void point(Eye& eye, glm::dvec2 at, const Held& held) override;
  void click(Eye& eye, glm::dvec2 at, const Held& held) override;
  std::optional<Message> hint(const Eye& eye) const override;

 protected:
  bool brushes() const override { return brushes_; }

 private:
  const bool brushes_;
};

}  // namespace gradmesh
