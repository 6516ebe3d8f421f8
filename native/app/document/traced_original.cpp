#include "app/document/traced_original.h"

#include "app/document/document_picture.h"
#include "base/error.h"

namespace gradmesh {
namespace {

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
