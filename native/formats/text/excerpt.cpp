#include "formats/text/excerpt.h"

namespace gradmesh {

std::string excerpt(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string shown = "\"";
  bool blank = true;
  for (const char c : text) {
    // Cut between characters, never inside one: UTF-8 continuation bytes start with binary 10.
    if (shown.size() > longest && (static_cast<unsigned char>(c) & 0xC0) != 0x80) {
      shown += "...";
      break;
    }
    const bool is_control = static_cast<unsigned char>(c) <= 32 || c == 127;
    if (!is_control) shown += c;
    if (is_control && !blank) shown += ' ';
    blank = is_control;
  }
  return shown + '"';
}

}  // namespace gradmesh
