#include "formats/pdf/page/line_style.h"

#include <algorithm>
#include <cmath>

#include "base/clamped_int.h"
#include "formats/pdf/objects/dictionary.h"

namespace gradmesh {
namespace {

/// The styles of caps and joins have the numbers 0 to 2.
template <class Style>
void set_line_shape(Style& style, QPDFObjectHandle number) {
  if (const auto n = number_of(number)) style = static_cast<Style>(clamped_int(*n, 0, 2));
}

}  // namespace

void set_line_width(LineStyle& line, QPDFObjectHandle width) {
  if (const auto n = number_of(width); n && *n >= 0) line.width = *n;
}

void set_line_cap(LineStyle& line, QPDFObjectHandle cap) { set_line_shape(line.cap, cap); }

void set_line_join(LineStyle& line, QPDFObjectHandle join) { set_line_shape(line.join, join); }

void set_miter_limit(LineStyle& line, QPDFObjectHandle limit) {
  if (const auto n = number_of(limit); n && *n >= 1) line.miter_limit = *n;
}

void set_dashes(LineStyle& line, QPDFObjectHandle dashes, QPDFObjectHandle phase) {
  // Each stroke of a stranger's file has them, and may be as short as a dash.
  constexpr int most_dashes = 1000;
  if (!dashes.isArray() || dashes.getArrayNItems() > most_dashes) return;
  std::vector<double> lengths = numbers_of(dashes);
  if (lengths.empty() && dashes.getArrayNItems() > 0) return;
  if (std::ranges::any_of(lengths, [](double length) { return length < 0; })) return;
  // Dashes without any length would have no end.
  if (std::ranges::none_of(lengths, [](double length) { return length > 0; })) lengths.clear();
  line.dashes = std::move(lengths);
  line.dash_phase = number_of(phase).value_or(0);
}

void set_line_style(LineStyle& line, QPDFObjectHandle state) {
  set_line_width(line, value_of(state, "/LW"));
  set_line_cap(line, value_of(state, "/LC"));
  set_line_join(line, value_of(state, "/LJ"));
  set_miter_limit(line, value_of(state, "/ML"));
  QPDFObjectHandle dash = value_of(state, "/D");
  if (dash.isArray() && dash.getArrayNItems() == 2)
    set_dashes(line, dash.getArrayItem(0), dash.getArrayItem(1));
}

}  // namespace gradmesh
