#pragma once

#include <string>
#include <string_view>

namespace gradmesh {

/// Parts of the text of a style sheet, as Inkscape 1.2 takes them.

/// Takes as many letters, digits, `-`, `_` and escapes as there are off the front, and returns
/// them.
std::string take_css_letters(std::string_view& text);

/// Takes a name off the front and returns it: letters as above, of which the first, behind one `-`
/// at most, is no digit, `-` or `_`. Takes and returns nothing where there is none.
std::string take_css_name(std::string_view& text);

/// Returns the number of bytes of the string that begins with the quote in front; 1 where it is not
/// closed in its line, and the quote is nothing but a letter.
std::size_t css_string_size(std::string_view text);

}  // namespace gradmesh
