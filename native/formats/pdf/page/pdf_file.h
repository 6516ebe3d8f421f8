#pragma once

#include <memory>
#include <string>
#include <vector>

#include "formats/pdf/page/graphics_state.h"

namespace gradmesh {

/// A page and what it paints by meshes.
struct PageContent {
  /// In points, after its rotation; its upper left corner is (0, 0), and y runs down.
  glm::dvec2 size{0.0};
  std::vector<PaintedShading> painted;
  /// How many further ones are in layers that are off.
  int hidden = 0;
  /// Whether a part of it could not be read, as it is damaged.
  bool is_damaged = false;
  /// What Illustrator keeps for itself beside it, where it paints meshes (private_data.h).
  std::string private_data;
  /// The document, without which the shadings are gone.
  std::shared_ptr<const void> file;
};

/// An opened PDF document.
class PdfFile {
 public:
  /// Throws InputError, whose message says what the document called `name` is: encrypted with
  /// another password, or damaged beyond use.
  PdfFile(std::string bytes, const std::string& name, const std::string& password);

  std::size_t page_count() const { return pages_.size(); }
  /// Reads a page, from 0 on: its content, then its annotations. What is in layers that are off is
  /// left out, unless these count as on. Throws InputError where its content has no end.
  PageContent page(std::size_t number, bool all_layers = false) const;

 private:
  struct Opened;
  std::shared_ptr<Opened> file_;
  std::vector<QPDFObjectHandle> pages_;
};

}  // namespace gradmesh
