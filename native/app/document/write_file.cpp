#include "app/document/write_file.h"

#include <system_error>

#include "files/atomic_file.h"

namespace gradmesh {
namespace {

namespace fs = std::filesystem;

/// Returns true if a path leads to a pipe or the like, or is one of the system's names for what a
/// program reads and writes.
bool is_stream(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) return true;
  const fs::path relative = path.relative_path();
  const bool is_of_system =
      !relative.empty() && (*relative.begin() == "dev" || *relative.begin() == "proc");
  return is_of_system && fs::is_symlink(path, ignored);
}

/// Returns the path with its folder as the disk has it, through whatever links that is named: `..`
/// leads up from there.
fs::path on_disk(const fs::path& path) {
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(path.parent_path(), error);
  return (error ? path.parent_path().lexically_normal() : folder) / path.filename();
}

}  // namespace

void check_target(const Document& document, const fs::path& path) {
  if (is_of_pages(path))
    throw InputError("{0}: such documents are only read; write an SVG document or a .hemesh file.",
                     path.string());
  const Format* promised = format_of(path);
  if (promised && *promised != document.format())
    throw InputError(
        "{0} is not of the kind of {1}: gradmesh convert makes a .hemesh file of an SVG document, "
        "and the reverse.",
        document.name(), path.string());
}

void write_file(const Document& document, const fs::path& path) {
  check_target(document, path);
  const fs::path& source = document.file().path();
  const std::optional<FolderMove> move = source.empty() ? std::nullopt : folder_move(source, path);
  const std::string content = move ? document.bytes_in(*move) : document.bytes();
  const bool is_packed = path.extension().string() == document.format().compressed_extension;
  write_bytes(path, is_packed ? document.file().compressed(content) : content);
}

std::optional<FolderMove> folder_move(const fs::path& from, const fs::path& to) {
  std::error_code error;
  const fs::path source = fs::absolute(from, error), target = fs::absolute(to, error);
  if (error || is_stream(source) || is_stream(target)) return std::nullopt;
  const fs::path file = on_disk(source), folder = on_disk(target).parent_path();
  if (file.parent_path() == folder) return std::nullopt;
  return FolderMove{file, folder};
}

}  // namespace gradmesh
