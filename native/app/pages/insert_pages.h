#pragma once

#include <filesystem>
#include <string>

#include "app/document/document.h"
#include "app/pages/page_documents.h"

namespace gradmesh {

struct InsertOptions {
  PageChoice pages = {};
  /// The id of the group that meshes go into; empty for a new layer for each page.
  std::string into = {};
  /// Whether groups of flat tiles that show the same as a mesh, as Inkscape's import makes, are
  /// replaced by it (app/pages/tiles_of_meshes.h).
  bool replace_tiles = true;
};

struct InsertedPages {
  /// Each mesh with the id of its object.
  FoundPages found;
  /// How many groups of tiles were replaced.
  int replaced = 0;
};

/// Puts the meshes of a document of pages, the file at `path`, into an SVG document, where and as
/// large as they are seen on the page: in the place of their tiles, or above all else. A page lies
/// on that with its number, or else on the first one, further ones beside it. Nothing changes where
/// it was stopped before a mesh was read. Throws InputError as read_pages() does, for another
/// document, and if there is no such group; the document is then unchanged.
InsertedPages insert_pages(Document& document, const std::filesystem::path& path,
                           const InsertOptions& options = {});

}  // namespace gradmesh
