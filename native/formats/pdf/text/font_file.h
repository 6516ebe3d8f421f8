#pragma once

#include <memory>
#include <optional>
#include <string>

#include "formats/pdf/objects/page_path.h"

namespace gradmesh {

/// The font that a document holds: Type 1, TrueType, CFF or OpenType, as FreeType reads them. Its
/// glyphs have numbers, of which 0 stands for one that is missing.
class FontFile {
 public:
  /// Returns nothing if it is none.
  static std::shared_ptr<FontFile> open(std::string bytes);
  ~FontFile();
  FontFile(const FontFile&) = delete;
  FontFile& operator=(const FontFile&) = delete;

  /// Return the glyph of a name, of a character of Unicode, of a code by the font's own encoding,
  /// and of a character identifier; 0 where there is none.
  unsigned glyph_named(const std::string& name);
  unsigned glyph_of_character(char32_t character);
  unsigned glyph_of_code(unsigned code);
  unsigned glyph_of_identifier(unsigned identifier);

  /// Returns the outline of a glyph in ems, with y up; nothing where it has none that can be read.
  std::optional<PagePath> outline(unsigned glyph);

 private:
  struct Opened;
  explicit FontFile(std::unique_ptr<Opened> opened);
  std::unique_ptr<Opened> opened_;
};

}  // namespace gradmesh
