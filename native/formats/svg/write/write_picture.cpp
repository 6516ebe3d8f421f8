#include "formats/svg/write/write_picture.h"

#include "files/base64.h"
#include "formats/svg/read/read_group.h"
#include "formats/svg/write/remove_blocks.h"
#include "formats/svg/write/replace_shape.h"
#include "formats/svg/xml/edit.h"
#include "formats/svg/xml/node.h"
#include "formats/text/number.h"

namespace gradmesh {
namespace {

std::string matrix(const Affine& map) {
  const auto& [linear, offset] = map;
  std::string text = "matrix(";
  for (const double x : {linear[0].x, linear[0].y, linear[1].x, linear[1].y, offset.x, offset.y})
    text.append(text.back() == '(' ? "" : " ").append(format_number(x));
  return text + ")";
}

/// Adds a clip path of the mesh's outline. Returns its id.
std::string add_outline(SvgDocument& document, const std::string& id,
                        const PlacedPicture& picture) {
  xmlNode* clip = add_child(document.defs(), "clipPath");
  set_attribute(clip, "clipPathUnits", "userSpaceOnUse");
  xmlNode* path = add_child(clip, "path");
  set_attribute(path, "d", picture.outline);
  if (picture.outline_to_user != Affine())
    set_attribute(path, "transform", matrix(picture.outline_to_user));
  return document.give_id(clip, id + "-outline");
}

xmlNode* add_image(SvgDocument& document, xmlNode* group, const std::string& id,
                   const PlacedPicture& picture) {
  xmlNode* image = add_child(group, "image");
  document.give_id(image, id + "-picture");
  const int digits = digits_within(picture.place);
  set_attribute(image, "x", format_number(picture.place.low().x, digits));
  set_attribute(image, "y", format_number(picture.place.low().y, digits));
  set_attribute(image, "width", format_number(picture.place.size().x, digits));
  set_attribute(image, "height", format_number(picture.place.size().y, digits));
  set_attribute(image, "preserveAspectRatio", "none");
  if (!picture.outline.empty())
    set_attribute(image, "clip-path", "url(#" + add_outline(document, id, picture) + ")");
  // Not only SVG 2's href, which many programs do not know.
  set_attribute(image, "href", "data:image/png;base64," + base64(picture.png), xlink_namespace,
                "xlink");
  return image;
}

/// Takes the label of a mesh away, which tells of blocks, from the group and those around it. One
/// that a person has given stays.
void remove_label(xmlNode* group) {
  const auto label = attribute(group, "label", gradmesh_namespace);
  const xmlNode* end = parent_element(whole_object(group));
  for (xmlNode* node = group; node != end; node = parent_element(node))
    if (attribute(node, "label", inkscape_namespace) == label)
      remove_attribute(node, "label", inkscape_namespace);
}

}  // namespace

void write_picture(SvgDocument& document, const MeshObject& object, const PlacedPicture& picture) {
  const std::string id = object_id(object.node);
  if (object.gradient) {
    replace_shape(document, object, false, [&](xmlNode* group) {
      add_image(document, group, id, picture);
      return picture.place;
    });
    return;
  }
  remove_blocks(document, object.node);
  xmlNode* image = add_image(document, object.node, id, picture);
  if (object.node->children != image) xmlAddPrevSibling(object.node->children, image);
  remove_label(object.node);
}

}  // namespace gradmesh
