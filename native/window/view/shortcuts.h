#pragma once

#include "window/eye/eye.h"
#include "window/toolkit/sdl_window.h"
#include "window/tools/toolbox.h"

namespace gradmesh {

/// What of a key only the window itself can do.
enum class WindowKey { none, apply, escape };

/// Does what a key means, as far as Inkscape has it the same.
WindowKey press(const Key& key, Eye& eye, Toolbox& toolbox);

}  // namespace gradmesh
