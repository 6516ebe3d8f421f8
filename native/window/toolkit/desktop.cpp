#include "window/toolkit/desktop.h"

#include <SDL.h>
#include <SDL_syswm.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <memory>

#ifdef _WIN32
#include <windows.h>
#endif

namespace gradmesh {
namespace {

constexpr double ordinary_dpi = 96;

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

#ifdef _WIN32

}  // namespace

bool prefers_dark() {
  DWORD is_light = 1, size = sizeof is_light;
  const LSTATUS found = RegGetValueW(
      HKEY_CURRENT_USER, L"Software\\Microsoft\\Windows\\CurrentVersion\\Themes\\Personalize",
      L"AppsUseLightTheme", RRF_RT_REG_DWORD, nullptr, &is_light, &size);
  return found == ERROR_SUCCESS && is_light == 0;
}

namespace {

double dpi_of(SDL_Window* window) {
  float dpi = 0;
  const int display = SDL_GetWindowDisplayIndex(window);
  return SDL_GetDisplayDPI(display, &dpi, nullptr, nullptr) == 0 ? double(dpi) : 0;
}

#else

/// Returns true if GTK's settings ask for dark windows.
bool asks_for_dark(const std::filesystem::path& settings) {
  std::ifstream file(settings);
  for (std::string line; std::getline(file, line);) {
    std::erase(line, ' ');
    std::ranges::transform(line, line.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    if (line.starts_with("gtk-application-prefer-dark-theme="))
      if (line.ends_with("=1") || line.ends_with("=true")) return true;
    if (line.starts_with("gtk-theme-name=") && line.find("dark") != line.npos) return true;
  }
  return false;
}

}  // namespace

bool prefers_dark() {
  if (const std::string theme = environment("GTK_THEME"); !theme.empty())
    return theme.find("dark") != theme.npos;
  std::filesystem::path folder = environment("XDG_CONFIG_HOME");
  if (folder.empty()) folder = std::filesystem::path(environment("HOME")) / ".config";
  return asks_for_dark(folder / "gtk-3.0/settings.ini") ||
         asks_for_dark(folder / "gtk-4.0/settings.ini");
}

namespace {

/// Returns what X11's desktops set for letters, which SDL does not hand out; 0 if there is nothing.
double dpi_of(SDL_Window* window) {
  SDL_SysWMinfo info;
  SDL_VERSION(&info.version);
  if (!SDL_GetWindowWMInfo(window, &info) || info.subsystem != SDL_SYSWM_X11) return 0;
#ifdef SDL_VIDEO_DRIVER_X11
  const std::unique_ptr<void, void (*)(void*)> library(SDL_LoadObject("libX11.so.6"),
                                                       SDL_UnloadObject);
  if (!library) return 0;
  using GetDefault = char* (*)(Display*, const char*, const char*);
  const auto get_default =
      reinterpret_cast<GetDefault>(SDL_LoadFunction(library.get(), "XGetDefault"));
  const char* const dpi = get_default ? get_default(info.info.x11.display, "Xft", "dpi") : nullptr;
  return dpi ? std::atof(dpi) : 0;
#else
  return 0;
#endif
}

#endif

}  // namespace

std::vector<std::string> preferred_languages() {
  std::vector<std::string> languages;
  const std::unique_ptr<SDL_Locale, void (*)(void*)> locales(SDL_GetPreferredLocales(), SDL_free);
  for (const SDL_Locale* each = locales.get(); each && each->language; ++each)
    languages.emplace_back(each->language);
  return languages;
}

float density_of(SDL_Window* window) {
  constexpr double least = 1, most = 4;
  const double dpi = dpi_of(window), times = std::atof(environment("GDK_SCALE").c_str());
  return float(std::clamp(std::max(dpi / ordinary_dpi, times), least, most));
}

std::filesystem::path settings_folder() {
  const std::unique_ptr<char, void (*)(void*)> path(SDL_GetPrefPath(nullptr, "gradmesh"), SDL_free);
  if (!path) return {};
  const std::string utf8 = path.get();
  return std::filesystem::path(std::u8string(utf8.begin(), utf8.end()));
}

}  // namespace gradmesh
