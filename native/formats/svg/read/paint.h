#pragma once

#include <libxml/tree.h>

#include <optional>
#include <string>
#include <string_view>

#include "formats/svg/read/document.h"

namespace gradmesh {

/// Taking an object apart by what it paints: what a group in its place needs, what is left.

/// Gives `group` all attributes of the shape that are neither geometry nor paint: transform,
/// opacity, filter, clip, mask and the like, those from rules too, and title and description.
/// They are then no longer the shape's.
void move_group_attributes(const StyleSheet& styles, xmlNode* shape, xmlNode* group);

/// The reverse: gives the shape all attributes of the group but its id and those of our own
/// namespace, and its title and description.
void return_group_attributes(xmlNode* group, xmlNode* shape);

/// Whether the group clips, masks or filters what it holds.
bool has_effects(const StyleSheet& styles, const xmlNode* group);

/// Leaves the shape its `paint` (fill or stroke) and turns the other off.
void keep_only_paint(const StyleSheet& styles, xmlNode* shape, const std::string& paint);

/// A copy of the shape's geometry below `parent`, unpainted: without id, transform, classes.
xmlNode* geometry_copy(const StyleSheet& styles, const xmlNode* shape, xmlNode* parent);

/// Paints `copy` with the stroke of `shape`, in white, opaque where the stroke is.
void paint_stroke_white(const StyleSheet& styles, const xmlNode* shape, xmlNode* copy);

/// Lets `copy` clip where the fill of `shape` would paint.
void set_clip_rule(const StyleSheet& styles, const xmlNode* shape, xmlNode* copy);

/// Sets one property of the style attribute.
void set_style(xmlNode* node, const std::string& property, const std::string& value);

/// Whether an attribute or a rule of the document names this id.
bool is_used(const SvgDocument& document, const std::string& id);
/// Takes one property out of the style attribute; its value, empty where there is none.
std::string take_style(xmlNode* node, const std::string& property);

/// Removes the element with this id, and then the mesh gradient that it alone used by href, if no
/// attribute and no rule of the document names it.
void remove_if_unused(SvgDocument& document, const std::string& id);

}  // namespace gradmesh
