#pragma once

#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "form/counts.h"
#include "mesh/mesh.h"
#include "problem/writing_rules.h"
#include "raster/frame.h"

namespace gradmesh {

class Document;

/// A mesh that a new document is to hold.
struct NewDocument {
  /// The mesh in the coordinates of the new document, in a colour model that its format holds.
  const Mesh& mesh;
  /// The mesh whose picture counts, in the same coordinates. Its outline is the object's.
  const Mesh& original;
  /// The frame in which the new document is measured.
  const Frame& frame;
  /// The size of the page; 0 if the format has no pages.
  glm::dvec2 page;
  /// Translates labels.
  const Translation& translation;
};

/// A format of documents as the rest of the program knows it.
struct Format {
  /// The name in options and reports: "svg".
  std::string name;
  /// The name in sentences: "SVG".
  std::string label;
  /// The name of a document in the help: "SVG document".
  std::string document;
  /// The extension of its files: ".svg".
  std::string extension;
  /// The extension of its files once gzip has compressed them: ".svgz". Nothing if there is none.
  std::optional<std::string> compressed_extension = std::nullopt;
  /// The colour models that a document can hold. The first is the one in which its meshes are read.
  std::vector<ColorModel> color_models;
  /// What is made few unless a person says otherwise (what_is_counted).
  Count count = Count::patches;
  /// True if colours may be translucent.
  bool holds_opacity = false;
  /// The length of the longer side of a mesh that comes from another format, in the document's
  /// units.
  double length = 1;
  /// The width of the page around such a mesh. Nothing if the format has no pages: then the middle
  /// of the mesh lies at the origin.
  std::optional<double> margin = std::nullopt;
  /// Returns true if the content is of this format.
  bool (*recognises)(std::string_view bytes);
  /// Reads a document, whose name stands in messages. Throws InputError.
  std::unique_ptr<Document> (*read)(std::string_view bytes, const std::string& name);
  /// Returns the rules by which a new document holds its mesh; the name stands in messages.
  std::shared_ptr<const WritingRules> (*rules)(const std::string& name);
  /// Returns the content of a new document that holds one mesh.
  std::string (*write)(const NewDocument& document);

  bool holds(ColorModel model) const;
  friend bool operator==(const Format& a, const Format& b) { return a.name == b.name; }
};

/// Returns all formats, in the order in which lists show them.
const std::vector<Format>& all_formats();

/// Returns the format of that name. Throws std::invalid_argument with the names of all formats if
/// there is none.
const Format& format_named(std::string_view name);

/// Returns the format that the extension of a file promises; null if the extension is that of none.
const Format* format_of(const std::filesystem::path& path);

/// Returns the format that recognises the content. If none does, returns the format that the name
/// promises, or else the first, which then says what is wrong with the content.
const Format& format_of_content(std::string_view bytes, const std::filesystem::path& name);

/// Returns true if the extension of a file promises a document of pages, PDF, PostScript or
/// Illustrator's, which is only read.
bool is_of_pages(const std::filesystem::path& path);
/// Returns what help calls such a document.
std::string page_document();

/// Returns one word for each format as a list in English: "svg or hemesh".
std::string formats_in_words(const std::function<std::string(const Format&)>& word);

}  // namespace gradmesh
