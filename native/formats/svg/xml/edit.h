#pragma once

#include <libxml/tree.h>

#include <string>
#include <string_view>

namespace gradmesh {

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

/// The namespace of `inkscape:label`.
inline constexpr std::string_view inkscape_namespace =
    "http://www.inkscape.org/namespaces/inkscape";

}  // namespace gradmesh
