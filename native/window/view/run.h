#pragma once

#include <optional>
#include <string>

#include "window/eye/eye.h"

namespace gradmesh {

/// How a window is begun.
struct WindowChoices {
  /// Nothing for what was chosen last, or else what the desktop has.
  std::optional<bool> is_dark = std::nullopt;
  /// Such as "de"; nothing for what the desktop has.
  std::optional<std::string> language = std::nullopt;
  /// What the document is called in the title.
  std::string document = {};
  /// What the titles of another program's windows end with, in front of which it stays; empty for
  /// none.
  std::string above = {};
};

/// Returns the translation into the language of a window.
Translation translation_for(const WindowChoices& choices);

/// Shows the window of simplifying by eye over meshes until a person closes it. Returns true if
/// what was made is to be kept. Throws InputError where there is no display.
bool simplify_by_eye(Eye& eye, const WindowChoices& choices);

}  // namespace gradmesh
