#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>

#include "app/picture_part.h"
#include "app/svg_meshes.h"
#include "files/picture_file.h"

namespace gradmesh {

/// The picture that an <image> of a document shows.
class DocumentPicture {
 public:
  /// `id` and `image` as of image_under (formats/svg/picture/document_image.h). A linked file is
  /// looked for in the document's folders. Throws InputError as image_file does.
  DocumentPicture(const SvgMeshes& svg, const std::string& id, const std::string& image);

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
/// many; `id` and `image` as of SvgMeshes::shape_on_picture.
Picture picture_for(const SvgMeshes& svg, const std::string& id, const std::string& image,
                    int resolution, const std::function<Picture(int longest)>& read);

/// Returns the size of a picture's file, in pixels.
glm::dvec2 full_size(const Picture& picture);

/// Returns the part of a picture around a shape on it.
PicturePart part_around(const Picture& picture, const ShapeOnPicture& on);

}  // namespace gradmesh
