#pragma once

#include <vector>

#include "base/affine.h"
#include "formats/pdf/objects/page_path.h"
#include "formats/pdf/objects/qpdf.h"

namespace gradmesh {

enum class LineCap { butt, round, square };
enum class LineJoin { miter, round, bevel };

/// How a path is stroked (ISO 32000-1, 8.4.3).
struct LineStyle {
  /// 0 stands for the thinnest line that a device can show.
  double width = 1;
  LineCap cap = LineCap::butt;
  LineJoin join = LineJoin::miter;
  double miter_limit = 10;
  /// Lengths of dashes and of the gaps between them, by turns; empty for a line without gaps.
  std::vector<double> dashes;
  /// Where in the dashes the line begins.
  double dash_phase = 0;
};

/// Each of these sets one of them, or leaves it as it is where the object is no such value.
void set_line_width(LineStyle& line, QPDFObjectHandle width);
void set_line_cap(LineStyle& line, QPDFObjectHandle cap);
void set_line_join(LineStyle& line, QPDFObjectHandle join);
void set_miter_limit(LineStyle& line, QPDFObjectHandle limit);
void set_dashes(LineStyle& line, QPDFObjectHandle dashes, QPDFObjectHandle phase);

/// Sets what a dictionary of graphics state parameters holds of it (ISO 32000-1, table 58).
void set_line_style(LineStyle& line, QPDFObjectHandle state);

/// A path that is stroked, and how: its points and lengths are in page coordinates.
struct PageStroke {
  PagePath path;
  LineStyle line;
  /// From the coordinates in which the line is as wide in all directions to those of the page. It
  /// leaves areas as they are.
  Affine pen = {};
};

/// Returns the stroke of a path, which is in page coordinates, by a line which is in those of the
/// content.
PageStroke page_stroke(PagePath path, LineStyle line, const Affine& to_page);

}  // namespace gradmesh
