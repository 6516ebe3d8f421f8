#pragma once

#include <libxml/tree.h>

#include <vector>

#include "formats/svg/tree/svg_tree.h"
#include "geom/flat_area.h"

namespace gradmesh {

/// A group of paths of one colour each, such as Inkscape's import of PDF makes of a mesh.
struct FlatTiles {
  /// The outermost group that paints nothing else: it may clip what it holds.
  xmlNode* group = nullptr;
  /// In painting order, in units of the outermost <svg>.
  std::vector<FlatArea> tiles;
};

/// Returns the groups that hold at least four opaque paths without strokes and nothing else, in
/// document order; but none in layers that nobody sees, or in what is only named, such as clip
/// paths.
std::vector<FlatTiles> flat_tiles(const SvgTree& tree);

}  // namespace gradmesh
