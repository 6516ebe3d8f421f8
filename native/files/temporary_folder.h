#pragma once

#include <filesystem>

namespace gradmesh {

/// A new folder of the system's folder for temporary files, which nobody else can look into. It is
/// removed with all that is in it. Not on Windows.
class TemporaryFolder {
 public:
  /// Throws InputError, which names the folder that it cannot be made in.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace gradmesh
