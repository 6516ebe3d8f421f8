#pragma once

#include <string>
#include <string_view>

namespace gradmesh {

/// Parts of the text of a style sheet, as Inkscape 1.2 takes them.

/// Takes as many letters, digits, `-`, `_` and escapes as there are off the front, and returns
/// them. Letters are those of ASCII and all from U+00B2 on; of escapes `\e9 ` is any character by
/// its number, and a backslash before a blank or a character from U+00C8 on that one itself.
std::string take_css_letters(std::string_view& text);

/// Takes a name off the front and returns it: letters as above, of which the first, behind one `-`
/// at most, is no digit, `-` or `_`. Takes and returns nothing where there is none.
std::string take_css_name(std::string_view& text);

/// Returns the number of bytes of the string that begins with the quote in front; 1 where it is not
/// closed in its line, and the quote is nothing but a letter.
std::size_t css_string_size(std::string_view text);

/// Returns the number of bytes of the `url(…)` in front; 0 where Inkscape cannot read it: without
/// quotes it holds neither quotes nor brackets, nor letters from U+0080 to U+00B1.
std::size_t css_url_size(std::string_view text);

/// Returns true if a value holds a `url(…)` that cannot be read.
bool has_broken_url(std::string_view value);

/// Returns true if the text begins with a letter from U+0080 to U+00B1, in UTF-8, which ends the
/// reading of an address without quotes.
bool is_odd_letter(std::string_view text);

/// Returns the value of a hexadecimal digit; -1 for any other letter.
int hex_digit(char c);

}  // namespace gradmesh
