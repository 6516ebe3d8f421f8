#include "formats/pdf/grid/page_mesh.h"

#include <algorithm>
#include <optional>

#include "formats/pdf/grid/loose_sides.h"
#include "formats/pdf/grid/sound_slits.h"

namespace gradmesh {
namespace {

/// Two chains of sides that are loose, one on either side of a slit (loose_sides.h): the curve that
/// both are if they are one, and where they divide it.
class SlitCurve {
 public:
  SlitCurve(const LooseSides& sides, const Slit& slit, double tolerance)
      : tolerance_(tolerance),
        here_(rows_of(sides, slit.here)),
        there_(rows_of(sides, slit.there)) {
    // Of a side that is not divided, all is known.
    if (here_.size() == 1)
      whole_ = here_.front();
    else if (there_.size() == 1)
      whole_ = reversed_row(there_.front());
    else
      whole_ = closest_to_both();
  }

  std::optional<CurveParts> parts(const Slit& slit) const {
    const auto here = breaks(here_, whole_), there = breaks(there_, reversed_row(whole_));
    if (!here || !there) return {};
    const CurveSide a{slit.here, *here}, b{slit.there, *there};
    return slit.here.size() > 1 && slit.there.size() == 1 ? CurveParts{b, a} : CurveParts{a, b};
  }

 private:
  static std::vector<ControlRow> rows_of(const LooseSides& sides, const std::vector<int>& chain) {
    std::vector<ControlRow> rows;
    for (const int side : chain) rows.push_back(sides.curve(side));
    return rows;
  }

  ControlRow closest_to_both() const {
    std::vector<CurvePart> parts = parts_by_speed(here_);
    for (const CurvePart& part : parts_by_speed(there_))
      parts.push_back({reversed_row(part.row), 1 - part.to, 1 - part.from});
    return closest_whole(parts);
  }

  /// Returns the breaks of a curve, if these are its parts.
  std::optional<std::vector<double>> breaks(const std::vector<ControlRow>& rows,
                                            const ControlRow& whole) const {
    // Parts that are shorter are none, nor are their corners known well enough.
    constexpr double least = 1e-6;
    std::vector<double> breaks;
    double from = 0;
    for (std::size_t n = 0; n < rows.size(); ++n) {
      const double to = n + 1 < rows.size() ? nearest_on(whole, rows[n][3]) : 1;
      const CurvePart part{rows[n], from, to};
      if (!(to - from > least) || deviation(whole, {&part, 1}) > 2 * tolerance_) return {};
      if (n + 1 < rows.size()) breaks.push_back(to);
      from = to;
    }
    return breaks;
  }

  const double tolerance_;
  const std::vector<ControlRow> here_, there_;
  ControlRow whole_{};
};

}  // namespace

MeshParts page_mesh(const std::vector<PagePatch>& patches, double tolerance) {
  const LooseSides sides(patches, tolerance);
  MeshParts parts;
  for (const PagePatch& patch : sides.patches()) parts.patches.push_back(mesh_patch(patch));
  for (int side = 0; side < sides.count(); ++side)
    if (side < sides.twin(side)) parts.curves.push_back({{{side}, {}}, {{sides.twin(side)}, {}}});
  // By slit, where it is one curve.
  std::vector<std::optional<CurveParts>> curves;
  std::vector<bool> is_curve;
  for (const Slit& slit : sides.slits()) {
    curves.push_back(SlitCurve(sides, slit, tolerance).parts(slit));
    is_curve.push_back(curves.back().has_value());
  }
  const std::vector<bool> is_sound = sound_slits(sides, is_curve);
  for (std::size_t n = 0; n < curves.size(); ++n)
    if (is_sound[n]) parts.curves.push_back(*curves[n]);
  return parts;
}

}  // namespace gradmesh
