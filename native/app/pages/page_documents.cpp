#include "app/pages/page_documents.h"

#include "app/document/svg_document.h"
#include "app/pages/postscript.h"
#include "app/pages/read_pdf.h"

namespace gradmesh {
namespace {

/// A document whose meshes a page has, as one of SVG.
class PageDocument : public SvgDocument {
 public:
  PageDocument(PageMeshes read, const std::string& name)
      : SvgDocument(svg_of(read), name), found_(std::move(read.found)) {}

  const FoundPages* pages() const override { return &found_; }

 private:
  static std::string svg_of(const PageMeshes& read) {
    NewSvg svg(read.pages);
    const auto english = [](const std::string& text) { return text; };
    write_objects(read.objects, english,
                  [&svg](std::size_t page, const NewMesh& mesh) { svg.add(page, mesh); });
    return svg.tree().serialize();
  }

  const FoundPages found_;
};

}  // namespace

bool holds_pages(std::string_view bytes) {
  // Of an SVG document that tells of PDF at its beginning.
  if (SvgDocument::recognises(bytes)) return false;
  if (is_postscript(bytes)) return true;
  // Programs may write something else before the header (ISO 32000-1, annex H, note 13).
  constexpr std::size_t within = 1024;
  return bytes.substr(0, within).find("%PDF-") != bytes.npos;
}

PageMeshes read_page_meshes(std::string_view bytes, const std::string& name,
                            const PageChoice& choice) {
  if (!is_postscript(bytes)) return read_pdf(bytes, name, choice);
  PageMeshes read = read_pdf(pdf_of_postscript(bytes, name), name, choice);
  read.found.kind = "postscript";
  return read;
}

std::unique_ptr<Document> read_pages(std::string_view bytes, const std::string& name,
                                     const PageChoice& choice) {
  return std::make_unique<PageDocument>(read_page_meshes(bytes, name, choice), name);
}

}  // namespace gradmesh
