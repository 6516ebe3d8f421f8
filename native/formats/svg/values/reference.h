#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gradmesh {

/// References to elements as Inkscape 1.2 follows them. `file` is the name or path of the document
/// itself: in front of `#` its name leads to the document, any other out of it.

/// Returns a text in which each `%41` is the byte of this number, as in addresses.
std::string percent_decoded(std::string_view text);

/// Returns the id that a link such as `#id` leads to; nothing if it leads to no element here.
std::optional<std::string> linked_id(std::string_view link, std::string_view file);

/// Returns the id that a value `url(#id)` leads to, with or without quotes; `URL` is nothing. A
/// fallback colour may follow in a paint.
std::optional<std::string> referenced_id(std::string_view value, std::string_view file);

/// Returns the colour that a paint `url(#id) colour` falls back to in programs without meshes;
/// empty if there is none.
std::string fallback_color(std::string_view paint);

}  // namespace gradmesh
