#pragma once

#include <string>

#include "formats/svg/read/document.h"
#include "formats/svg/write/write_group.h"

namespace gradmesh {

/// A page for `write_new_svg`, in pixels; the mesh's coordinates are the page's.
struct SvgPage {
  double width, height;
};

/// A document that holds one object, called "mesh", with the outline `outline` (path data), painted
/// by the mesh. Where one rectangle of patches holds all of the mesh, and joins no two of its
/// sides, the object is a path with one mesh gradient, such as Inkscape makes; otherwise a group of
/// blocks as of write_mesh.
SvgDocument new_svg(const SvgPage& page, const std::string& outline, const WrittenMesh& written);

}  // namespace gradmesh
