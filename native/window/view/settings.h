#pragma once

#include <filesystem>

#include "window/eye/eye.h"

namespace gradmesh {

/// What of a window stays from one time to the next.
struct Settings {
  /// In pixels of an ordinary screen.
  int width = 1200, height = 900;
  /// Nothing if nobody has chosen.
  std::optional<bool> is_dark = std::nullopt;
  bool lines = true, handles = false, by_patches = false;

  bool operator==(const Settings&) const = default;
};

/// Returns what a file remembers; what it lacks, or says in a way that is not understood, is as
/// ever.
Settings read_settings(const std::filesystem::path& file);
/// Does nothing where the file cannot be written: the window is as ever then.
void write_settings(const Settings& settings, const std::filesystem::path& file);

}  // namespace gradmesh
