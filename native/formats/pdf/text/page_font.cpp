#include "formats/pdf/text/page_font.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <qpdf/QUtil.hh>

#include "base/clamped_int.h"
#include "base/error.h"
#include "formats/pdf/objects/dictionary.h"
#include "formats/pdf/objects/stream_bytes.h"

namespace gradmesh {
namespace {

constexpr double per_em = 1000;
constexpr int most_codes = 1 << 16;

std::string name_of(QPDFObjectHandle object) {
  return object.isName() ? object.getName().substr(1) : std::string();
}

int code_of(QPDFObjectHandle object, int otherwise) {
  return clamped_int(number_of(object).value_or(otherwise), -1, most_codes);
}

/// Returns the font that a descriptor holds, if it does.
std::shared_ptr<FontFile> file_of(QPDFObjectHandle descriptor) {
  for (const char* key : {"/FontFile", "/FontFile2", "/FontFile3"})
    if (QPDFObjectHandle file = value_of(descriptor, key); file.isStream())
      return FontFile::open(stream_bytes(file).bytes);
  return nullptr;
}

/// Returns the one character of a text in UTF-8; nothing if it is not one.
std::optional<char32_t> character_of(const std::string& utf8) {
  if (utf8.empty()) return {};
  const auto first = static_cast<unsigned char>(utf8[0]);
  const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (utf8.size() != length) return {};
  char32_t character = length == 1 ? first : first & (0xFFU >> (length + 1));
  for (std::size_t n = 1; n < length; ++n)
    character = character << 6 | (static_cast<unsigned char>(utf8[n]) & 0x3F);
  return character;
}

/// Returns the character that a glyph's name says, where that is a letter or a number in
/// hexadecimal: other names are known to the fonts that use them.
std::optional<char32_t> character_named(const std::string& name) {
  if (name.size() == 1) return static_cast<unsigned char>(name[0]);
  const std::size_t prefix = name.starts_with("uni") ? 3 : name.starts_with("u") ? 1 : 0;
  if (prefix == 0 || name.size() < prefix + 4 || name.size() > prefix + 6) return {};
  unsigned number = 0;
  const auto [end, error] =
      std::from_chars(name.data() + prefix, name.data() + name.size(), number, 16);
  if (error != std::errc() || end != name.data() + name.size()) return {};
  return number;
}

}  // namespace

PageFont::PageFont(QPDFObjectHandle font) : font_(std::move(font)) {
  const std::string kind = name_of(value_of(font_, "/Subtype"));
  is_composite_ = kind == "Type0";
  is_of_contents_ = kind == "Type3";
  if (is_of_contents_) matrix_ = matrix_of(value_of(font_, "/FontMatrix"));
  if (is_composite_)
    read_composite();
  else
    read_simple();
  descriptor_ = value_of(is_composite_ ? descendant_ : font_, "/FontDescriptor");
  constexpr int symbolic = 1 << 2;
  const double flags = number_of(value_of(descriptor_, "/Flags")).value_or(0);
  is_symbolic_ = (clamped_int(flags, 0, 1 << 30) & symbolic) != 0;
  if (const auto ascent = number_of(value_of(descriptor_, "/Ascent")); ascent && *ascent > 0)
    ascent_ = *ascent / per_em;
  if (const auto descent = number_of(value_of(descriptor_, "/Descent")); descent && *descent < 0)
    descent_ = *descent / per_em;
}

void PageFont::read_simple() {
  read_encoding();
  // Widths of such contents are in their own coordinates.
  const double unit = is_of_contents_ ? matrix_.linear[0].x : 1 / per_em;
  const int first = code_of(value_of(font_, "/FirstChar"), 0);
  const std::vector<QPDFObjectHandle> widths = elements_of(value_of(font_, "/Widths"));
  for (std::size_t n = 0; n < widths.size() && n < 256; ++n)
    if (const auto width = number_of(widths[n]); width && first >= 0)
      advances_[unsigned(first) + unsigned(n)] = unit * *width;
  if (const auto missing = number_of(value_of(value_of(font_, "/FontDescriptor"), "/MissingWidth")))
    usual_advance_ = *missing / per_em;
}

void PageFont::read_encoding() {
  QPDFObjectHandle encoding = value_of(font_, "/Encoding");
  const std::string base =
      name_of(encoding.isName() ? encoding : value_of(encoding, "/BaseEncoding"));
  if (base == "WinAnsiEncoding") encoding_ = Encoding::win_ansi;
  if (base == "MacRomanEncoding") encoding_ = Encoding::mac_roman;
  unsigned code = 0;
  for (QPDFObjectHandle each : elements_of(value_of(encoding, "/Differences"))) {
    if (each.isNumber()) code = unsigned(std::max(0, code_of(each, 0)));
    if (each.isName()) names_[code++] = name_of(each);
  }
}

void PageFont::read_composite() {
  const std::string encoding = name_of(value_of(font_, "/Encoding"));
  is_vertical_ = encoding.ends_with("-V");
  has_identifiers_ = encoding.starts_with("Identity");
  const auto descendants = elements_of(value_of(font_, "/DescendantFonts"));
  descendant_ = descendants.empty() ? QPDFObjectHandle::newNull() : descendants[0];
  usual_advance_ = number_of(value_of(descendant_, "/DW")).value_or(per_em) / per_em;
  read_identifier_widths(value_of(descendant_, "/W"));
  if (QPDFObjectHandle map = value_of(descendant_, "/CIDToGIDMap"); map.isStream())
    glyphs_of_identifiers_ = stream_bytes(map).bytes;
}

/// Reads [first [width ...]] and [first last width], one after the other.
void PageFont::read_identifier_widths(QPDFObjectHandle widths) {
  const std::vector<QPDFObjectHandle> all = elements_of(widths);
  for (std::size_t n = 0; n + 1 < all.size();) {
    const int first = code_of(all[n], -1);
    QPDFObjectHandle next = all[n + 1];
    if (first < 0) return;
    if (next.isArray()) {
      int code = first;
      for (QPDFObjectHandle each : next.getArrayAsVector())
        if (code < most_codes) advances_[unsigned(code++)] = number_of(each).value_or(0) / per_em;
      n += 2;
      continue;
    }
    const int last = code_of(next, -1);
    if (n + 2 >= all.size()) return;
    const double width = number_of(all[n + 2]).value_or(0) / per_em;
    for (int code = first; code <= last && code < most_codes; ++code)
      advances_[unsigned(code)] = width;
    n += 3;
  }
}

std::vector<PageFont::Glyph> PageFont::glyphs_of(const std::string& text) const {
  std::vector<Glyph> glyphs;
  const std::size_t bytes = is_composite_ ? 2 : 1;
  for (std::size_t n = 0; n + bytes <= text.size(); n += bytes) {
    unsigned code = 0;
    for (std::size_t k = 0; k < bytes; ++k)
      code = code << 8 | static_cast<unsigned char>(text[n + k]);
    glyphs.push_back({code, !is_composite_ && code == ' ', advance_of(code)});
  }
  return glyphs;
}

double PageFont::advance_of(unsigned code) const {
  // Of the fonts that every viewer has, a document need not say the widths.
  constexpr double guessed = 0.55;
  if (const auto found = advances_.find(code); found != advances_.end()) return found->second;
  return usual_advance_.value_or(is_of_contents_ ? 0 : guessed);
}

std::shared_ptr<const PagePath> PageFont::outline(unsigned code) {
  if (!file_) file_ = file_of(descriptor_);
  FontFile* const file = file_->get();
  if (!file) return nullptr;
  const auto known = outlines_.find(code);
  if (known != outlines_.end()) return known->second;
  std::shared_ptr<const PagePath> outline;
  if (const auto glyph = glyph_number(*file, code))
    if (auto path = file->outline(*glyph))
      outline = std::make_shared<const PagePath>(*std::move(path));
  return outlines_[code] = outline;
}

/// Returns the number of a glyph in the font's file; nothing where that cannot be known.
std::optional<unsigned> PageFont::glyph_number(FontFile& file, unsigned code) const {
  if (!is_composite_) {
    // Of what is missing viewers show a box of the font's own, or another font's letter.
    const unsigned glyph = glyph_by_encoding(file, code);
    return glyph > 0 ? std::optional(glyph) : std::nullopt;
  }
  if (!has_identifiers_) return {};
  if (const std::size_t at = 2 * std::size_t(code); at + 1 < glyphs_of_identifiers_.size()) {
    const auto byte = [&](std::size_t n) {
      return unsigned(static_cast<unsigned char>(glyphs_of_identifiers_[n]));
    };
    return byte(at) << 8 | byte(at + 1);
  }
  return file.glyph_of_identifier(code);
}

unsigned PageFont::glyph_by_encoding(FontFile& file, unsigned code) const {
  if (is_symbolic_ && names_.empty())
    if (const unsigned glyph = file.glyph_of_code(code)) return glyph;
  if (const auto name = names_.find(code); name != names_.end()) {
    if (const unsigned glyph = file.glyph_named(name->second)) return glyph;
    if (const auto character = character_named(name->second))
      if (const unsigned glyph = file.glyph_of_character(*character)) return glyph;
  }
  if (encoding_ == Encoding::own)
    if (const unsigned glyph = file.glyph_of_code(code)) return glyph;
  const std::string byte(1, char(code));
  const auto character =
      character_of(encoding_ == Encoding::mac_roman ? QUtil::mac_roman_to_utf8(byte)
                                                    : QUtil::win_ansi_to_utf8(byte));
  if (character)
    if (const unsigned glyph = file.glyph_of_character(*character)) return glyph;
  return file.glyph_of_code(code);
}

PagePath PageFont::box(const Glyph& glyph) const {
  using Kind = PagePath::Step::Kind;
  PagePath path;
  const std::array<glm::dvec2, 4> corners{
      {{0, descent_}, {glyph.advance, descent_}, {glyph.advance, ascent_}, {0, ascent_}}};
  for (std::size_t k = 0; k < 4; ++k)
    path.steps.push_back({k == 0 ? Kind::move : Kind::line, {corners[k], corners[k], corners[k]}});
  path.steps.push_back({Kind::close, {corners[0], corners[0], corners[0]}});
  return path;
}

QPDFObjectHandle PageFont::content(unsigned code) const {
  const auto name = names_.find(code);
  if (name == names_.end()) return QPDFObjectHandle::newNull();
  return value_of(value_of(font_, "/CharProcs"), "/" + name->second);
}

QPDFObjectHandle PageFont::resources() const { return value_of(font_, "/Resources"); }

}  // namespace gradmesh
