#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/document/document.h"
#include "app/document/found_pages.h"
#include "base/progress.h"

namespace gradmesh {

/// Documents of pages, PDF, PostScript and Illustrator's: they are only read, and become SVG
/// documents that hold their meshes.

/// What of them is read.
struct PageChoice {
  /// The number of the one page, from 1; nothing for all.
  std::optional<int> page = {};
  std::string password = {};
  /// Whether what lies in layers that are off is read, too.
  bool all_layers = false;
  /// Told of pages, as Progress::mesh, and of their shadings, as Progress::done; where it returns
  /// false the meshes so far are what is read.
  ProgressCallback progress = {};
};

/// Returns true if the content is a document of pages.
bool holds_pages(std::string_view bytes);
/// Reads a document of pages as one of SVG, whose pages() are what was found. `name` is that of the
/// file in messages. Throws InputError if there is no such page or no mesh, if the document cannot
/// be opened, if this program was built without PDF, and as pdf_of_postscript() does.
std::unique_ptr<Document> read_pages(std::string_view bytes, const std::string& name,
                                     const PageChoice& choice);

}  // namespace gradmesh
