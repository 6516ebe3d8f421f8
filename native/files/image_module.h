#pragma once

#include "files/image_codec.h"

namespace gradmesh {

/// The module `gradmesh_images`, loaded when it is first asked for: OpenImageIO brings hundreds of
/// libraries, and loading them takes longer than many a mesh. Throws InputError where it cannot be.
const ImageCodec& image_codec();

}  // namespace gradmesh
