#pragma once

#include <string>

#include "formats/svg/read/document.h"
#include "formats/svg/write/write_group.h"

namespace gradmesh {

/// A page for new_svg, in pixels; the mesh's coordinates are the page's.
struct SvgPage {
  double width, height;
};

/// Returns a document that holds one object, called "mesh", with the outline `outline` (path data),
/// painted by the mesh. If one rectangle of patches holds all of the mesh, and no two of its sides
/// are joined, the object is a path with one mesh gradient, such as Inkscape makes; otherwise it is
/// a group of blocks as of write_mesh.
SvgDocument new_svg(const SvgPage& page, const std::string& outline, const WrittenMesh& written);

}  // namespace gradmesh
