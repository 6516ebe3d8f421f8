#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "formats/svg/group/write_group.h"
#include "formats/svg/tree/svg_tree.h"
#include "geom/outline.h"

namespace gradmesh {

/// A page of a new document, in pixels; the coordinates of its meshes begin at its upper left
/// corner, y down.
struct SvgPage {
  double width, height;
  /// The name of its layer, where there are several pages.
  std::string name = {};
};

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

/// A mesh that becomes an object of a new document.
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
};

/// A new document.
class NewSvg {
 public:
  /// Several pages lie beside one another, each with a layer of its own.
  explicit NewSvg(const std::vector<SvgPage>& pages);

  /// Adds an object above those that are there. If one rectangle of patches holds all of the mesh,
  /// and no two of its sides are joined, the object is a path with one mesh gradient, such as
  /// Inkscape makes, and of its type `bicubic` for a smooth mesh; otherwise it is a group of blocks
  /// as of write_group. No object may have its id.
  void add(std::size_t page, const NewMesh& mesh);

  const SvgTree& tree() const { return tree_; }

 private:
  xmlNode* layer(std::size_t page) const;
  /// Adds the groups that clip what is in them. Returns the innermost, or the layer itself.
  xmlNode* clipped(xmlNode* layer, const NewMesh& mesh);

  SvgTree tree_;
  std::size_t pages_;
};

}  // namespace gradmesh
