#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gradmesh {

/// What a document was read from: its bytes, and where they lay.
class DocumentFile {
 public:
  /// `name` stands in messages.
  DocumentFile(std::string name, std::string_view bytes)
      : name_(std::move(name)), content_(bytes) {}

  const std::string& name() const { return name_; }
  /// Returns the bytes, unpacked.
  const std::string& content() const { return content_; }
  /// Returns the absolute path of the file; empty if it is not known.
  const std::filesystem::path& path() const { return path_; }
  /// Returns the folders in which files that the document names are looked for, one after the
  /// other.
  const std::vector<std::filesystem::path>& folders() const { return folders_; }
  /// Returns `content` compressed by gzip: as it was read, if it is that.
  std::string compressed(const std::string& content) const;

  /// Sets from which file it was read: what it names is looked for in the folder of that.
  void set_path(const std::filesystem::path& path);
  /// Sets the folders. Nobody knows then to which of them links are relative, so that they stay as
  /// they are wherever the document is written.
  void look_in(std::vector<std::filesystem::path> folders);
  /// Sets the bytes as they were before they were unpacked.
  void set_compressed(std::string_view bytes) { compressed_ = bytes; }

 private:
  std::string name_, content_, compressed_;
  std::vector<std::filesystem::path> folders_;
  std::filesystem::path path_;
};

}  // namespace gradmesh
