#pragma once

#include <libxml/tree.h>

#include <optional>
#include <string>
#include <string_view>

#include "formats/svg/tree/svg_tree.h"

namespace gradmesh {

/// Functions that take an object apart by what it paints: into what a group in its place needs, and
/// the rest.

/// Gives `group` all attributes of the shape that are neither geometry nor paint: transform,
/// opacity, filter, clip, mask and the like, also those from rules, and title and description. The
/// shape then no longer has them.
void move_group_attributes(const StyleSheet& styles, xmlNode* shape, xmlNode* group);

/// Gives the shape all attributes of the group but its id and those of our own namespace, and the
/// group's title and description: the reverse of move_group_attributes.
void return_group_attributes(const StyleSheet& styles, xmlNode* group, xmlNode* shape);

/// Returns what rules say of the element, with the values that count for it.
Declarations said_by_rules(const StyleSheet& styles, const xmlNode* node);
/// Writes into the style attribute what rules said of the element and, as it is now, say no more;
/// what they say now and did not say is turned off.
void keep_said(const StyleSheet& styles, const Declarations& said, xmlNode* node);

/// Returns true for a property that acts on an object as a whole and is not inherited.
bool is_effect(std::string_view property);
/// Turns off what rules would do to an object as a whole, such as its opacity.
void turn_off_effects(const StyleSheet& styles, xmlNode* node);

/// Returns true if the group clips, masks or filters what it holds.
bool has_effects(const StyleSheet& styles, const xmlNode* group);

/// Keeps the shape's `paint` (fill or stroke) and turns the other off.
void keep_only_paint(const StyleSheet& styles, xmlNode* shape, const std::string& paint);

/// Adds a copy of the shape's geometry below `parent`, unpainted: without id, transform, classes.
/// Returns the copy.
xmlNode* geometry_copy(const StyleSheet& styles, const xmlNode* shape, xmlNode* parent);

/// Paints `copy` with the stroke of `shape`, in white, opaque where the stroke is.
void paint_stroke_white(const StyleSheet& styles, const xmlNode* shape, xmlNode* copy);

/// Lets `copy` clip where the fill of `shape` would paint.
void set_clip_rule(const StyleSheet& styles, const xmlNode* shape, xmlNode* copy);

/// Returns a paint that names the element with this id, and the colour for programs that do not
/// know the element's kind unless `fallback` is empty.
std::string paint_by(const std::string& id, const std::string& fallback = "");

/// Sets one property of the style attribute, as `!important` where a rule is.
void set_style(const StyleSheet& styles, xmlNode* node, const std::string& property,
               const std::string& value);
/// Sets a paint, also on the parts of a text that have one of their own.
void set_paint(const StyleSheet& styles, xmlNode* node, const std::string& property,
               const std::string& value);
/// Sets a paint that the element has from another one around it there too, if nothing else is left
/// that has it from there. To be called once the element has its own.
void hand_back_paint(const StyleSheet& styles, const xmlNode* node, const std::string& property,
                     const std::string& value);
/// Takes one property out of the style attribute. Returns its value without `!important`, empty if
/// there was none.
std::string take_style(xmlNode* node, const std::string& property);

}  // namespace gradmesh
