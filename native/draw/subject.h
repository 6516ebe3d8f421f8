#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "draw/drawing.h"
#include "draw/path_text.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// A mesh that is drawn, where, and how large what has no size of its own becomes.
class Subject {
 public:
  /// `view` takes mesh units to those of the drawing, where y points down. The mesh must outlive
  /// this and have a size.
  Subject(const Mesh& mesh, const Affine& view, Translation translation = &Subject::english);

  /// A text of the drawing, in the person's language.
  std::string say(const Message& message) const { return message.in(translation_); }

  const Mesh& mesh() const { return mesh_; }
  const Box& box() const { return box_; }
  /// A hundredth of the longer side of the mesh's box.
  double unit() const { return unit_; }
  /// Width of an ordinary line: thinner where the patches are many and small.
  double line_width() const { return line_width_; }

  PathText path() const { return PathText(view_); }
  glm::dvec2 point(glm::dvec2 p) const { return view_.point(p); }
  /// Open path along a whole curve.
  std::string curve(Halfedge side) const;
  /// Closed path around a patch.
  std::string outline(Face face) const;
  /// Every curve once, as Mesh::curve names it.
  std::vector<Halfedge> curves() const;
  /// Centre of gravity of the patch's outline.
  glm::dvec2 center(Face face) const;
  /// Length of the shorter of the two lines that join the middles of opposite sides, in the units
  /// of the drawing.
  double narrowness(Face face) const;

 private:
  static std::string english(const std::string& text) { return text; }

  const Mesh& mesh_;
  Affine view_;
  Translation translation_;
  Box box_;
  double unit_, line_width_;
};

/// An empty drawing that shows the mesh and a margin around it.
Drawing blank_drawing(const Subject& subject);

}  // namespace gradmesh
