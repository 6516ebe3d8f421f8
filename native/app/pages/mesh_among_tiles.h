#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/affine.h"
#include "geom/flat_area.h"
#include "mesh/mesh.h"
#include "raster/frame.h"
#include "raster/picture.h"

namespace gradmesh {

/// A mesh on the page, beside flat tiles that may show the same.
class MeshAmongTiles {
 public:
  /// `place` is the map from the mesh's coordinates to those of the tiles; its determinant is not
  /// 0.
  MeshAmongTiles(const Mesh& mesh, const Affine& place);

  /// In the tiles' coordinates.
  const Box& box() const { return box_; }

  /// Returns the mean FLIP, over what the mesh covers, of tiles and of tiles whose colours the mesh
  /// has where they are; 1 where they leave more of it bare than smoothed edges. The mesh itself is
  /// 0.2 and more away from Inkscape's tiles, of any mesh: they are as large as its patches, and
  /// have the colour of one corner.
  double difference_to(std::span<const FlatArea> tiles) const;

  /// Some tiles that follow one another.
  struct Part {
    std::size_t begin = 0, end = 0;
    std::size_t count() const { return end - begin; }
  };

  /// Returns the longest part whose tiles may all be those of the mesh, and are not `taken`: they
  /// are inside of its box and have its colours, or few of them others, and these are joined to
  /// them.
  Part longest_part(std::span<const FlatArea> tiles, const std::vector<bool>& taken) const;

 private:
  bool is_within(const FlatArea& tile) const;
  bool has_color_of(const FlatArea& tile) const;

  const Box box_;
  const Affine to_mesh_;
  const Frame frame_;
  /// The opacities of a mesh are a mask of its tiles.
  const MeshImage picture_;
};

/// Returns a box around tiles.
Box box_of(std::span<const FlatArea> tiles);

}  // namespace gradmesh
