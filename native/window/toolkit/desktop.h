#pragma once

#include <filesystem>
#include <string>
#include <vector>

struct SDL_Window;

namespace gradmesh {

/// What the desktop of a person says of how windows look.

/// Returns true if windows are dark, as far as the desktop says so where a program can read it.
bool prefers_dark();
/// Returns the languages that a person reads, such as "de", the one they like best first.
std::vector<std::string> preferred_languages();
/// Returns how many pixels the screen of a window has for each of an ordinary one; 1 where nobody
/// says.
float density_of(SDL_Window* window);
/// Returns the folder for what a program remembers of a person's choices; empty if there is none.
std::filesystem::path settings_folder();

}  // namespace gradmesh
