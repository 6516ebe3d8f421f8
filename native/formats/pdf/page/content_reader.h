#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "formats/pdf/page/graphics_state.h"

namespace gradmesh {

/// Finds the shadings of types 4 to 7 that content streams paint, in painting order: by `sh`, or as
/// patterns of fills and strokes, in forms at any depth.
class ContentReader {
 public:
  /// Reads content streams of a page, which are one after the other, or of a form; `state` is that
  /// at their beginning. Throws InputError where there is no end of forms.
  void read(const std::vector<QPDFObjectHandle>& contents, const QPDFObjectHandle& resources,
            const GraphicsState& state);

  const std::vector<PaintedShading>& painted() const { return painted_; }
  /// Whether a content stream is damaged: what lies before that was read.
  bool is_damaged() const { return is_damaged_; }

 private:
  friend class ContentOperators;

  /// Reads what a form paints.
  void read_form(QPDFObjectHandle form, const QPDFObjectHandle& resources, GraphicsState state);
  /// Returns what the form of a soft mask paints; nothing if it is no mask of luminosities.
  std::shared_ptr<const std::vector<PaintedShading>> mask_of(QPDFObjectHandle mask,
                                                             const QPDFObjectHandle& resources,
                                                             const GraphicsState& state);

  std::vector<PaintedShading> painted_;
  bool is_damaged_ = false;
  /// The forms that are being read, one inside the other; how many were read in all, and how long
  /// these and the page's own content were: a form of a stranger's file may be shown again and
  /// again.
  std::set<QPDFObjGen> around_;
  int forms_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace gradmesh
