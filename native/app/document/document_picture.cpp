#include "app/document/document_picture.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <system_error>

#include "base/clamped_int.h"
#include "base/error.h"
#include "base/hash.h"
#include "files/atomic_file.h"

namespace gradmesh {
namespace {

/// Returns the window of a picture's pixels around a shape that is in pixels of its file.
Window window_around(const Outline& shape, const Picture& picture) {
  // So many more pixels each way as the metric looks at around those that count.
  constexpr int around = 8;
  const RgbaImage& image = picture.image;
  const Affine to_image =
      Affine::scaling(glm::dvec2(image.width, image.height) / full_size(picture));
  const Box box = bounding_box(mapped(shape, to_image));
  return Window{clamped_int(std::floor(box.low().x), 0, image.width),
                clamped_int(std::floor(box.low().y), 0, image.height),
                clamped_int(std::ceil(box.high().x), 0, image.width),
                clamped_int(std::ceil(box.high().y), 0, image.height)}
      .grown(around)
      .clipped(image.window());
}

/// Returns how many parts at the end of a path do not exist.
int missing_parts(std::filesystem::path path) {
  std::error_code error;
  int count = 0;
  for (; !std::filesystem::exists(path, error) && path.has_relative_path(); ++count)
    path = path.parent_path();
  return count;
}

/// Returns where a person knows a file that is in none of the folders. A link is relative to one of
/// them; under the others most folders on its way are missing as well.
std::filesystem::path likeliest_place(const std::filesystem::path& file,
                                      const std::vector<std::filesystem::path>& folders) {
  std::vector<std::filesystem::path> places;
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder)
    places.push_back((*folder / file).lexically_normal());
  const auto least = std::ranges::min_element(places, {}, missing_parts);
  return least == places.end() ? file : *least;
}

std::shared_ptr<const Original> original_of_picture(const SvgDocument& svg, const MeshEntry& entry,
                                                    const RememberedPicture& remembered,
                                                    int resolution) {
  const DocumentPicture shown(svg, entry.id, remembered.image);
  if (shown.hash() != remembered.hash) return nullptr;
  const Picture picture = picture_for(svg, entry.id, remembered.image, resolution,
                                      [&](int longest) { return shown.read(longest); });
  const glm::dvec2 size = full_size(picture);
  if (!svg.lies_as_traced(entry, remembered, size)) return nullptr;
  const ShapeOnPicture on = svg.shape_on_picture(entry.id, remembered.image, {}, size);
  PicturePart part = part_around(picture, on);
  const glm::dvec2 pixel = part.size / glm::dvec2(part.image.width, part.image.height);
  const Affine user_to_mesh = svg.place(entry).to_user.inverse();
  return original_of(std::move(part.image), user_to_mesh * part.to_mesh * Affine::scaling(pixel));
}

}  // namespace

DocumentPicture::DocumentPicture(const SvgDocument& svg, const std::string& id,
                                 const std::string& image)
    : name_(svg.name()), file_(svg.image_file(id, image)) {
  auto* const place = std::get_if<std::filesystem::path>(&file_);
  if (!place) return;
  for (const std::filesystem::path& folder : svg.file().folders()) {
    std::error_code error;
    if (!std::filesystem::exists(folder / *place, error)) continue;
    *place = folder / *place;
    return;
  }
  *place = likeliest_place(*place, svg.file().folders());
}

Picture DocumentPicture::read(int longest) const {
  if (const auto* bytes = std::get_if<std::string>(&file_))
    return picture_of_bytes(*bytes, name_, longest);
  return read_picture(std::get<std::filesystem::path>(file_), longest);
}

std::uint64_t DocumentPicture::hash() const {
  Hash hash;
  if (const auto* bytes = std::get_if<std::string>(&file_))
    hash.add(*bytes);
  else
    hash.add(read_bytes(std::get<std::filesystem::path>(file_)));
  return hash.value();
}

glm::dvec2 full_size(const Picture& picture) { return {picture.full_width, picture.full_height}; }

Picture picture_for(const SvgDocument& svg, const std::string& id, const std::string& image,
                    int resolution, const std::function<Picture(int longest)>& read) {
  Picture picture = read(resolution);
  const glm::dvec2 size = full_size(picture);
  const glm::dvec2 shape =
      bounding_box(svg.shape_on_picture(id, image, {}, size).shape.outline).size();
  const double longest = std::max(size.x, size.y);
  const double wanted = resolution * longest / std::max({shape.x, shape.y, 1.0});
  if (wanted < resolution || longest > resolution)
    picture = read(clamped_int(std::min(wanted, longest), 1, INT_MAX));
  return picture;
}

PicturePart part_around(const Picture& picture, const ShapeOnPicture& on,
                        std::vector<WeightedArea> weighted) {
  const RgbaImage& image = picture.image;
  const Window window = window_around(on.shape.outline, picture);
  const glm::dvec2 pixel = full_size(picture) / glm::dvec2(image.width, image.height);
  const glm::dvec2 corner = pixel * glm::dvec2(window.x0, window.y0);
  PicturePart part{RgbaImage(window.width(), window.height()),
                   pixel * glm::dvec2(window.width(), window.height()),
                   on.to_mesh * Affine::translation(corner),
                   on.scale,
                   mapped(on.shape, Affine::translation(-corner)),
                   mapped(on.guides, Affine::translation(-corner)),
                   std::move(weighted)};
  for (WeightedArea& area : part.weighted)
    for (FilledOutline& shape : area.shapes)
      shape = mapped(std::move(shape), Affine::translation(-corner));
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x)
      part.image.set_pixel(x - window.x0, y - window.y0, image.pixel(x, y));
  return part;
}

std::shared_ptr<const Original> traced_original(const SvgDocument& svg, const MeshEntry& entry,
                                                int resolution) {
  const std::optional<RememberedPicture> remembered = svg.traced_from(entry);
  if (!remembered) return nullptr;
  try {
    return original_of_picture(svg, entry, *remembered, resolution);
  } catch (const InputError&) {
    // A picture that is gone, or cannot be read, is none that a mesh could be measured against.
    return nullptr;
  }
}

}  // namespace gradmesh
