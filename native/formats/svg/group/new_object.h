#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/affine.h"
#include "formats/svg/group/write_group.h"
#include "formats/svg/tree/svg_tree.h"
#include "geom/outline.h"

namespace gradmesh {

/// What a path surrounds, as path data.
struct SvgShape {
  std::string path;
  FillRule rule = FillRule::nonzero;
};

/// How a shape is stroked, in pixels.
struct SvgStroke {
  double width = 1;
  /// Words of CSS.
  std::string cap = "butt", join = "miter";
  double miter_limit = 4;
  /// Lengths of dashes and of the gaps between them, by turns; empty for a line without gaps.
  std::vector<double> dashes = {};
  double dash_offset = 0;
};

/// A group of objects that is mixed at once with what lies below.
struct SvgGroup {
  double opacity = 1;
  /// A CSS word.
  std::string blend_mode = "normal";
  bool is_isolated = false;
};

/// A mesh that becomes a new object of a document.
struct NewMesh {
  std::string id;
  /// The shape of the object, and those through which it is seen.
  SvgShape shape;
  std::vector<SvgShape> clips = {};
  WrittenMesh written;
  /// The stroke of the shape that the mesh paints; nothing if it paints what the shape surrounds.
  std::optional<SvgStroke> stroke = {};
  /// A CSS word: how the object is mixed with what lies below.
  std::string blend_mode = "normal";
  /// From the coordinates of the mesh and of its own shape to those of the clip paths.
  Affine to_page = {};
  /// Those that it lies in, the outermost first; add_object() leaves them to MixedGroups.
  std::vector<std::shared_ptr<const SvgGroup>> groups = {};
};

/// Adds an object to a group, above what is there, and gives it the id, which no element may have.
/// If one rectangle of patches holds all of the mesh, and no two of its sides are joined, the
/// object is a path with one mesh gradient, such as Inkscape makes, and of its type `bicubic` for a
/// smooth mesh; otherwise it is a group of blocks as of write_group. Returns the object, or the
/// outermost of the groups by which it is clipped.
xmlNode* add_object(SvgTree& tree, xmlNode* group, const NewMesh& mesh);

}  // namespace gradmesh
