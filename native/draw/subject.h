#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "draw/drawing.h"
#include "draw/path_text.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// A mesh that is drawn, with its place in the drawing and the sizes of lines and marks.
class Subject {
 public:
  /// `view` maps mesh units to those of the drawing, where y points down. The mesh must outlive the
  /// subject and have a size.
  Subject(const Mesh& mesh, const Affine& view, Translation translation = &Subject::english);

  /// Returns a text of the drawing, in the person's language.
  std::string say(const Message& message) const { return message.in(translation_); }

  const Mesh& mesh() const { return mesh_; }
  const Box& box() const { return box_; }
  /// Returns a hundredth of the longer side of the mesh's box.
  double unit() const { return unit_; }
  /// Returns the width of an ordinary line, which is thinner if the patches are many and small.
  double line_width() const { return line_width_; }

  PathText path() const { return PathText(view_); }
  glm::dvec2 point(glm::dvec2 p) const { return view_.point(p); }
  /// Returns an open path along a whole curve.
  std::string curve(Halfedge side) const;
  /// Returns a closed path around a patch.
  std::string outline(Face face) const;
  /// Returns the centre of gravity of the patch's outline.
  glm::dvec2 center(Face face) const;
  /// Returns the length of the shorter of the two lines that join the middles of opposite sides, in
  /// the units of the drawing.
  double narrowness(Face face) const;

 private:
  static std::string english(const std::string& text) { return text; }

  const Mesh& mesh_;
  Affine view_;
  Translation translation_;
  Box box_;
  double unit_, line_width_;
};

/// Returns an empty drawing whose box holds the mesh and a margin around it.
Drawing blank_drawing(const Subject& subject);

}  // namespace gradmesh
