#pragma once

#include <string>
#include <string_view>

#include "app/pages/page_objects.h"

namespace gradmesh {

/// Reads the meshes of PDF pages; there is at least one. Throws InputError as read_pages() does.
PageMeshes read_pdf(std::string_view bytes, const std::string& name, const PageChoice& choice);

}  // namespace gradmesh
