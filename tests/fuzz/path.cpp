#include <algorithm>
#include <cmath>
#include <limits>

#include "formats/svg/values/path.h"
#include "target.h"

namespace gradmesh::fuzz {

void check(std::string_view data) {
  const auto box = path_box(data);
  const auto outline = path_outline(data);
  require(box.has_value() == outline.has_value(), "both can read it, or neither");
  if (!box || box->empty()) return;
  const glm::dvec2 low = box->low(), high = box->high();
  const double largest =
      std::max({std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y)});
  require(std::isfinite(largest), "the box is finite");
  // Numbers below the smallest normal one have few digits or none.
  const double rounding = std::max(1e-6 * largest, std::numeric_limits<double>::min());
  for (const auto& polygon : *outline)
    for (const glm::dvec2 p : polygon)
      require(p.x >= low.x - rounding && p.x <= high.x + rounding && p.y >= low.y - rounding &&
                  p.y <= high.y + rounding,
              "the outline lies in the box");
}

}  // namespace gradmesh::fuzz
