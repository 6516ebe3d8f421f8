#pragma once

#include <string>
#include <string_view>

#include "app/page_documents.h"

namespace gradmesh {

/// The meshes of pages as an SVG document.
struct PagesAsSvg {
  std::string svg;
  FoundPages found;
};

/// Reads the meshes of PDF pages. Throws InputError as read_pages() does.
PagesAsSvg read_pdf(std::string_view bytes, const std::string& name, const PageChoice& choice);

}  // namespace gradmesh
