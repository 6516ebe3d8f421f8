#include "formats/pdf/page/mask_marks.h"

#include <algorithm>

#include "geom/box.h"

namespace gradmesh {
namespace {

Box box_of(const PagePath& path) {
  Box box;
  for (const PagePath::Step& step : path.steps)
    for (const glm::dvec2 point : step.points) box.add(point);
  return box;
}

bool has_same_clips(const MaskArea& a, const MaskArea& b) {
  return std::equal(a.clips.begin(), a.clips.end() - 1, b.clips.begin(), b.clips.end() - 1,
                    [](const auto& x, const auto& y) { return *x == *y; });
}

}  // namespace

std::optional<MaskArea> area_of(const MaskMarks& marks) {
  if (marks.has_others) return {};
  if (marks.areas.empty()) return MaskArea{{std::make_shared<const PagePath>()}, 0};
  MaskArea all = marks.areas.front();
  if (marks.areas.size() == 1) return all;
  // Paths that lie apart are one path for either rule; opacities where they overlap are another
  // thing.
  PagePath together = *all.clips.back();
  std::vector<Box> boxes{box_of(together)};
  for (auto area = marks.areas.begin() + 1; area != marks.areas.end(); ++area) {
    const PagePath& path = *area->clips.back();
    const Box box = box_of(path);
    const bool lies_apart =
        std::ranges::all_of(boxes, [&](const Box& other) { return overlap(box, other).empty(); });
    if (!lies_apart || area->opacity != all.opacity || path.rule != together.rule ||
        !has_same_clips(all, *area))
      return {};
    together.steps.insert(together.steps.end(), path.steps.begin(), path.steps.end());
    boxes.push_back(box);
  }
  all.clips.back() = std::make_shared<const PagePath>(std::move(together));
  return all;
}

}  // namespace gradmesh
