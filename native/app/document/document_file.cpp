#include "app/document/document_file.h"

#include "files/zip.h"

namespace gradmesh {

std::string DocumentFile::compressed(const std::string& content) const {
  return compressed_.empty() || content != content_ ? gzip(content) : compressed_;
}

void DocumentFile::set_path(const std::filesystem::path& path) {
  look_in({path.parent_path()});
  // Now, as a program may go to another folder until it writes.
  path_ = std::filesystem::absolute(path);
}

void DocumentFile::look_in(std::vector<std::filesystem::path> folders) {
  folders_ = std::move(folders);
  path_.clear();
}

}  // namespace gradmesh
