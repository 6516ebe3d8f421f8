#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/affine.h"
#include "formats/pdf/objects/page_path.h"
#include "formats/pdf/objects/qpdf.h"
#include "formats/pdf/text/font_file.h"

namespace gradmesh {

/// A font of a page (ISO 32000-1, 9.5 to 9.7).
class PageFont {
 public:
  explicit PageFont(QPDFObjectHandle font);

  /// A glyph that a text shows.
  struct Glyph {
    unsigned code = 0;
    /// Whether word spacing follows it: it is a space, of one byte.
    bool is_space = false;
    /// How far the next glyph is, in ems.
    double advance = 0;
  };

  /// Returns the glyphs of a text in the font's encoding.
  std::vector<Glyph> glyphs_of(const std::string& text) const;
  /// Whether lines run down.
  bool is_vertical() const { return is_vertical_; }
  /// Returns the outline of a glyph in ems, with y up; null where the document does not hold it.
  std::shared_ptr<const PagePath> outline(unsigned code);
  /// Returns the box that stands for a glyph of which there is no outline.
  PagePath box(const Glyph& glyph) const;

  /// Whether glyphs are contents of their own.
  bool is_of_contents() const { return is_of_contents_; }
  /// Returns the content of a glyph; null, of PDF, where it has none.
  QPDFObjectHandle content(unsigned code) const;
  /// From the coordinates of such contents to ems.
  const Affine& matrix() const { return matrix_; }
  /// Returns the resources of such contents; null, of PDF, where they are those around the text.
  QPDFObjectHandle resources() const;

 private:
  void read_simple();
  void read_composite();
  void read_encoding();
  void read_identifier_widths(QPDFObjectHandle widths);
  std::optional<unsigned> glyph_number(FontFile& file, unsigned code) const;
  unsigned glyph_by_encoding(FontFile& file, unsigned code) const;
  double advance_of(unsigned code) const;

  QPDFObjectHandle font_, descendant_;
  bool is_composite_ = false, is_vertical_ = false, is_of_contents_ = false, is_symbolic_ = false;
  /// Whether the codes of a composite font are its character identifiers.
  bool has_identifiers_ = true;
  Affine matrix_;
  /// Opened when an outline is asked for: most text needs none.
  QPDFObjectHandle descriptor_;
  std::optional<std::shared_ptr<FontFile>> file_;
  /// By code: names that differ from the encoding, which is one of qpdf's or the font's own.
  std::map<unsigned, std::string> names_;
  enum class Encoding { own, win_ansi, mac_roman };
  Encoding encoding_ = Encoding::own;
  /// In ems.
  std::map<unsigned, double> advances_;
  std::optional<double> usual_advance_;
  double ascent_ = 0.9, descent_ = -0.2;
  /// Glyphs of identifiers, two bytes each, where the font says so.
  std::string glyphs_of_identifiers_;
  std::map<unsigned, std::shared_ptr<const PagePath>> outlines_;
};

}  // namespace gradmesh
