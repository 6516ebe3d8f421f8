#include "formats/svg/picture/document_image.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/utf8_path.h"
#include "files/base64.h"
#include "formats/svg/values/reference.h"
#include "formats/svg/xml/node.h"
#include "formats/text/excerpt.h"

namespace gradmesh {
namespace {

void collect_images(const xmlNode* node, std::vector<const xmlNode*>& images) {
  if (svg_name(node) == "image") images.push_back(node);
  for (const xmlNode* child : child_elements(node)) collect_images(child, images);
}

/// Returns a text in which %41 stands for A.
std::string unescaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned char byte = 0;
    const char *first = text.data() + i + 1, *last = first + 2;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(first, last, byte, 16).ptr == last) {
      result += char(byte);
      i += 2;
    } else {
      result += text[i];
    }
  }
  return result;
}

/// Returns the bytes of a `data:` reference in base64, in which lines may be broken; nothing if it
/// is something else.
std::optional<std::string> data_bytes(std::string_view reference) {
  const std::size_t comma = reference.find(',');
  if (comma == reference.npos || !reference.substr(0, comma).ends_with(";base64")) return {};
  std::string text = unescaped(reference.substr(comma + 1));
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; });
  return base64_bytes(text);
}

}  // namespace

const xmlNode* only_image(const SvgTree& tree) {
  std::vector<const xmlNode*> images;
  collect_images(tree.root(), images);
  if (images.size() > 1)
    throw InputError("{0}: it holds {1} pictures; leave the one that the outline lies on.",
                     tree.name(), images.size());
  return images.empty() ? nullptr : images.front();
}

ImageFile image_file(const SvgTree& tree) {
  const xmlNode* const image = only_image(tree);
  if (!image)
    throw InputError("{0}: it shows no picture, so that one has to be named.", tree.name());
  std::string reference = href(image);
  if (reference.empty()) reference = attribute(image, "href").value_or("");
  if (reference.starts_with("data:")) {
    if (auto bytes = data_bytes(reference)) return *std::move(bytes);
    throw InputError("{0}: what it holds of its picture cannot be read.", tree.name());
  }
  constexpr std::string_view of_files = "file://";
  std::string_view place = reference;
  if (place.starts_with(of_files)) place.remove_prefix(of_files.size());
  if (place.empty() || place.find("://") != place.npos)
    throw InputError("{0}: its picture {1} is no file of this machine.", tree.name(),
                     excerpt(reference));
  return utf8_path(unescaped(place));
}

}  // namespace gradmesh
