#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/document/document.h"

namespace gradmesh {

/// The languages in which meshes are written for apps: Swift for SwiftUI, Kotlin for Compose.
enum class CodeLanguage { swift, compose };
/// Returns the language of the name "swift" or "compose". Throws std::invalid_argument for others.
CodeLanguage code_language_named(const std::string& name);
/// Returns the extension of its files: ".swift" or ".kt".
const char* code_extension(CodeLanguage language);
/// Returns true if a file of code was written by gradmesh, by its first line.
bool is_published_code(std::string_view text);

struct PublishedCode {
  std::string id;
  /// What the code calls the mesh; empty if it was refused.
  std::string name;
  /// A whole file of code; empty if the mesh was refused.
  std::string source;
  /// Sentences on what of the object's look the code does not hold.
  std::vector<Message> lost;
  /// The value of MeshEntry::refused.
  std::optional<Message> refused = std::nullopt;
};

struct PublishedSources {
  std::vector<PublishedCode> meshes;
  /// One file with all of them.
  std::string source;
};

/// Returns the meshes of an SVG document as code, which paints them by the mesh gradients of
/// SwiftUI or Compose: as they are seen on the page, with the box around a mesh as the view's
/// frame, cut by what they are seen through. A mesh with T-junctions is painted as the blocks that
/// it has in SVG. Throws InputError for other documents and if no mesh can be read.
PublishedSources publish_code(Document& document, CodeLanguage language);

}  // namespace gradmesh
