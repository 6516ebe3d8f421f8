#include "window/toolkit/catalogue.h"

#include <cstdint>
#include <memory>

#include "catalogues.h"

namespace gradmesh {
namespace {

/// Returns the 32 bits at a place, the lowest byte first; 0 beyond the end.
std::size_t number_at(std::string_view bytes, std::size_t at) {
  if (at + 4 > bytes.size()) return 0;
  std::size_t number = 0;
  for (std::size_t i = 4; i-- > 0;) number = number << 8 | std::uint8_t(bytes[at + i]);
  return number;
}

/// Returns the text that a table has in a row: its length, and where it begins.
std::string text_at(std::string_view bytes, std::size_t table, std::size_t row) {
  const std::size_t length = number_at(bytes, table + 8 * row);
  const std::size_t at = number_at(bytes, table + 8 * row + 4);
  if (at > bytes.size() || length > bytes.size() - at) return {};
  return std::string(bytes.substr(at, length));
}

std::string_view text_of(const unsigned char* bytes, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes), size};
}

}  // namespace

Catalogue::Catalogue(std::string_view bytes) {
  constexpr std::size_t mark = 0x950412de;
  if (number_at(bytes, 0) != mark) return;
  const std::size_t count = number_at(bytes, 8);
  const std::size_t from = number_at(bytes, 12), to = number_at(bytes, 16);
  for (std::size_t row = 0; row < count && from + 8 * row < bytes.size(); ++row)
    sentences_.emplace(text_at(bytes, from, row), text_at(bytes, to, row));
}

std::string Catalogue::translated(const std::string& text) const {
  const auto found = sentences_.find(text);
  return found == sentences_.end() || found->second.empty() ? text : found->second;
}

Translation translation_into(const std::vector<std::string>& languages) {
  for (const std::string& language : languages) {
    if (language == "en") break;
    if (language != "de") continue;
    const auto german =
        std::make_shared<Catalogue>(text_of(catalogues::de_mo, sizeof catalogues::de_mo));
    return [german](const std::string& text) { return german->translated(text); };
  }
  return [](const std::string& text) { return text; };
}

}  // namespace gradmesh
