#pragma once

#include <vector>

#include "formats/pdf/page/content_reader.h"

namespace gradmesh {

/// Returns the annotations of a page that a viewer shows, in painting order.
std::vector<QPDFObjectHandle> annotations_of(QPDFPageObjectHelper page);

/// Reads what the appearance of an annotation paints (ISO 32000-1, 12.5.5). `page` is the state at
/// the beginning of the page's content.
void read_annotation(ContentReader& reader, QPDFObjectHandle annotation, GraphicsState page);

}  // namespace gradmesh
