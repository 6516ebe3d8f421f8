#pragma once

#include <libxml/tree.h>

#include <map>
#include <string>
#include <utility>

#include "formats/svg/read/document.h"
#include "formats/svg/write/write_gradient.h"
#include "formats/svg/write/write_group.h"
#include "geom/box.h"

namespace gradmesh {

/// The ids of a block's path and gradient, by the block's first face and the number of its faces.
using BlockIds = std::map<std::pair<int, int>, std::pair<std::string, std::string>>;

/// Writes the blocks of a mesh as paths with a meshgradient each.
class BlocksWriter {
 public:
  /// `id` is the prefix of the ids of all that is written; `fallback` is the colour for programs
  /// that know no meshes, or empty.
  BlocksWriter(SvgDocument& document, xmlNode* defs, const WrittenMesh& written, std::string id,
               std::string fallback);

  /// Adds the blocks to `parent`, the largest below, before the node `before` or at the end.
  /// Blocks of the same faces get these ids, where they are free. Returns the box around the paths.
  Box write(xmlNode* parent, xmlNode* before, MeshChannel channel, const BlockIds& ids = {}) const;

 private:
  /// Returns the ids that a block gets, if any.
  std::pair<std::string, std::string> ids_of(const Rectangle& block, const BlockIds& ids) const;
  std::string style(const std::string& gradient, MeshChannel channel) const;
  double seam_margin() const;

  SvgDocument& document_;
  xmlNode* defs_;
  const WrittenMesh& written_;
  std::string id_, fallback_;
};

}  // namespace gradmesh
