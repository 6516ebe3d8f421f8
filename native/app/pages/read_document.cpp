#include "app/pages/read_document.h"

#include "base/limits.h"
#include "base/utf8_path.h"
#include "files/atomic_file.h"
#include "files/zip.h"

namespace gradmesh {
namespace {

/// Returns the unpacked content of bytes that gzip has compressed. Throws InputError if the content
/// would be beyond the limit on documents, and if the bytes are damaged.
std::string unpacked(std::string_view bytes, const std::string& name) {
  const std::uint64_t most = limits().document, needed = gunzipped_size(bytes);
  if (needed > most)
    throw InputError("{0} unpacks to {1} bytes, {2}.", name, needed,
                     beyond_limit("document", most, needed));
  auto text = gunzip(bytes);
  if (!text) throw InputError("{0} cannot be unpacked: it is damaged.", name);
  return std::move(*text);
}

}  // namespace

std::unique_ptr<Document> read_document(const std::filesystem::path& path,
                                        const PageChoice& choice) {
  std::unique_ptr<Document> document = parse_document(read_bytes(path), path.string(), choice);
  document->file().set_path(path);
  return document;
}

std::unique_ptr<Document> parse_document(std::string_view bytes, const std::string& name,
                                         const PageChoice& choice) {
  if (is_gzip(bytes)) {
    std::unique_ptr<Document> document = parse_document(unpacked(bytes, name), name, choice);
    if (!document->pages()) document->file().set_compressed(bytes);
    return document;
  }
  if (holds_pages(bytes)) return read_pages(bytes, name, choice);
  if (choice.page) throw InputError("{0}: it has no pages to choose from.", name);
  return format_of_content(bytes, utf8_path(name)).read(bytes, name);
}

}  // namespace gradmesh
