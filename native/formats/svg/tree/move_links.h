#pragma once

#include "formats/svg/tree/svg_tree.h"
#include "formats/svg/values/moved_link.h"

namespace gradmesh {

/// Changes the links to files by which the document shows something, so that they lead there from
/// the new folder (formats/svg/values/moved_link.h): `href` and `xlink:href` of elements of SVG,
/// `url(…)` in style sheets, styles and attributes, `@import` and `<?xml-stylesheet?>`. Returns
/// false if there are none. As in Inkscape, `<a>` stays, which shows nothing, and so does
/// `sodipodi:absref`, which is absolute. What is inside of an `xml:base` stays as well: it does not
/// depend on the document's folder alone, and programs differ in whether they heed it.
bool move_links(SvgTree& tree, const FolderMove& move);

}  // namespace gradmesh
