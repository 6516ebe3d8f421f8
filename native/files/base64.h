#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gradmesh {

/// Returns the bytes as text (RFC 4648, section 4).
std::string base64(std::string_view bytes);

/// Returns the bytes of a text of base64(), or nothing if it is none.
std::optional<std::string> base64_bytes(std::string_view text);

/// Returns the bytes as text: five digits for four bytes, a sixteenth less than base64 takes. The
/// digits are 85 of the 88 printable characters of ASCII that an attribute of XML holds as they are
/// in quotes of either kind, without blanks and backslashes. Characters beyond ASCII hold less: in
/// UTF-8 two bytes tell 11 bits.
std::string base85(std::string_view bytes);

/// Returns the bytes of a text of base85(), or nothing if it is none.
std::optional<std::string> base85_bytes(std::string_view text);

}  // namespace gradmesh
