#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/document/document.h"

namespace gradmesh {

struct PublishOptions {
  /// Pixels of a picture along one pixel of the document in its own size, above 0 to 16. A picture
  /// has fewer where these show the same (app/export/smallest_picture.h).
  double scale = 2;
};

/// What shows a mesh in a published document.
enum class PublishedAs { picture, linear_gradient, color, nothing };
/// Returns the name in reports: "picture", "linear gradient", "colour" or "nothing".
const char* name(PublishedAs as);

struct PublishedMesh {
  std::string id;
  PublishedAs as = PublishedAs::picture;
  /// The size of the picture in pixels, and of its file; 0 if there is none.
  int width = 0, height = 0;
  std::size_t bytes = 0;
  /// The value of MeshEntry::refused. Such a mesh stays as it is, and nothing shows it.
  std::optional<Message> refused = std::nullopt;
};

/// Makes an SVG document one that programs without mesh gradients show as Inkscape does. Instead of
/// each mesh the object shows a picture of it, which the object's own shape cuts: its edges stay
/// curves. If the mesh is of one colour, or of colours along a line, and the shape lies inside it,
/// the shape gets that colour or a linear gradient. Blocks become one picture. All else stays, but
/// for mesh gradients, hidden originals, what gradmesh remembers and the script by which Inkscape
/// has browsers paint meshes. Pictures have at most as many pixels along a side as the limit on
/// resolution allows.
///
/// Throws InputError for other documents and if no mesh can be read, std::invalid_argument if the
/// scale is out of range. The document is unchanged after an exception.
std::vector<PublishedMesh> publish(Document& document, const PublishOptions& options = {});

}  // namespace gradmesh
