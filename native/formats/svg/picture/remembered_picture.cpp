#include "formats/svg/picture/remembered_picture.h"

#include <cstdio>

#include "formats/svg/picture/document_image.h"
#include "formats/svg/tree/own.h"
#include "formats/text/number.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

constexpr const char* attribute_name = "picture";
constexpr std::size_t hash_digits = 16;

}  // namespace

std::optional<RememberedPicture> remembered_picture(const SvgTree& tree, const MeshObject& object) {
  const auto text = own_attribute(object.node, attribute_name);
  if (!text || text->size() < hash_digits) return {};
  RememberedPicture picture;
  const char* const hash_end = text->data() + hash_digits;
  const auto read = std::from_chars(text->data(), hash_end, picture.hash, 16);
  if (read.ec != std::errc{} || read.ptr != hash_end) return {};
  double numbers[6];
  const char* at = hash_end;
  const char* const end = text->data() + text->size();
  for (double& number : numbers) {
    if (at == end || *at++ != ' ') return {};
    const auto found = std::from_chars(at, end, number);
    if (found.ec != std::errc{} || !std::isfinite(number)) return {};
    at = found.ptr;
  }
  if (at == end || *at++ != ' ') return {};
  picture.image.assign(at, end);
  picture.to_mesh.linear = {numbers[0], numbers[1], numbers[2], numbers[3]};
  picture.to_mesh.offset = {numbers[4], numbers[5]};
  if (!is_image(tree, picture.image)) return {};
  return picture;
}

void remember_picture(const MeshObject& object, const RememberedPicture& picture) {
  char text[hash_digits + 1];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(picture.hash));
  const Affine& map = picture.to_mesh;
  std::string value = text;
  for (const glm::dvec2 part : {map.linear[0], map.linear[1], map.offset})
    value += " " + format_number(part.x) + " " + format_number(part.y);
  set_own_attribute(object.node, attribute_name, value + " " + picture.image);
}

}  // namespace gradmesh
