#include "formats/pdf/page/pdf_file.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "base/error.h"
#include "formats/pdf/objects/dictionary.h"
#include "formats/pdf/objects/qpdf.h"
#include "formats/pdf/page/annotations.h"
#include "formats/pdf/page/content_reader.h"
#include "formats/pdf/page/lone_groups.h"
#include "formats/pdf/page/private_data.h"

namespace gradmesh {
namespace {

/// A sheet of American paper, which readers take where a page has no size.
constexpr double usual_width = 612, usual_height = 792;
/// The largest page of Adobe's programs is 200 inches wide; a unit may be larger than a point.
constexpr double largest_page = 1e6;

Box page_box(QPDFPageObjectHelper page) {
  Box box;
  for (const char* name : {"/MediaBox", "/CropBox"}) {
    const std::vector<double> n = numbers_of(page.getAttribute(name, false));
    if (n.size() != 4) continue;
    Box other;
    other.add({n[0], n[1]});
    other.add({n[2], n[3]});
    box = box.empty() ? other : overlap(box, other);
  }
  if (!box.empty() && box.size().x > 0 && box.size().y > 0 && box.size().x < largest_page &&
      box.size().y < largest_page)
    return box;
  Box usual;
  usual.add(glm::dvec2(0.0));
  usual.add({usual_width, usual_height});
  return usual;
}

/// Returns the map from a page's user space to page coordinates, and gives their size.
Affine map_of(QPDFPageObjectHelper page, glm::dvec2& size) {
  const Box box = page_box(page);
  const double unit = number_of(page.getAttribute("/UserUnit", false)).value_or(1);
  const double turn = number_of(page.getAttribute("/Rotate", false)).value_or(0);
  const int quarters = static_cast<int>(std::fmod(std::round(turn / 90), 4) + 4) % 4;
  Affine map = Affine::scaling({1, -1}) * Affine::translation({-box.low().x, -box.high().y});
  size = box.size();
  for (int k = 0; k < quarters; ++k) {
    // A quarter clockwise: what was at the left is at the top.
    map = Affine{glm::dmat2(0, 1, -1, 0), {size.y, 0}} * map;
    std::swap(size.x, size.y);
  }
  if (unit > 0 && unit * std::max(size.x, size.y) < largest_page) {
    map = Affine::scaling({unit, unit}) * map;
    size *= unit;
  }
  return map;
}

}  // namespace

struct PdfFile::Opened {
  std::string bytes;
  QPDF file;
};

PdfFile::PdfFile(std::string bytes, const std::string& name, const std::string& password)
    : file_(std::make_shared<Opened>()) {
  file_->bytes = std::move(bytes);
  QPDF& file = file_->file;
  file.setSuppressWarnings(true);
  try {
    file.processMemoryFile(name.c_str(), file_->bytes.data(), file_->bytes.size(),
                           password.c_str());
    pages_ = file.getAllPages();
  } catch (const QPDFExc& error) {
    if (error.getErrorCode() == qpdf_e_password)
      throw InputError(password.empty() ? Message("{0} is encrypted: its password is needed.", name)
                                        : Message("{0} has another password.", name));
    throw InputError("{0} is damaged: none of its pages can be read.", name);
  } catch (const std::exception&) {
    throw InputError("{0} is damaged: none of its pages can be read.", name);
  }
}

PageContent PdfFile::page(std::size_t number, bool all_layers) const {
  QPDFPageObjectHelper page(pages_.at(number));
  PageContent content;
  content.file = file_;
  GraphicsState state;
  ContentReader reader(all_layers ? Layers() : Layers(file_->file.getRoot()));
  state.to_page = map_of(page, content.size);
  try {
    reader.read(page.getPageContents(), page.getAttribute("/Resources", false), state);
    for (QPDFObjectHandle annotation : annotations_of(page))
      read_annotation(reader, annotation, state);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception&) {
    content.is_damaged = true;
  }
  content.painted = reader.take_painted();
  leave_lone_groups(content.painted);
  content.hidden = reader.hidden();
  content.is_damaged = content.is_damaged || reader.is_damaged();
  // Without it the page is read as well.
  if (!content.painted.empty()) try {
      content.private_data = private_data(page);
    } catch (const std::exception&) {
    }
  return content;
}

}  // namespace gradmesh
