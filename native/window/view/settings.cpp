#include "window/view/settings.h"

#include <fstream>
#include <sstream>

namespace gradmesh {
namespace {

/// Sizes that a window may have; what else a file says is a mistake.
constexpr int least = 320, most = 16384;

void take_size(std::istream& from, int& size) {
  int read = 0;
  if (from >> read && read >= least && read <= most) size = read;
}

template <class Flag>
void take_flag(std::istream& from, Flag& flag) {
  bool read = false;
  if (from >> read) flag = read;
}

}  // namespace

Settings read_settings(const std::filesystem::path& file) {
  Settings settings;
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream from(line);
    std::string name;
    from >> name;
    if (name == "width") take_size(from, settings.width);
    if (name == "height") take_size(from, settings.height);
    if (name == "dark") take_flag(from, settings.is_dark);
    if (name == "lines") take_flag(from, settings.lines);
    if (name == "handles") take_flag(from, settings.handles);
    if (name == "patches") take_flag(from, settings.by_patches);
  }
  return settings;
}

void write_settings(const Settings& settings, const std::filesystem::path& file) {
  std::ofstream lines(file);
  lines << "width " << settings.width << "\nheight " << settings.height << "\nlines "
        << settings.lines << "\nhandles " << settings.handles << "\npatches " << settings.by_patches
        << "\n";
  if (settings.is_dark) lines << "dark " << *settings.is_dark << "\n";
}

}  // namespace gradmesh
