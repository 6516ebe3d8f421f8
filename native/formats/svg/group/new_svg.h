#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "formats/svg/group/mixed_groups.h"

namespace gradmesh {

/// A page of a new document, in pixels; the coordinates of its meshes begin at its upper left
/// corner, y down.
struct SvgPage {
  double width, height;
  /// The name of its layer, where there are several pages.
  std::string name = {};
  /// Its number among those of the document that it is from, from 1.
  int number = 1;
};

/// Pixels between pages that lie beside one another.
inline constexpr double page_gap = 20;

/// A new document.
class NewSvg {
 public:
  /// Several pages lie beside one another, each with a layer of its own.
  explicit NewSvg(const std::vector<SvgPage>& pages);

  /// Adds an object, as add_object() does, above those that are there.
  void add(std::size_t page, const NewMesh& mesh) {
    add_object(tree_, groups_.within(tree_, layer(page), mesh.groups), mesh);
  }

  const SvgTree& tree() const { return tree_; }

 private:
  xmlNode* layer(std::size_t page) const;

  SvgTree tree_;
  std::size_t pages_;
  MixedGroups groups_;
};

}  // namespace gradmesh
