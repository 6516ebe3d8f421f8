#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "app/document/document.h"
#include "app/pages/page_documents.h"

namespace gradmesh {

/// Read a document of any kind, whose content decides which kind it is; a document of pages becomes
/// one of SVG. `choice` says what of pages is read. Throw InputError if the content cannot be read,
/// and if pages are chosen of a document that has none.
std::unique_ptr<Document> read_document(const std::filesystem::path& path,
                                        const PageChoice& choice = {});
/// `name` is that of the document in messages.
std::unique_ptr<Document> parse_document(std::string_view bytes, const std::string& name,
                                         const PageChoice& choice = {});

}  // namespace gradmesh
