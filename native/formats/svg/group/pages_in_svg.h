#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/affine.h"
#include "formats/svg/group/new_svg.h"

namespace gradmesh {

/// Pages whose meshes become objects of a document that is there already, where and as large as
/// they are seen on the page.
class PagesInSvg {
 public:
  /// The pages lie on those of the document with their numbers, as where that is the same document
  /// in another format; on its first one, and further ones beside that, where it has fewer. Their
  /// objects go into the group with the id `into` or, if that is empty, into a new layer for each
  /// of them, above all else. Throws InputError, before the document changes, if there is no such
  /// group, or its transform leaves it no size.
  PagesInSvg(SvgTree& tree, const std::vector<SvgPage>& pages, const std::string& into);

  /// Adds an object above those that are there, as add_object() does, and returns its id: another
  /// one where that of the mesh is taken.
  std::string add(std::size_t page, NewMesh mesh);

 private:
  /// Where objects of a page go, and the map of their coordinates to that group's user space.
  struct Room {
    xmlNode* group;
    Affine place;
  };

  xmlNode* new_layer(const SvgPage& page, const Affine& place);

  SvgTree& tree_;
  std::vector<Room> rooms_;
};

}  // namespace gradmesh
