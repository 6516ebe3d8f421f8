#include "app/document/formats.h"

#include <algorithm>
#include <stdexcept>

#include "app/document/hemesh_document.h"
#include "app/document/svg_document.h"
#include "app/document/svg_rules.h"

namespace gradmesh {
namespace {

template <class Made>
std::unique_ptr<Document> read(std::string_view bytes, const std::string& name) {
  return std::make_unique<Made>(bytes, name);
}

constexpr const char* page_extensions[] = {".pdf", ".ai", ".eps", ".ps"};

}  // namespace

const std::vector<Format>& all_formats() {
  static const std::vector<Format> formats = {
      {.name = "svg",
       .label = "SVG",
       .document = "SVG document",
       .extension = ".svg",
       .compressed_extension = ".svgz",
       .color_models = {ColorModel::bilinear},
       .count = Count::handles,
       .holds_opacity = true,
       .length = 600,
       .margin = 20,
       .recognises = SvgDocument::recognises,
       .read = read<SvgDocument>,
       .rules = [](const std::string&) { return exact_block_rules(); },
       .write = SvgDocument::write_new},
      {.name = "hemesh",
       .label = ".hemesh",
       .document = ".hemesh file",
       .extension = ".hemesh",
       .color_models = {ColorModel::bicubic, ColorModel::bilinear},
       .length = 2,
       .recognises = HemeshDocument::recognises,
       .read = read<HemeshDocument>,
       .rules = HemeshDocument::rules_of_new,
       .write = HemeshDocument::write_new},
  };
  return formats;
}

bool Format::holds(ColorModel model) const {
  return std::ranges::find(color_models, model) != color_models.end();
}

const Format& format_named(std::string_view wanted) {
  for (const Format& format : all_formats())
    if (wanted == format.name) return format;
  throw std::invalid_argument("documents are of the kind " + formats_in_words(&Format::name) +
                              ", not '" + std::string(wanted) + "'.");
}

const Format* format_of(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  for (const Format& format : all_formats())
    if (extension == format.extension || extension == format.compressed_extension) return &format;
  return nullptr;
}

const Format& format_of_content(std::string_view bytes, const std::filesystem::path& name) {
  for (const Format& format : all_formats())
    if (format.recognises(bytes)) return format;
  const Format* promised = format_of(name);
  return promised ? *promised : all_formats().front();
}

bool is_of_pages(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return std::ranges::find(page_extensions, extension) != std::end(page_extensions);
}

std::string page_document() { return "PDF"; }

std::string formats_in_words(const std::function<std::string(const Format&)>& word) {
  const std::vector<Format>& formats = all_formats();
  std::string words;
  for (std::size_t i = 0; i < formats.size(); ++i) {
    if (i > 0) words += i + 1 < formats.size() ? ", " : " or ";
    words += word(formats[i]);
  }
  return words;
}

}  // namespace gradmesh
