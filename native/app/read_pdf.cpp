#include "app/read_pdf.h"

#include <optional>
#include <tuple>

#include "app/mesh_label.h"
#include "app/page_mesh_object.h"
#include "app/svg_rules.h"
#include "base/limits.h"
#include "formats/pdf/page/painted_patches.h"
#include "formats/pdf/page/pdf_file.h"
#include "formats/pdf/records/mesh_records.h"
#include "formats/pdf/records/record_of_page.h"
#include "mesh/rectangle.h"
#include "simplify/options.h"

namespace gradmesh {
namespace {

/// A mesh as it is to be written.
struct PageObject {
  std::size_t page;
  std::string id;
  std::vector<SvgShape> shapes;
  Mesh mesh;
  int patches, handles;
  std::optional<SvgStroke> stroke;
  std::string blend_mode;
};

class PdfReader {
 public:
  PdfReader(std::string_view bytes, const std::string& name, const PageChoice& choice)
      : file_(std::string(bytes), name, choice.password), name_(name) {
    const auto count = file_.page_count();
    if (choice.page && (*choice.page < 1 || std::size_t(*choice.page) > count))
      throw InputError("{0}: there is no page {1}; it has {2}.", name, *choice.page, count);
    for (std::size_t n = 0; n < count; ++n)
      if (!choice.page || n + 1 == std::size_t(*choice.page)) read_page(n);
  }

  PagesAsSvg run() && {
    if (objects_.empty()) {
      if (!found_.left_out.empty()) throw InputError(found_.left_out.front());
      throw InputError("{0}: there is no gradient mesh on its pages.", name_);
    }
    NewSvg svg(pages_);
    for (const PageObject& each : objects_) write(svg, each);
    return {svg.tree().serialize(), std::move(found_)};
  }

 private:
  template <class Work>
  auto naming_page(std::size_t number, const Work& work) const {
    try {
      return work();
    } catch (const InputError& error) {
      throw InputError("{0}, page {1}: {2}.", name_, number + 1, error.message());
    }
  }

  void read_page(std::size_t number) {
    const PageContent page = naming_page(number, [&] { return file_.page(number); });
    if (page.is_damaged)
      found_.left_out.push_back(Message(
          "{0}, page {1}: it is damaged; what lies behind that is left out.", name_, number + 1));
    const std::vector<ArtistsGrid> records = read_mesh_records(page.private_data);
    const std::size_t before = objects_.size();
    for (std::size_t n = 0; n < page.painted.size(); ++n) try {
        read_mesh(page.painted[n], records, number, n);
      } catch (const InputError& error) {
        found_.left_out.push_back(
            Message("{0}, page {1}, mesh {2}: {3}.", name_, number + 1, n + 1, error.message()));
      }
    if (objects_.size() == before) return;
    pages_.push_back({pixels_per_point * page.size.x, pixels_per_point * page.size.y,
                      Message("Page {0}", number + 1).english()});
  }

  void read_mesh(const PaintedShading& painted, const std::vector<ArtistsGrid>& records,
                 std::size_t page, std::size_t number) {
    const PaintedPatches read = painted_patches(painted, kept_);
    const auto& [type, colors, own, is_damaged] = read.shading;
    if (own.empty()) throw InputError("it has no patches");
    check_size(own.size());
    const auto corners = [&read](const auto& patches) {
      return corners_in_srgb(patches, read.shading.colors);
    };
    const ChosenForm chosen = choose_form(
        read.patches, mesh_forms(own, read.patches, corners, record_of(read.patches, records)));
    std::vector<SvgShape> shapes = shapes_of(chosen.mesh, painted.clips, painted.stroke.get());
    if (shapes.empty()) throw InputError("its clip path hides it");
    if (read.mask_left_out)
      found_.left_out.push_back(
          Message("{0}, page {1}, mesh {2}: a mask through which it is seen is left out.", name_,
                  page + 1, number + 1));
    if (is_damaged)
      found_.left_out.push_back(
          Message("{0}, page {1}, mesh {2}: it is damaged; patches of it are left out.", name_,
                  page + 1, number + 1));
    const std::string id =
        "page-" + std::to_string(page + 1) + "-mesh-" + std::to_string(number + 1);
    const int patches = int(own.size());
    FoundMesh& found = found_.meshes.emplace_back();
    found = {id, int(page + 1), int(number + 1), type, patches};
    if (const auto grid = find_grid(chosen.mesh))
      std::tie(found.rows, found.columns) = std::pair(grid->rows, grid->columns);
    found.is_joined = chosen.kind != MeshForm::Kind::page;
    found.is_from_record = chosen.kind == MeshForm::Kind::record;
    found.is_smooth = chosen.mesh.is_smooth();
    found.difference = chosen.difference;
    found.handles = chosen.page_handles;
    std::optional<SvgStroke> stroke;
    if (painted.stroke) stroke = svg_stroke(painted.stroke->line);
    objects_.push_back({pages_.size(), id, std::move(shapes), chosen.mesh, patches,
                        chosen.page_handles, std::move(stroke), painted.blend_mode});
  }

  /// Returns the record of which these patches are parts; nothing if there is none.
  static std::optional<ArtistsGrid> record_of(const std::vector<PagePatch>& patches,
                                              const std::vector<ArtistsGrid>& records) {
    if (records.empty()) return {};
    const PageColors colors(patches);
    for (const ArtistsGrid& record : records)
      if (auto grid = record_of_page(record, patches, colors)) return grid;
    return {};
  }

  /// Throws where a document has more patches than a mesh may have: each takes its time.
  void check_size(std::size_t more) {
    const std::uint64_t most = limits().patches;
    patches_ += more;
    if (patches_ > most)
      throw InputError("the meshes so far have {0} patches, {1}", patches_,
                       beyond_limit("patches", most, patches_));
  }

  static void write(NewSvg& svg, const PageObject& object) {
    const auto& [page, id, shapes, mesh, patches, handles, stroke, blend_mode] = object;
    const WrittenForm form = exact_block_rules()->form(mesh, fit_frame(mesh, {}, usual_resolution));
    const MeshCounts counts = counts_of(form.surface);
    const MeshCounts before{handles, patches};
    const std::string label =
        (patches > counts.patches ? mesh_label(counts, before) : mesh_label(counts)).english();
    NewMesh made{id,
                 shapes.front(),
                 {shapes.rbegin(), shapes.rend() - 1},
                 {mesh, *form.blocks, label, before}};
    made.stroke = stroke;
    made.blend_mode = blend_mode;
    svg.add(page, made);
  }

  const PdfFile file_;
  KeptShadings kept_;
  const std::string name_;
  std::uint64_t patches_ = 0;
  std::vector<SvgPage> pages_;
  std::vector<PageObject> objects_;
  FoundPages found_;
};

}  // namespace

PagesAsSvg read_pdf(std::string_view bytes, const std::string& name, const PageChoice& choice) {
  return PdfReader(bytes, name, choice).run();
}

}  // namespace gradmesh
