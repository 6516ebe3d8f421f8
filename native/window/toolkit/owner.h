#pragma once

#include <string>

struct SDL_Window;

namespace gradmesh {

/// A window of another program, such as the Inkscape that waits for this one.
struct OwnerTitle {
  /// What its title ends with; nothing is looked for if that is empty.
  std::string end = {};
  /// What its title holds, too, if there are several.
  std::string part = {};
};

/// Gives a window that is not yet shown to the foremost window with such a title. It then stays in
/// front of that, and has no entry of its own in a list of tasks. On X11 clicks on the other
/// window, which it would answer once it goes on, are dropped. Does nothing where there is none,
/// and on systems other than X11 and Windows.
void give_to(SDL_Window* window, const OwnerTitle& owner);

}  // namespace gradmesh
