#pragma once

#include <libxml/tree.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/affine.h"
#include "formats/svg/read/document.h"

namespace gradmesh {

enum class PaintRole { fill, stroke };

/// A shape or text whose fill or stroke is a mesh gradient, or a group that holds a simplified
/// mesh (formats/svg/read/read_group.h). The nodes belong to the document.
struct MeshObject {
  xmlNode* node = nullptr;
  std::string id;
  PaintRole role = PaintRole::fill;
  /// The meshgradient that the paint names, whose patches may be those of another through href.
  /// Null for groups.
  xmlNode* gradient = nullptr;
  /// The hidden original (formats/svg/write/keep_original.h) that the object is, or is inside of;
  /// null for all others.
  const xmlNode* kept = nullptr;
};

/// Returns every object painted by a mesh gradient, in document order, fill before stroke. The
/// paint may come from a style, a rule, an attribute or a group around the object. Objects in a
/// definition (<mask>, <pattern>, <symbol>, <marker>, <defs>) are among them if something names the
/// definition. Objects in a <clipPath> are not, as nothing of them is painted, nor are the fills of
/// lines (can_paint). An object without an id gets one.
std::vector<MeshObject> mesh_objects(SvgDocument& document);

/// Returns true if the element is a shape or text that a gradient can fill or stroke.
bool can_paint(const xmlNode* node, PaintRole role);

/// Returns true if the element paints nothing itself, and its paint properties are for the elements
/// inside.
bool hands_paint_on(const xmlNode* node);

/// Returns the element that represents the whole object: the node itself or, for a group of blocks,
/// the outermost of the groups around it that are marked `outer` (formats/svg/read/read_group.h).
xmlNode* whole_object(xmlNode* node);
/// Returns the id of whole_object(node), by which the person knows the object; empty if there is
/// none.
std::string object_id(xmlNode* node);

/// Returns the id in a paint `url(#id)`, with or without quotes. A fallback colour may follow in
/// the paint.
std::optional<std::string> referenced_id(std::string_view paint);

/// Returns the colour that a paint `url(#id) colour` falls back to in programs without meshes;
/// empty if there is none.
std::string fallback_color(std::string_view paint);

/// Returns the meshgradient that a paint names; null if it names none.
xmlNode* referenced_mesh(const SvgDocument& document, std::string_view paint);

/// Returns the map from the object's user space to that of the outermost <svg>: the product of the
/// `transform` attributes of the element and of all around it; viewBox and nested viewports do not
/// count. Throws InputError at a malformed transform.
Affine to_document(const MeshObject& object);

}  // namespace gradmesh
