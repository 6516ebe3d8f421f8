#include "formats/pdf/page/pattern_cell.h"

#include <cmath>
#include <glm/matrix.hpp>

#include "formats/pdf/objects/dictionary.h"
#include "geom/box.h"

namespace gradmesh {

PatternCell cell_within(QPDFObjectHandle pattern, const Affine& to_page, const PagePath& path) {
  PatternCell cell;
  const std::vector<double> n = numbers_of(value_of(pattern, "/BBox"));
  const double determinant = glm::determinant(to_page.linear);
  if (n.size() != 4 || !(std::abs(determinant) > 0)) return cell;
  Box own, painted;
  own.add({n[0], n[1]});
  own.add({n[2], n[3]});
  const Affine to_pattern = to_page.inverse();
  for (const PagePath::Step& step : path.steps)
    for (const glm::dvec2 point : step.points) painted.add(to_pattern.point(point));
  if (painted.empty()) return cell;
  const glm::dvec2 off = 0.5 * (painted.low() + painted.high()) - 0.5 * (own.low() + own.high());
  for (int axis = 0; axis < 2; ++axis) {
    const char* const key = axis == 0 ? "/XStep" : "/YStep";
    const double step = std::abs(number_of(value_of(pattern, key)).value_or(0));
    const double count = step > 0 ? std::round(off[axis] / step) : 0;
    if (!std::isfinite(count)) continue;
    cell.place[axis] = step * count;
    // The next one on either side begins a step farther.
    const double low = own.low()[axis] + cell.place[axis],
                 high = own.high()[axis] + cell.place[axis];
    if (step > 0 && (low + step < painted.high()[axis] || high - step > painted.low()[axis]))
      cell.is_only = false;
  }
  return cell;
}

}  // namespace gradmesh
