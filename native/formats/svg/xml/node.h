#pragma once

#include <libxml/tree.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"

namespace gradmesh {

/// Namespaces of SVG, of its older href attribute, and of `inkscape:label`.
inline constexpr std::string_view svg_namespace = "http://www.w3.org/2000/svg";
inline constexpr std::string_view xlink_namespace = "http://www.w3.org/1999/xlink";
inline constexpr std::string_view inkscape_namespace =
    "http://www.inkscape.org/namespaces/inkscape";

/// Returns the SVG name of an element (`path`); empty for elements of other namespaces. Elements
/// without any namespace count as SVG.
std::string_view svg_name(const xmlNode* node);

/// Returns the element around `node`; null above the root.
xmlNode* parent_element(const xmlNode* node);

/// Returns the children that are elements, in document order; only those with the SVG name `name`
/// if given.
std::vector<xmlNode*> child_elements(const xmlNode* node, std::string_view name = {});

/// Returns the element and all elements below it, each before those inside it.
std::vector<xmlNode*> elements_from(const xmlNode* node);

/// Returns the attributes of an element, in all namespaces.
std::vector<xmlAttr*> attributes(const xmlNode* node);

/// Expands the entities in the names of namespaces, which libxml2 leaves as they are written:
/// Illustrator declares all its namespaces so. Throws as text_of() does.
void expand_namespaces(xmlNode* root);

/// Returns the text that libxml2 holds; empty for null.
std::string_view view(const xmlChar* text);

/// Returns the text of a node list (the children of an attribute or an element), without elements.
/// Short entities without further references inside are expanded. Throws InputError about `owner`
/// at any other entity, so that nothing is expanded without bound.
std::string text_of(const xmlNode* children, const xmlNode* owner);

/// Returns the value of the attribute that is in no namespace, or in `space` if given; nothing if
/// there is none.
std::optional<std::string> attribute(const xmlNode* node, const char* name,
                                     std::string_view space = {});

/// Returns the value of `xlink:href`, empty if there is none. A plain `href` is nothing to Inkscape
/// 1.2.
std::string href(const xmlNode* node);

/// Returns how messages name an element: `path "p1"`, or `path in line 12` where it has no id.
Message describe(const xmlNode* node);

/// Throws InputError with the text `FILE: ELEMENT: REASON.` The file's name is the document's URL.
[[noreturn]] void fail(const xmlNode* node, const Message& reason);

/// Adds a new element in the namespace of `parent`, as its last child, and returns it.
xmlNode* add_child(xmlNode* parent, const char* name);

/// Adds a copy of the element and all below it, with its ids, as the last child of `parent`, and
/// returns it.
xmlNode* add_copy(xmlNode* parent, const xmlNode* node);

/// Gives the element another name in its namespace.
void set_name(xmlNode* node, const char* name);

/// Sets an attribute in no namespace.
void set_attribute(xmlNode* node, const char* name, const std::string& value);
/// Sets an attribute in the namespace `space`, which is declared on the root with the given prefix
/// (or the prefix and a number) if the document does not declare it yet.
void set_attribute(xmlNode* node, const char* name, const std::string& value,
                   std::string_view space, const char* prefix);
void remove_attribute(xmlNode* node, const char* name);
void remove_attribute(xmlNode* node, const char* name, std::string_view space);

/// Takes a node out of its document and frees it with all below it.
void remove_node(xmlNode* node);
/// Removes the elements below `root` for which `is_unwanted` returns true.
void remove_elements(xmlNode* root, const std::function<bool(const xmlNode*)>& is_unwanted);

}  // namespace gradmesh
