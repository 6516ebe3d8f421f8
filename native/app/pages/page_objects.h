#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/pages/page_documents.h"
#include "formats/svg/group/new_svg.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// A mesh of a page as it is to be written into an SVG document.
struct PageObject {
  /// Its page among those of PageMeshes.
  std::size_t page;
  std::string id;
  /// Through which it is seen, the innermost first; at least one.
  std::vector<SvgShape> shapes;
  /// In pixels.
  Mesh mesh;
  /// Those of the page's own patches.
  int patches, handles;
  std::optional<SvgStroke> stroke;
  std::string blend_mode;
  /// From the coordinates of the mesh and of its own shape to those of the page.
  Affine to_page = {};
  /// Those that it lies in, the outermost first.
  std::vector<std::shared_ptr<const SvgGroup>> groups = {};
};

/// The meshes of a document of pages, in painting order.
struct PageMeshes {
  /// The pages that have meshes.
  std::vector<SvgPage> pages;
  std::vector<PageObject> objects;
  FoundPages found;
};

/// Reads the meshes of a document of pages. Throws InputError as read_pages() does.
PageMeshes read_page_meshes(std::string_view bytes, const std::string& name,
                            const PageChoice& choice);

/// Returns what a person calls a page.
Message page_name(std::size_t number);

/// Gives each object to `add`, with its page, as it is to be written; its label is in `language`.
void write_objects(const std::vector<PageObject>& objects, const Translation& language,
                   const std::function<void(std::size_t page, const NewMesh& mesh)>& add);

}  // namespace gradmesh
