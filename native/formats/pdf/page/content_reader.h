#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "formats/pdf/page/graphics_state.h"
#include "formats/pdf/page/layers.h"
#include "formats/pdf/page/mask_marks.h"

namespace gradmesh {

/// Finds the shadings of types 4 to 7 that content streams paint, in painting order: by `sh`, or as
/// patterns of fills and strokes, in forms and cells of patterns at any depth.
class ContentReader {
 public:
  explicit ContentReader(Layers layers) : layers_(std::move(layers)) {}

  /// Reads content streams of a page, which are one after the other, or of a form; `state` is that
  /// at their beginning. Throws InputError where there is no end of forms.
  void read(const std::vector<QPDFObjectHandle>& contents, const QPDFObjectHandle& resources,
            const GraphicsState& state);
  /// Reads what a form paints, or the appearance of an annotation. `resources` are those around it.
  void read_form(QPDFObjectHandle form, const QPDFObjectHandle& resources, GraphicsState state);

  const Layers& layers() const { return layers_; }
  std::vector<PaintedShading> take_painted() { return std::move(painted_); }
  /// Returns how many further ones are in layers that are off.
  int hidden() const { return hidden_; }
  /// Whether a content stream is damaged: what lies before that was read.
  bool is_damaged() const { return is_damaged_; }

 private:
  friend class ContentOperators;

  /// Makes what follows be seen through a soft mask.
  void set_mask(QPDFObjectHandle mask, const QPDFObjectHandle& resources, GraphicsState& state);
  /// Reads a content stream that is not the page's own: a form, a cell, a glyph. Leaves it out
  /// where it is read already, around this one.
  void read_within(QPDFObjectHandle stream, const QPDFObjectHandle& resources,
                   const GraphicsState& state);

  /// Reads a glyph that is content of its own.
  void read_glyph(QPDFObjectHandle glyph, const QPDFObjectHandle& resources,
                  const GraphicsState& state);
  std::shared_ptr<PageFont> font(QPDFObjectHandle font);

  const Layers layers_;
  std::vector<PaintedShading> painted_;
  int hidden_ = 0;
  /// What the form of a soft mask paints beside shadings, while one is read.
  std::optional<MaskMarks> marks_;
  bool is_damaged_ = false;
  /// The forms that are being read, one inside the other; how many were read in all, and how long
  /// these and the page's own content were: a form of a stranger's file may be shown again and
  /// again.
  std::set<QPDFObjGen> around_;
  int forms_ = 0;
  std::map<QPDFObjGen, std::shared_ptr<PageFont>> fonts_;
  /// Glyphs that paint no meshes: they are read once, texts are long.
  std::set<QPDFObjGen> plain_glyphs_;
  std::uint64_t bytes_ = 0;
};

}  // namespace gradmesh
