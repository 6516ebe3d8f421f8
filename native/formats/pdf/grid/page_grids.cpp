#include "formats/pdf/grid/page_grids.h"

#include <algorithm>
#include <deque>

namespace gradmesh {
namespace {

constexpr std::size_t above = 0, right = 1, below = 2, left = 3;

class Rectangles {
 public:
  explicit Rectangles(const PatchSides& sides)
      : sides_(sides), is_used_(sides.patches().size(), false) {}

  std::vector<PageGrid> all() {
    std::vector<PageGrid> grids;
    for (std::size_t n = 0; n < is_used_.size(); ++n)
      if (!is_used_[n]) grids.push_back(grown_from(int(n)));
    return grids;
  }

 private:
  using Row = std::deque<LaidPatch>;

  PageGrid grown_from(int patch) {
    const bool is_counterclockwise =
        area_of(sides_.patches()[std::size_t(patch)], LaidPatch{patch}) < 0;
    std::deque<Row> rows{
        row_of(is_counterclockwise ? LaidPatch{patch, 1, true} : LaidPatch{patch})};
    while (const auto row = row_beyond(rows.back(), below)) rows.push_back(*row);
    while (const auto row = row_beyond(rows.front(), above)) rows.push_front(*row);
    PageGrid grid{int(rows.size()), int(rows.front().size()), {}};
    for (const Row& row : rows) grid.patches.insert(grid.patches.end(), row.begin(), row.end());
    return grid;
  }

  Row row_of(const LaidPatch& first) {
    Row row{first};
    use(first);
    while (const auto next = unused_beyond(row.back(), right)) {
      row.push_back(*next);
      use(*next);
    }
    while (const auto next = unused_beyond(row.front(), left)) {
      row.push_front(*next);
      use(*next);
    }
    return row;
  }

  /// Returns the row beyond one, if it has as many patches, none of which is used.
  std::optional<Row> row_beyond(const Row& row, std::size_t side) {
    Row next;
    for (const LaidPatch& patch : row) {
      const auto there = unused_beyond(patch, side);
      if (!there || (!next.empty() && sides_.beyond(next.back(), right) != there)) return {};
      next.push_back(*there);
    }
    for (const LaidPatch& patch : next) use(patch);
    return next;
  }

  std::optional<LaidPatch> unused_beyond(const LaidPatch& patch, std::size_t side) const {
    const auto there = sides_.beyond(patch, side);
    if (!there || is_used_[std::size_t(there->patch)]) return {};
    return there;
  }

  void use(const LaidPatch& patch) { is_used_[std::size_t(patch.patch)] = true; }

  const PatchSides& sides_;
  std::vector<bool> is_used_;
};

}  // namespace

std::vector<PageGrid> page_grids(const PatchSides& sides) { return Rectangles(sides).all(); }

}  // namespace gradmesh
