#include "formats/pdf/records/record_of_page.h"

#include <algorithm>
#include <cmath>

#include "geom/box.h"

namespace gradmesh {
namespace {

/// Records have as many digits as the page: 1/2048 of a point, and three decimals.
constexpr double same_point = 0.02;
/// How far patches may reach beyond curves that were fitted to sides with anchors, as a share of
/// the longer side.
constexpr double beyond = 0.02;

Box box_of(const std::vector<PagePatch>& patches) {
  Box box;
  for (const PagePatch& patch : patches)
    for (const glm::dvec2 point : patch.outer) box.add(point);
  return box;
}

/// The corners of a page's patches.
class PageCorners {
 public:
  explicit PageCorners(const std::vector<PagePatch>& page) {
    for (const PagePatch& patch : page)
      for (std::size_t k = 0; k < 4; ++k) corners_.push_back(patch.outer[3 * k]);
    std::ranges::sort(corners_, {}, [](glm::dvec2 p) { return std::pair(p.x, p.y); });
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
  }

  const std::vector<glm::dvec2>& all() const { return corners_; }

  bool contains(glm::dvec2 point) const {
    auto corner = std::ranges::lower_bound(corners_, point.x - same_point, {}, &glm::dvec2::x);
    for (; corner != corners_.end() && corner->x <= point.x + same_point; ++corner)
      if (std::abs(corner->y - point.y) <= same_point) return true;
    return false;
  }

  /// Returns true if all corners of a record are there once it was moved.
  bool contain(const ArtistsGrid& record, glm::dvec2 by) const {
    return std::ranges::all_of(record.patches, [&](const PagePatch& patch) {
      for (std::size_t k = 0; k < 4; ++k)
        if (!contains(patch.outer[3 * k] + by)) return false;
      return true;
    });
  }

 private:
  std::vector<glm::dvec2> corners_;
};

void move(ArtistsGrid& record, glm::dvec2 by) {
  for (PagePatch& patch : record.patches) {
    for (glm::dvec2& point : patch.outer) point += by;
    for (glm::dvec2& point : patch.inner) point += by;
  }
}

/// Returns true if the parts reach hardly anywhere beyond the whole, nor leave much of it out.
bool is_covered(const Box& whole, const Box& parts) {
  const double reach = beyond * std::max(whole.size().x, whole.size().y);
  const glm::dvec2 low = parts.low() - whole.low(), high = parts.high() - whole.high();
  return std::max({std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y)}) <= reach;
}

}  // namespace

std::optional<ArtistsGrid> record_of_page(ArtistsGrid record, const std::vector<PagePatch>& page,
                                          const PageColors& colors) {
  const PageCorners corners(page);
  const glm::dvec2 first = record.patches.front().outer[0];
  std::vector<glm::dvec2> places{first};
  places.insert(places.end(), corners.all().begin(), corners.all().end());
  for (const glm::dvec2 place : places) {
    if (!corners.contain(record, place - first)) continue;
    move(record, place - first);
    if (!is_covered(box_of(record.patches), box_of(page))) return {};
    for (PagePatch& patch : record.patches)
      for (std::size_t k = 0; k < 4; ++k) patch.colors[k] = colors.at(patch.outer[3 * k]);
    return record;
  }
  return {};
}

}  // namespace gradmesh
