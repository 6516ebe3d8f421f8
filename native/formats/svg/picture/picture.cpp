#include "formats/svg/picture/picture.h"

#include <glm/vec3.hpp>

#include "files/base64.h"
#include "formats/svg/group/shape.h"
#include "formats/svg/group/write_group.h"
#include "formats/svg/tree/own.h"
#include "formats/svg/tree/paint.h"
#include "formats/svg/tree/unused.h"
#include "formats/svg/values/color.h"
#include "formats/svg/values/transform.h"
#include "formats/svg/xml/node.h"
#include "formats/text/number.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

/// Adds a clip path of the mesh's outline. Returns its id.
std::string add_outline(SvgTree& tree, const std::string& id, const PlacedPng& picture) {
  xmlNode* clip = add_child(tree.defs(), "clipPath");
  set_attribute(clip, "clipPathUnits", "userSpaceOnUse");
  xmlNode* path = add_child(clip, "path");
  set_attribute(path, "d", picture.outline);
  if (picture.outline_to_user != Affine())
    set_attribute(path, "transform", transform_text(picture.outline_to_user));
  return tree.give_id(clip, id + "-outline");
}

xmlNode* add_image(SvgTree& tree, xmlNode* group, const std::string& id, const PlacedPng& picture) {
  xmlNode* image = add_child(group, "image");
  tree.give_id(image, id + "-picture");
  set_box(image, picture.place, digits_within(picture.place));
  set_attribute(image, "preserveAspectRatio", "none");
  turn_off_effects(tree.styles(), image);
  if (!picture.outline.empty())
    set_attribute(image, "clip-path", paint_by(add_outline(tree, id, picture)));
  // Not only SVG 2's href, which many programs do not know.
  set_attribute(image, "href", "data:image/png;base64," + base64(picture.png), xlink_namespace,
                "xlink");
  return image;
}

/// Takes the label of a mesh away, which tells of blocks, from the group and those around it. One
/// that a person has given stays.
void remove_label(xmlNode* group) {
  const auto label = own_attribute(group, "label");
  for (xmlNode* node : with_outer(group))
    if (attribute(node, "label", inkscape_namespace) == label)
      remove_attribute(node, "label", inkscape_namespace);
}

/// Adds a linear gradient with these colours. Returns its id.
std::string add_gradient(SvgTree& tree, const std::string& prefix, const LinearColors& colors) {
  xmlNode* gradient = add_child(tree.defs(), "linearGradient");
  const std::string id = tree.give_id(gradient, prefix);
  set_attribute(gradient, "gradientUnits", "userSpaceOnUse");
  Box box;
  box.add(colors.start);
  box.add(colors.end);
  const int digits = digits_within(box);
  set_attribute(gradient, "x1", format_number(colors.start.x, digits));
  set_attribute(gradient, "y1", format_number(colors.start.y, digits));
  set_attribute(gradient, "x2", format_number(colors.end.x, digits));
  set_attribute(gradient, "y2", format_number(colors.end.y, digits));
  const std::string mark(tree.styles().has_important() ? important_mark : "");
  for (const auto& [place, color] : colors.stops) {
    xmlNode* stop = add_child(gradient, "stop");
    set_attribute(stop, "offset", format_number(place));
    set_attribute(stop, "style",
                  "stop-color:" + color_text(color) + mark + ";stop-opacity:1" + mark);
  }
  return id;
}

}  // namespace

void write_picture(SvgTree& tree, const MeshObject& object, const PlacedPng& picture) {
  const std::string id = object_id(object.node);
  if (object.gradient) {
    replace_shape(tree, object, false, [&](xmlNode* group) {
      add_image(tree, group, id, picture);
      return picture.place;
    });
    return;
  }
  remove_blocks(tree, object.node);
  xmlNode* image = add_image(tree, object.node, id, picture);
  if (object.node->children != image) xmlAddPrevSibling(object.node->children, image);
  remove_label(object.node);
}

void write_linear(SvgTree& tree, const MeshObject& object, const LinearColors& colors) {
  const std::string paint = paint_name(object.role);
  const std::string inherited =
      tree.styles().inherited(object.node, paint + "-opacity").value_or("1");
  const double opacity = colors.stops.front().color.a * parse_opacity(inherited).value_or(1);
  set_paint(tree.styles(), object.node, paint,
            colors.stops.size() == 1
                ? color_text(colors.stops.front().color)
                : paint_by(add_gradient(tree, object.id + "-gradient", colors)));
  set_style(tree.styles(), object.node, paint + "-opacity", format_number(opacity, 6));
  remove_if_unused(tree, attribute(object.gradient, "id").value_or(""));
}

}  // namespace gradmesh
