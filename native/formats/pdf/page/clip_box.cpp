#include "formats/pdf/page/clip_box.h"

#include <array>

#include "formats/pdf/objects/dictionary.h"

namespace gradmesh {

void clip_to_box(Clips& clips, QPDFObjectHandle object, const Affine& to_page) {
  using Kind = PagePath::Step::Kind;
  const std::vector<double> box = numbers_of(value_of(object, "/BBox"));
  if (box.size() != 4) return;
  PagePath path;
  const std::array<glm::dvec2, 4> corners{
      {{box[0], box[1]}, {box[2], box[1]}, {box[2], box[3]}, {box[0], box[3]}}};
  for (std::size_t k = 0; k < 4; ++k) {
    const glm::dvec2 at = to_page.point(corners[k]);
    path.steps.push_back({k == 0 ? Kind::move : Kind::line, {at, at, at}});
  }
  const glm::dvec2 begin = path.steps.front().points[2];
  path.steps.push_back({Kind::close, {begin, begin, begin}});
  clips.push_back(std::make_shared<const PagePath>(std::move(path)));
}

}  // namespace gradmesh
