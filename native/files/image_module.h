#pragma once

#include "files/image_codec.h"

namespace gradmesh {

/// Returns the module `gradmesh_images`, which the first call loads: OpenImageIO brings hundreds of
/// libraries, and loading them takes longer than many a mesh. Throws InputError where the module
/// cannot be loaded.
const ImageCodec& image_codec();

}  // namespace gradmesh
