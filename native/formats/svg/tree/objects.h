#pragma once

#include <libxml/tree.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/affine.h"
#include "base/message.h"
#include "formats/svg/tree/svg_tree.h"

namespace gradmesh {

enum class PaintRole { fill, stroke };
/// Returns the name of the property: "fill" or "stroke".
const char* paint_name(PaintRole role);

/// Why the mesh of an object can be told, but not changed.
enum class LeftAlone {
  no,
  /// It is the paint of a <use>, for what the clone shows and what has no paint of its own.
  clone,
  /// It has its mesh from a group around it, and a clone elsewhere shows it in another paint.
  cloned,
  /// A flowRoot, whose letters are where their region lets them.
  flowed,
  /// Parts of a text have another paint, or another opacity.
  mixed,
};

/// A shape or text whose fill or stroke is a mesh gradient, or a group that holds a simplified
/// mesh (formats/svg/group/mesh_group.h). The nodes belong to the document, and only
/// formats/ looks at them.
struct MeshObject {
  xmlNode* node = nullptr;
  std::string id;
  PaintRole role = PaintRole::fill;
  /// The meshgradient that the paint names, whose patches may be those of another through href.
  /// Null for groups.
  xmlNode* gradient = nullptr;
  /// The hidden original (formats/svg/tree/kept.h) that the object is, or is inside of; null for
  /// all others.
  const xmlNode* kept = nullptr;
  LeftAlone left_alone = LeftAlone::no;

  bool is_group() const { return !gradient; }
  bool operator==(const MeshObject&) const = default;
};

/// Returns every object painted by a mesh gradient, in document order, fill before stroke. The
/// paint may come from a style, a rule, an attribute or a group around the object, that of a text
/// from all of its parts. Objects in a
/// definition (<mask>, <pattern>, <symbol>, <marker>, <defs>) are among them if something names the
/// definition. Objects in a <clipPath> are not, as nothing of them is painted, nor are the fills of
/// lines (can_paint). An object without an id gets one.
std::vector<MeshObject> mesh_objects(SvgTree& tree);

/// Returns the places in `objects`, all objects of the document, of those with this id and of those
/// inside the element with this id. A hidden original is among them only if the id names the
/// original or something in it. Throws InputError if there are none.
std::vector<std::size_t> objects_named(const SvgTree& tree, const std::vector<MeshObject>& objects,
                                       const std::string& id);
/// Returns the places of all objects but hidden originals. Throws InputError if there are none.
std::vector<std::size_t> objects_shown(const SvgTree& tree, const std::vector<MeshObject>& objects);

/// Returns how messages name the object's element.
Message describe(const MeshObject& object);
/// Throws InputError about the object's element.
[[noreturn]] void fail(const MeshObject& object, const Message& reason);
/// Throws InputError if the object is to be left alone.
void check_can_change(const MeshObject& object);

/// Returns true if the element is a shape or text that a gradient can fill or stroke.
bool can_paint(const xmlNode* node, PaintRole role);

/// Returns true if the element paints nothing itself, and its paint properties are for the elements
/// inside.
bool hands_paint_on(const xmlNode* node);

/// Returns the element that represents the whole object: the node itself or, for a group of blocks,
/// the outermost of the groups around the node that belong to the same object.
xmlNode* whole_object(xmlNode* node);
/// Returns the id of whole_object(node), by which the person knows the object; empty if there is
/// none.
std::string object_id(xmlNode* node);

/// Returns the element that a value such as `url(#id)` names; null if it names none.
xmlNode* referenced(const SvgTree& tree, const std::optional<std::string>& value);
/// Returns the meshgradient that a paint names; null if it names none.
xmlNode* referenced_mesh(const SvgTree& tree, const std::optional<std::string>& paint);
/// Returns the mask that holds the opacities of the mesh of a group of blocks; null if the blocks
/// hold them.
xmlNode* opacity_mask(const SvgTree& tree, const xmlNode* group);

/// Returns the map from the object's user space to that of the outermost <svg>: the product of the
/// `transform` attributes of the element and of all around it; viewBox and nested viewports do not
/// count. Throws InputError at a malformed transform.
Affine to_document(const MeshObject& object);
/// Returns the same map of any element.
Affine to_document(const xmlNode* element);
/// Returns the map from the object's user space to pixels of the document in its own size. Throws
/// as to_document does.
Affine to_page(const SvgTree& tree, const MeshObject& object);

}  // namespace gradmesh
