#include "formats/svg/values/curves.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "formats/text/number.h"

namespace gradmesh {
namespace {

class CurveReader {
 public:
  explicit CurveReader(std::string_view text) : rest_(text) {}

  std::optional<std::vector<CurveParts>> read() {
    std::vector<CurveParts> curves;
    skip_blanks();
    while (!rest_.empty()) {
      CurveParts curve;
      if (!read_side(curve.a) || !accept('|') || !read_side(curve.b)) return std::nullopt;
      curves.push_back(std::move(curve));
      if (!rest_.empty() && !accept(';')) return std::nullopt;
    }
    return curves;
  }

 private:
  bool read_side(CurveSide& side) {
    if (!read_halfedge(side)) return false;
    while (!rest_.empty() && rest_.front() != '|' && rest_.front() != ';') {
      double at = 0;
      if (!read_number(at) || !read_halfedge(side)) return false;
      side.breaks.push_back(at);
    }
    return true;
  }

  bool read_halfedge(CurveSide& side) {
    int h = 0;
    if (!read_number(h)) return false;
    side.halfedges.push_back(h);
    return true;
  }

  template <class Number>
  bool read_number(Number& value) {
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc{}) return false;
    rest_.remove_prefix(std::size_t(end - rest_.data()));
    skip_blanks();
    return true;
  }

  bool accept(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    skip_blanks();
    return true;
  }
  void skip_blanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
  }

  std::string_view rest_;
};

}  // namespace

std::optional<std::vector<CurveParts>> parse_curves(std::string_view text) {
  return CurveReader(text).read();
}

std::string format_curves(const Mesh& mesh, const std::vector<Rectangle>& blocks) {
  // Sides inside a block: a reader joins those by itself.
  std::vector<bool> inside;
  for (const Rectangle& block : blocks)
    for (int i = 0; i < block.rows; ++i)
      for (int j = 0; j < block.columns; ++j)
        for (const bool side : {i > 0, j + 1 < block.columns, i + 1 < block.rows, j > 0})
          inside.push_back(side);
  const auto format_side = [](const CurveSide& side) {
    std::string text = std::to_string(side.halfedges[0]);
    for (std::size_t i = 0; i < side.breaks.size(); ++i)
      text.append(" ")
          .append(format_exactly(side.breaks[i]))
          .append(" ")
          .append(std::to_string(side.halfedges[i + 1]));
    return text;
  };
  std::string text;
  for (const CurveParts& curve : block_parts(mesh, {blocks}).curves) {
    const bool whole = curve.a.breaks.empty() && curve.b.breaks.empty();
    if (whole && inside[std::size_t(curve.a.halfedges[0])]) continue;
    text += (text.empty() ? "" : "; ") + format_side(curve.a) + " | " + format_side(curve.b);
  }
  return text;
}

}  // namespace gradmesh
