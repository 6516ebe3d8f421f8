#pragma once

#include <libxml/tree.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"

namespace gradmesh {

/// Namespaces of SVG and of its older href attribute.
inline constexpr std::string_view svg_namespace = "http://www.w3.org/2000/svg";
inline constexpr std::string_view xlink_namespace = "http://www.w3.org/1999/xlink";

/// Returns the SVG name of an element (`path`); empty for elements of other namespaces. Elements
/// without any namespace count as SVG.
std::string_view svg_name(const xmlNode* node);

/// Returns the element around `node`; null above the root.
xmlNode* parent_element(const xmlNode* node);

/// Returns the children that are elements, in document order; only those with the SVG name `name`
/// if given.
std::vector<xmlNode*> child_elements(const xmlNode* node, std::string_view name = {});

/// Returns the text of a node list (the children of an attribute or an element), without elements.
/// Short entities without further references inside are expanded. Throws InputError about `owner`
/// at any other entity, so that nothing is expanded without bound.
std::string text_of(const xmlNode* children, const xmlNode* owner);

/// Returns the value of the attribute that is in no namespace, or in `space` if given; nothing if
/// there is none.
std::optional<std::string> attribute(const xmlNode* node, const char* name,
                                     std::string_view space = {});

/// Returns how messages name an element: `path "p1"`, or `path in line 12` where it has no id.
Message describe(const xmlNode* node);

/// Throws InputError with the text `FILE: ELEMENT: REASON.` The file's name is the document's URL.
[[noreturn]] void fail(const xmlNode* node, const Message& reason);

}  // namespace gradmesh
