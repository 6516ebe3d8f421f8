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
  /// The meshgradient that the paint names; its patches may be another's, through href. Null for
  /// groups.
  xmlNode* gradient = nullptr;
  /// The hidden original (formats/svg/write/keep_original.h) that it is, or is inside of; null for
  /// all others.
  const xmlNode* kept = nullptr;
};

/// Every object painted by a mesh gradient, in document order, fill before stroke. The paint may
/// come from a style, a rule, an attribute or a group around the object. What is defined to be used
/// (in <mask>, <pattern>, <symbol>, <marker>, <defs>) is among them where something names it. What
/// is in a <clipPath> is not, as nothing of it is painted, nor are lines' fills (can_paint). An
/// object without an id gets one.
std::vector<MeshObject> mesh_objects(SvgDocument& document);

/// Whether the element is a shape or text that a gradient can fill or stroke.
bool can_paint(const xmlNode* node, PaintRole role);

/// Whether the element paints nothing itself, and what it says of paint is for what is inside.
bool hands_paint_on(const xmlNode* node);

/// The element that stands for the whole object: itself or, for a group of blocks inside a group
/// that does, that one.
xmlNode* whole_object(xmlNode* node);
/// Its id, by which the person knows the object. Empty where there is none.
std::string object_id(xmlNode* node);

/// The id in a paint `url(#id)`, with or without quotes; what follows is the fallback colour.
std::optional<std::string> referenced_id(std::string_view paint);

/// The colour that a paint `url(#id) colour` falls back to where meshes are not known; empty where
/// there is none.
std::string fallback_color(std::string_view paint);

/// The meshgradient that a paint names; null where it names none.
xmlNode* referenced_mesh(const SvgDocument& document, std::string_view paint);

/// From the object's user space to that of the outermost <svg>: the product of the `transform`
/// attributes of the element and of all around it; viewBox and nested viewports do not count.
/// Throws InputError at a malformed one.
Affine to_document(const MeshObject& object);

}  // namespace gradmesh
