#include "formats/pdf/text/font_file.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_CID_H
#include FT_OUTLINE_H

#include <map>

namespace gradmesh {
namespace {

/// Follows the outline that FreeType decomposes; its numbers are those of the font.
class OutlineWalk {
 public:
  explicit OutlineWalk(double scale) : scale_(scale) {}

  static int move(const FT_Vector* to, void* walk) { return of(walk).add_move(*to); }
  static int line(const FT_Vector* to, void* walk) { return of(walk).add_line(*to); }
  static int conic(const FT_Vector* by, const FT_Vector* to, void* walk) {
    return of(walk).add_conic(*by, *to);
  }
  static int cubic(const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* walk) {
    return of(walk).add_cubic(*a, *b, *to);
  }

  PagePath path() && {
    close();
    return std::move(path_);
  }

 private:
  using Kind = PagePath::Step::Kind;

  static OutlineWalk& of(void* walk) { return *static_cast<OutlineWalk*>(walk); }
  glm::dvec2 point(const FT_Vector& v) const {
    return scale_ * glm::dvec2(double(v.x), double(v.y));
  }
  int add(Kind kind, glm::dvec2 a, glm::dvec2 b, glm::dvec2 to) {
    path_.steps.push_back({kind, {a, b, to}});
    here_ = to;
    return 0;
  }
  void close() {
    if (!path_.steps.empty()) add(Kind::close, begin_, begin_, begin_);
  }
  int add_move(const FT_Vector& to) {
    close();
    begin_ = point(to);
    return add(Kind::move, begin_, begin_, begin_);
  }
  int add_line(const FT_Vector& to) { return add(Kind::line, point(to), point(to), point(to)); }
  int add_conic(const FT_Vector& by, const FT_Vector& to) {
    const glm::dvec2 middle = point(by), end = point(to);
    return add(Kind::curve, here_ + 2.0 / 3 * (middle - here_), end + 2.0 / 3 * (middle - end),
               end);
  }
  int add_cubic(const FT_Vector& a, const FT_Vector& b, const FT_Vector& to) {
    return add(Kind::curve, point(a), point(b), point(to));
  }

  const double scale_;
  PagePath path_;
  glm::dvec2 here_{0.0}, begin_{0.0};
};

}  // namespace

struct FontFile::Opened {
  ~Opened() {
    if (face) FT_Done_Face(face);
    if (library) FT_Done_FreeType(library);
  }

  /// Returns true if the font has an encoding of that kind, which is then the one that is asked.
  bool choose(FT_Encoding encoding) const { return FT_Select_Charmap(face, encoding) == 0; }
  bool choose(int platform, int encoding) const {
    for (int n = 0; n < face->num_charmaps; ++n) {
      const FT_CharMap map = face->charmaps[n];
      if (map->platform_id == platform && map->encoding_id == encoding)
        return FT_Set_Charmap(face, map) == 0;
    }
    return false;
  }

  std::string bytes;
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  /// Of a font whose glyphs have character identifiers, filled when it is first asked.
  std::map<unsigned, unsigned> glyphs_of_identifiers;
};

FontFile::FontFile(std::unique_ptr<Opened> opened) : opened_(std::move(opened)) {}
FontFile::~FontFile() = default;

std::shared_ptr<FontFile> FontFile::open(std::string bytes) {
  auto opened = std::make_unique<Opened>();
  opened->bytes = std::move(bytes);
  if (FT_Init_FreeType(&opened->library) != 0) return nullptr;
  if (FT_New_Memory_Face(opened->library, reinterpret_cast<const FT_Byte*>(opened->bytes.data()),
                         FT_Long(opened->bytes.size()), 0, &opened->face) != 0)
    return nullptr;
  if (!FT_IS_SCALABLE(opened->face) || opened->face->units_per_EM == 0) return nullptr;
  return std::shared_ptr<FontFile>(new FontFile(std::move(opened)));
}

unsigned FontFile::glyph_named(const std::string& name) {
  return FT_HAS_GLYPH_NAMES(opened_->face) ? FT_Get_Name_Index(opened_->face, name.c_str()) : 0;
}

unsigned FontFile::glyph_of_character(char32_t character) {
  return opened_->choose(FT_ENCODING_UNICODE) ? FT_Get_Char_Index(opened_->face, character) : 0;
}

unsigned FontFile::glyph_of_code(unsigned code) {
  FT_Face face = opened_->face;
  // Symbols of Windows lie in a private area (ISO 32000-1, 9.6.6.4).
  if (opened_->choose(3, 0))
    for (const unsigned area : {0xF000U, 0U, 0xF100U, 0xF200U})
      if (const unsigned glyph = FT_Get_Char_Index(face, area + code)) return glyph;
  if (opened_->choose(1, 0))
    if (const unsigned glyph = FT_Get_Char_Index(face, code)) return glyph;
  for (const FT_Encoding encoding : {FT_ENCODING_ADOBE_CUSTOM, FT_ENCODING_ADOBE_STANDARD})
    if (opened_->choose(encoding))
      if (const unsigned glyph = FT_Get_Char_Index(face, code)) return glyph;
  return 0;
}

unsigned FontFile::glyph_of_identifier(unsigned identifier) {
  FT_Face face = opened_->face;
  FT_Bool has_identifiers = 0;
  if (FT_Get_CID_Is_Internally_CID_Keyed(face, &has_identifiers) != 0 || !has_identifiers)
    return identifier < unsigned(face->num_glyphs) ? identifier : 0;
  auto& glyphs = opened_->glyphs_of_identifiers;
  if (glyphs.empty())
    for (unsigned glyph = 0; glyph < unsigned(face->num_glyphs); ++glyph) {
      FT_UInt has = 0;
      if (FT_Get_CID_From_Glyph_Index(face, glyph, &has) == 0) glyphs.try_emplace(has, glyph);
    }
  const auto found = glyphs.find(identifier);
  return found == glyphs.end() ? 0 : found->second;
}

std::optional<PagePath> FontFile::outline(unsigned glyph) {
  FT_Face face = opened_->face;
  if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE) != 0 ||
      face->glyph->format != FT_GLYPH_FORMAT_OUTLINE)
    return {};
  FT_Outline_Funcs walk{
      OutlineWalk::move, OutlineWalk::line, OutlineWalk::conic, OutlineWalk::cubic, 0, 0};
  OutlineWalk path(1.0 / face->units_per_EM);
  if (FT_Outline_Decompose(&face->glyph->outline, &walk, &path) != 0) return {};
  return std::move(path).path();
}

}  // namespace gradmesh
