#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>

#include "app/document/svg_document.h"
#include "files/picture_file.h"
#include "reference/original.h"
#include "reference/weights.h"

namespace gradmesh {

/// The picture that an <image> of a document shows.
class DocumentPicture {
 public:
  /// `id` and `image` as of image_under (formats/svg/picture/document_image.h). A linked file is
  /// looked for in the document's folders. Throws InputError as image_file does.
  DocumentPicture(const SvgDocument& svg, const std::string& id, const std::string& image);

  /// Reads it as read_picture does.
  Picture read(int longest) const;
  /// Returns a hash of the bytes of its file. Throws InputError if that cannot be read.
  std::uint64_t hash() const;

 private:
  std::string name_;
  ImageFile file_;
};

/// Reads a picture so that a shape on it, and not the picture around that, has `resolution` pixels
/// along the longer side, if the picture has as many. `read` returns the picture with at most so
/// many; `id` and `image` as of SvgDocument::shape_on_picture.
Picture picture_for(const SvgDocument& svg, const std::string& id, const std::string& image,
                    int resolution, const std::function<Picture(int longest)>& read);

/// Returns the size of a picture's file, in pixels.
glm::dvec2 full_size(const Picture& picture);

/// A picture, or a part of one, of which a mesh is made, and where the mesh is to lie. Places are
/// in pixels of the file, before it was reduced, from the upper left corner of the part.
struct PicturePart {
  RgbaImage image;
  glm::dvec2 size;
  /// The map from these places to the mesh's coordinates.
  Affine to_mesh;
  /// How many pixels of the document a pixel of the file is, where that is painted at its own size.
  double scale = 1;
  /// What of the part counts; nothing if all of it does.
  std::optional<FilledOutline> shape = std::nullopt;
  /// Open lines along which lines of the mesh are to run (trace/guided_grid.h). They may reach
  /// beyond the part.
  std::vector<std::vector<glm::dvec2>> guides = {};
  /// Where pixels count more or less than elsewhere. Areas may reach beyond the part, too.
  std::vector<WeightedArea> weighted = {};
};

/// Returns the part of a picture around a shape on it; areas are in pixels of its file.
PicturePart part_around(const Picture& picture, const ShapeOnPicture& on,
                        std::vector<WeightedArea> weighted = {});

/// Returns the picture that a mesh was traced from, in the units of the mesh, if the document still
/// shows it as it did then, its file can be read and is the same, and no person has edited the mesh
/// since; else null. `resolution` is that at which it will be painted.
std::shared_ptr<const Original> traced_original(const SvgDocument& svg, const MeshEntry& entry,
                                                int resolution);

}  // namespace gradmesh
