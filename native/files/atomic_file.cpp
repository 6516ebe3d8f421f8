#include "files/atomic_file.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <memory>
#include <system_error>

#include "base/error.h"
#include "base/limits.h"

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace gradmesh {
namespace {

namespace fs = std::filesystem;

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

#ifdef _WIN32

File open_to_read(const fs::path& path) { return File(_wfopen(path.c_str(), L"rb")); }
File create(const fs::path& path) { return File(_wfopen(path.c_str(), L"wbx")); }
int bring_to_disk(std::FILE* file) { return _commit(_fileno(file)); }

#else

File open_to_read(const fs::path& path) { return File(std::fopen(path.c_str(), "rb")); }
/// Creates a file. Returns null with errno EEXIST if there is such a file already.
File create(const fs::path& path) { return File(std::fopen(path.c_str(), "wbx")); }
int bring_to_disk(std::FILE* file) { return fsync(fileno(file)); }

#endif

[[noreturn]] void fail_to_read(const fs::path& path, std::error_code error) {
  throw InputError("{0} cannot be read: {1}.", path.string(), error.message());
}
[[noreturn]] void fail_to_write(const fs::path& path, const Message& reason) {
  throw InputError("{0} cannot be written: {1}.", path.string(), reason);
}
[[noreturn]] void fail_to_write(const fs::path& path, std::error_code error) {
  fail_to_write(path, Message("{0}", error.message()));
}

[[noreturn]] void fail_as_too_large(const fs::path& path, std::uint64_t read) {
  std::error_code ignored;
  const std::uintmax_t whole = fs::file_size(path, ignored);
  const std::uint64_t needed = ignored ? read : std::max<std::uint64_t>(whole, read);
  throw InputError("{0} has {1} bytes, {2}.", path.string(), needed,
                   beyond_limit("document", limits().document, needed));
}

std::error_code last_error() { return {errno, std::generic_category()}; }

/// Creates a new file in the folder and sets `path` to its path. Returns null with errno where none
/// can be made.
File create_temporary(const fs::path& folder, fs::path& path) {
  // Hardly anybody has the same now, and a file that is there already is never taken.
  const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  for (int tries = 0; tries < 100; ++tries) {
    path = folder / (".gradmesh-" + std::to_string(now + tries));
    if (File file = create(path); file || errno != EEXIST) return file;
  }
  return nullptr;
}

/// Writes the bytes to the disk and closes the file.
std::error_code store(File file, std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size() ||
      std::fflush(file.get()) != 0 || bring_to_disk(file.get()) != 0)
    return last_error();
  return std::fclose(file.release()) == 0 ? std::error_code() : last_error();
}

}  // namespace

std::string read_bytes(const fs::path& path) {
  const File file = open_to_read(path);
  if (!file) fail_to_read(path, last_error());
  std::string bytes;
  char block[1 << 16];
  while (const std::size_t count = std::fread(block, 1, sizeof block, file.get()))
    if (bytes.append(block, count).size() > limits().document)
      fail_as_too_large(path, bytes.size());
  if (std::ferror(file.get())) fail_to_read(path, last_error());
  return bytes;
}

void write_bytes(const fs::path& path, std::string_view bytes) {
  std::error_code ignored, error;
  // Through a link, the file that it names is replaced, never the link.
  const fs::path target =
      fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
  const fs::file_status replaced = fs::status(target, ignored);
  if (fs::exists(replaced) && !fs::is_regular_file(replaced))
    fail_to_write(path, Message("it is not a regular file"));

  fs::path temporary;
  File file = create_temporary(target.parent_path(), temporary);
  if (!file) fail_to_write(path, last_error());
  // The permissions are set before the file holds bytes that others must not read.
  if (fs::exists(replaced)) fs::permissions(temporary, replaced.permissions(), error);
  if (!error) error = store(std::move(file), bytes);
  if (!error) fs::rename(temporary, target, error);
  if (error) {
    file.reset();
    fs::remove(temporary, ignored);
    fail_to_write(path, error);
  }
}

}  // namespace gradmesh
