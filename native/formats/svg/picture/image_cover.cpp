#include "formats/svg/picture/image_cover.h"

#include <optional>

#include "base/error.h"
#include "formats/svg/group/written_label.h"
#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/paint.h"
#include "formats/svg/tree/visible.h"
#include "formats/svg/xml/node.h"
#include "formats/text/number.h"

namespace gradmesh {
namespace {

/// Returns the box around the area that all of the sets share.
Box box_of(const VisibleArea& area, Box box) {
  for (const std::vector<FilledOutline>& set : area.sets) {
    Box around;
    for (const FilledOutline& filled : set) {
      const Box one = bounding_box(filled.outline);
      if (one.empty()) continue;
      around.add(one.low());
      around.add(one.high());
    }
    box = overlap(box, around);
  }
  return box;
}

}  // namespace

PictureInImage picture_in_image(const SvgTree& tree, const xmlNode* image, glm::dvec2 pixels) {
  auto [corner, size] = image_room(image);
  // What is not said follows from the picture.
  if (!attribute(image, "width"))
    size.x = attribute(image, "height") ? size.y * pixels.x / pixels.y : pixels.x;
  if (!attribute(image, "height")) size.y = size.x * pixels.y / pixels.x;
  if (!(size.x > 0 && size.y > 0) || to_document(image).determinant() == 0)
    throw InputError("{0}: {1} has no size.", tree.name(), called(image));
  PictureInImage shown;
  shown.place = Affine::translation(corner) *
                fitted(pixels, size, attribute(image, "preserveAspectRatio").value_or(""));
  shown.room.add(corner);
  shown.room.add(corner + size);
  return shown;
}

Box seen_of_image(const SvgTree& tree, const xmlNode* image, glm::dvec2 pixels) {
  const PictureInImage shown = picture_in_image(tree, image, pixels);
  Box box = bounding_box(mapped(rectangle(glm::dvec2(0.0), pixels), shown.place));
  box = overlap(box, shown.room);
  MeshObject object;
  object.node = const_cast<xmlNode*>(image);
  if (const std::optional<VisibleArea> area = visible_area(tree, object)) box = box_of(*area, box);
  if (box.empty()) throw InputError("{0}: nothing is seen of {1}.", tree.name(), called(image));
  return box;
}

std::string cover_image(SvgTree& tree, const std::string& id, glm::dvec2 pixels) {
  xmlNode* const image = tree.find(id);
  const Box box = seen_of_image(tree, image, pixels);
  xmlNode* const cover = add_child(parent_element(image), "rect");
  xmlAddNextSibling(image, cover);
  set_attribute(cover, "x", format_number(box.low().x));
  set_attribute(cover, "y", format_number(box.low().y));
  set_attribute(cover, "width", format_number(box.size().x));
  set_attribute(cover, "height", format_number(box.size().y));
  if (const auto transform = attribute(image, "transform"))
    set_attribute(cover, "transform", *transform);
  for (const char* property : {"clip-path", "mask", "opacity"})
    if (const auto value = tree.styles().declared(image, property))
      set_style(tree.styles(), cover, property, *value);
  return tree.give_id(cover, id + "-mesh");
}

}  // namespace gradmesh
