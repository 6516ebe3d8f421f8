#include "formats/svg/picture/document_image.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/utf8_path.h"
#include "files/base64.h"
#include "formats/svg/group/written_label.h"
#include "formats/svg/picture/image_cover.h"
#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/visible.h"
#include "formats/svg/values/reference.h"
#include "formats/svg/xml/node.h"
#include "formats/text/excerpt.h"
#include "geom/outline.h"

namespace gradmesh {
namespace {

/// Returns the box around the room of an <image>, in units of the outermost <svg>. One whose size
/// is not said has that of its file, and may reach anywhere.
std::optional<Box> image_box(const xmlNode* image) {
  if (!attribute(image, "width") || !attribute(image, "height")) return {};
  const ImageRoom room = image_room(image);
  return bounding_box(mapped(rectangle(room.corner, room.corner + room.size), to_document(image)));
}

/// Returns false if no picture of an <image> can lie in the box, in units of the outermost <svg>.
bool reaches(const xmlNode* image, const Box& around) {
  const std::optional<Box> box = image_box(image);
  return !box || !overlap(*box, around).empty();
}

Box box_around(const SvgTree& tree, const std::string& shape) {
  return bounding_box(covered_area(tree, shape).front().outline);
}

/// Returns the bytes of a `data:` reference in base64, in which lines may be broken; nothing if it
/// is something else.
std::optional<std::string> data_bytes(std::string_view reference) {
  const std::size_t comma = reference.find(',');
  if (comma == reference.npos || !reference.substr(0, comma).ends_with(";base64")) return {};
  std::string text = percent_decoded(reference.substr(comma + 1));
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; });
  return base64_bytes(text);
}

}  // namespace

bool is_image(const SvgTree& tree, const std::string& id) {
  const xmlNode* const node = tree.find(id);
  return node && svg_name(node) == "image";
}

const xmlNode* image_under(const SvgTree& tree, const std::string& shape,
                           const std::string& image) {
  if (!image.empty()) {
    if (is_image(tree, image)) return tree.find(image);
    throw InputError("{0}: there is no picture with the id {1}.", tree.name(), excerpt(image));
  }
  if (is_image(tree, shape)) return tree.find(shape);
  const std::vector<xmlNode*> all = elements_from(tree.root());
  const auto is_one = [](const xmlNode* node) { return svg_name(node) == "image"; };
  const auto count = std::ranges::count_if(all, is_one);
  if (count == 0) return nullptr;
  if (count == 1) return *std::ranges::find_if(all, is_one);
  const Box around = box_around(tree, shape);
  const xmlNode* under = nullptr;
  bool is_below = true;
  for (const xmlNode* node : all) {
    if (node == tree.find(shape)) is_below = false;
    if (!is_one(node)) continue;
    if ((is_below || !under) && reaches(node, around)) under = node;
  }
  if (!under)
    throw InputError("{0}: {1} lies on none of its {2} pictures.", tree.name(),
                     called(tree.find(shape)), count);
  return under;
}

std::string named_image(SvgTree& tree, const std::string& shape, const std::string& image) {
  const xmlNode* const node = image_under(tree, shape, image);
  if (!node)
    throw InputError("{0}: it shows no picture, so that one has to be named.", tree.name());
  const auto id = attribute(node, "id");
  return id ? *id : tree.give_id(const_cast<xmlNode*>(node), "picture");
}

ImageFile image_file(const SvgTree& tree, const std::string& shape, const std::string& id) {
  const xmlNode* const image = image_under(tree, shape, id);
  if (!image)
    throw InputError("{0}: it shows no picture, so that one has to be named.", tree.name());
  // Before the file is looked for: where that is missing, to find it would not help such a shape.
  if (!is_image(tree, shape) && !reaches(image, box_around(tree, shape)))
    throw InputError("{0}: {1} does not lie on the picture.", tree.name(),
                     called(tree.find(shape)));
  std::string reference = href(image);
  if (reference.empty()) reference = attribute(image, "href").value_or("");
  if (reference.starts_with("data:")) {
    if (auto bytes = data_bytes(reference)) return *std::move(bytes);
    throw InputError("{0}: what it holds of its picture cannot be read.", tree.name());
  }
  constexpr std::string_view of_files = "file://";
  std::string_view place = reference;
  if (place.starts_with(of_files)) place.remove_prefix(of_files.size());
  // The address of a file on a drive of Windows: file:///C:/a.png.
  if (place.size() > 2 && place[0] == '/' && place[2] == ':') place.remove_prefix(1);
  if (place.empty() || place.find("://") != place.npos)
    throw InputError("{0}: its picture {1} is no file of this machine.", tree.name(),
                     excerpt(reference));
  return utf8_path(percent_decoded(place));
}

}  // namespace gradmesh
