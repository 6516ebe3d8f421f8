#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/affine.h"
#include "formats/svg/group/mixed_groups.h"
#include "formats/svg/group/new_svg.h"
#include "formats/svg/tree/flat_tiles.h"

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

  /// Returns the map from pixels of a page to units of the outermost <svg>.
  const Affine& place(std::size_t page) const { return places_.at(page); }

  /// Adds an object above those that are there, as add_object() does, and returns its id: another
  /// one where that of the mesh is taken.
  std::string add(std::size_t page, NewMesh mesh);
  /// Puts an object in the place of tiles, at least one, which are removed with their clip paths
  /// and masks.
  std::string add_instead(const PartOfTiles& tiles, std::size_t page, NewMesh mesh);

 private:
  xmlNode* layer(std::size_t page);
  /// Adds an object as the last of a group, seen where the page lies.
  xmlNode* add_to(xmlNode* group, std::size_t page, NewMesh& mesh);

  SvgTree& tree_;
  const std::vector<SvgPage> pages_;
  const std::vector<Affine> places_;
  /// What objects of each page go into; null until the first of a page with a layer of its own.
  std::vector<xmlNode*> groups_;
  MixedGroups mixed_;
};

}  // namespace gradmesh
