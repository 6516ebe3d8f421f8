#pragma once

#include <libxml/tree.h>

#include <map>
#include <string>
#include <vector>

#include "form/counts.h"
#include "form/cut_blocks.h"
#include "formats/svg/tree/objects.h"
#include "mesh/parts.h"

namespace gradmesh {

/// A simplified mesh in a document is a group of blocks. Attributes of our own namespace say how
/// the blocks are connected; shapes and colours are those of the blocks themselves.
///   version         on the group: 1
///   role            on the group: fill or stroke, what the mesh paints
///   handles-before  on the group: handles of the mesh before it was first simplified; absent in
///                   documents of gradmesh 0.1
///   patches-before  on the group: patches of the same mesh
///   curves          on the group: the curves with more than one block along them
///                   (formats/svg/values/curves.h)
///   original        on the group: the mesh before it was first simplified, or as a person has
///                   edited it since; may be absent (formats/svg/group/memory.h)
///   colors          on the group: the texts of colours that hexadecimal digits could not give back
///                   (formats/svg/gradient/color_texts.h); may be absent
///   written         on the group: its blocks as they were last written, which tells what a person
///                   has moved; may be absent
///   label           on the group: its inkscape:label as it was written; on an object that was
///                   one, too
///   face            on a block's path: number of its first face; the others follow row by row
/// formats/svg/tree/own.h has the others.

/// Returns `handles-before`, 0 if it is absent or not a number, and `patches-before`. Throws
/// InputError if the latter is not a number.
MeshCounts counts_before(const MeshObject& group);
/// Returns the number of blocks of a group.
int block_count(const MeshObject& group);

/// The faces of its group's mesh that a block holds.
struct BlockFaces {
  int first = 0, rows = 0, columns = 0;
};

/// Returns the faces of each block of a group, by its path, as the mesh is numbered that was read:
/// a person may have cut or removed blocks since their faces were numbered. Throws InputError if a
/// gradient cannot be read.
std::map<const xmlNode*, BlockFaces> block_faces(const SvgTree& tree, const xmlNode* group);

/// A block that a person has chosen.
struct ChosenBlock {
  /// The place of its group among the objects.
  std::size_t object;
  BlockFaces faces;
  /// The number of faces of all blocks of the group.
  int faces_of_all;
};
/// Returns the block whose path has this id; `objects` are all objects of the document. Throws
/// InputError if the id names something else.
ChosenBlock find_block(const SvgTree& tree, const std::vector<MeshObject>& objects,
                       const std::string& id);

/// Returns the blocks of a group in the order of their faces, in the group's user space. Throws
/// InputError if blocks are missing.
std::vector<PatchGrid> read_mesh_blocks(const SvgTree& tree, const xmlNode* group);

/// Returns the mesh of a group, in the group's user space. Throws InputError if blocks are missing
/// or do not fit together.
MeshParts read_mesh_group(const SvgTree& tree, const xmlNode* group);

/// Returns the blocks of a group that were written so, in the group's user space, as a person has
/// left them, who may have cut or removed some. If blocks have lost their places, or `written` is
/// empty, it is not known how they were written. Throws InputError if blocks are missing then, or
/// if it cannot be told how one was cut.
EditedBlocks read_edited_group(const SvgTree& tree, const xmlNode* group,
                               const std::vector<PatchGrid>& written);
/// Returns them for the blocks that the group remembers as written.
EditedBlocks read_edited_group(const SvgTree& tree, const MeshObject& group);

}  // namespace gradmesh
