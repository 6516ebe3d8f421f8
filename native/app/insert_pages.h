#pragma once

#include <filesystem>
#include <string>

#include "app/document.h"
#include "app/page_documents.h"

namespace gradmesh {

/// Puts the meshes of a document of pages, the file at `path`, into an SVG document, where and as
/// large as they are seen on the page: above all else in a new layer for each page or, unless it is
/// empty, into the group with the id `into`. A page lies on that with its number, or else on the
/// first one, further ones beside it. Returns what was found, each mesh with the id of its object.
/// Throws InputError as read_pages() does, for another document,
/// and if there is no such group; the document is then unchanged.
FoundPages insert_pages(Document& document, const std::filesystem::path& path,
                        const PageChoice& choice, const std::string& into = {});

}  // namespace gradmesh
