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

/// The SVG name of an element (`path`); empty for elements of other namespaces. Elements without
/// any namespace count as SVG.
std::string_view svg_name(const xmlNode* node);

/// The element around `node`; null above the root.
xmlNode* parent_element(const xmlNode* node);

/// Children that are elements, in document order; only those called `name` in SVG if given.
std::vector<xmlNode*> child_elements(const xmlNode* node, std::string_view name = {});

/// Text of a node list (the children of an attribute or an element), elements left out. Short
/// entities without further references inside are put in; throws InputError about `owner` at any
/// other, so that nothing is expanded without bound.
std::string text_of(const xmlNode* children, const xmlNode* owner);

/// Value of the attribute that is in no namespace, or in `space` if given.
std::optional<std::string> attribute(const xmlNode* node, const char* name,
                                     std::string_view space = {});

/// How messages name an element: `path "p1"`, or `path in line 12` where it has no id.
Message describe(const xmlNode* node);

/// Throws InputError `FILE: ELEMENT: REASON.` The file's name is the document's URL.
[[noreturn]] void fail(const xmlNode* node, const Message& reason);

}  // namespace gradmesh
