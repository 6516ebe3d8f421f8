#pragma once

#include <libxml/tree.h>

#include <cstddef>
#include <vector>

#include "formats/svg/tree/svg_tree.h"
#include "geom/flat_area.h"

namespace gradmesh {

/// Paths of one colour each that follow one another, such as Inkscape's import of PDF makes of a
/// mesh: in a group of their own (1.2), or among others (1.4).
struct FlatTiles {
  /// The outermost group that paints nothing else, which may clip what it holds; null if they lie
  /// beside something else.
  xmlNode* group = nullptr;
  /// In painting order, and what they paint in units of the outermost <svg>.
  std::vector<xmlNode*> paths;
  std::vector<FlatArea> tiles;
};

/// Some of them that follow one another.
struct PartOfTiles {
  const FlatTiles* of = nullptr;
  std::size_t begin = 0, end = 0;

  std::size_t count() const { return end - begin; }
};

/// Returns the elements that the part is: the group, if it is all that the group paints, or paths.
std::vector<xmlNode*> elements_of(const PartOfTiles& part);

/// Returns where at least four opaque paths without strokes follow one another, as many as do, in
/// document order; but none in layers that nobody sees, or in what is only named, such as clip
/// paths.
std::vector<FlatTiles> flat_tiles(const SvgTree& tree);

}  // namespace gradmesh
