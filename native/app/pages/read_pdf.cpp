#include "app/pages/read_pdf.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "app/pages/page_form.h"
#include "app/pages/page_shapes.h"
#include "app/pages/page_tiles.h"
#include "base/clamped_int.h"
#include "base/limits.h"
#include "formats/pdf/page/pdf_file.h"
#include "formats/pdf/records/mesh_records.h"
#include "formats/pdf/records/record_of_page.h"
#include "mesh/boundary.h"
#include "mesh/rectangle.h"

namespace gradmesh {
namespace {

/// A surface that folds over itself may have one part more for so many tiles.
constexpr std::size_t tiles_of_part = 8;

/// How many shadings, painted alike one after another, are told about where they make no surface:
/// of fewer each may be drawn for itself.
constexpr std::size_t many_tiles = 64;

class PdfReader {
 public:
  PdfReader(std::string_view bytes, const std::string& name, const PageChoice& choice)
      : file_(std::string(bytes), name, choice.password),
        all_layers_(choice.all_layers),
        name_(name),
        tell_(choice.progress) {
    const auto count = file_.page_count();
    if (choice.page && (*choice.page < 1 || std::size_t(*choice.page) > count))
      throw InputError("{0}: there is no page {1}; it has {2}.", name, *choice.page, count);
    const std::size_t first = choice.page ? std::size_t(*choice.page) - 1 : 0;
    now_.meshes = choice.page ? 1 : count;
    for (; now_.mesh < now_.meshes && goes_on(); ++now_.mesh) {
      read_page(first + now_.mesh);
      now_.done = now_.total = 0;
    }
  }

  PageMeshes run() && {
    if (first_left_out_)
      found_.left_out.push_back(Message(
          "{0}: from mesh {1} of page {2} on they are left out: all meshes together have {3} "
          "patches, {4}.",
          name_, first_left_out_->second, first_left_out_->first, patches_,
          beyond_limit("patches", limits().patches, patches_)));
    if (objects_.empty() && !found_.is_stopped) {
      if (!found_.left_out.empty()) throw InputError(found_.left_out.front());
      throw InputError("{0}: there is no gradient mesh on its pages.", name_);
    }
    return {std::move(pages_), std::move(objects_), std::move(found_)};
  }

 private:
  /// Tells how far it is. Returns false where it is to end, now and ever after.
  bool goes_on() {
    found_.is_stopped = found_.is_stopped || (tell_ && !tell_(now_));
    return !found_.is_stopped;
  }

  template <class Work>
  auto naming_page(std::size_t number, const Work& work) const {
    try {
      return work();
    } catch (const InputError& error) {
      throw InputError("{0}, page {1}: {2}.", name_, number + 1, error.message());
    }
  }

  void read_page(std::size_t number) {
    const PageContent page = naming_page(number, [&] { return file_.page(number, all_layers_); });
    if (page.is_damaged)
      found_.left_out.push_back(Message(
          "{0}, page {1}: it is damaged; what lies behind that is left out.", name_, number + 1));
    if (page.hidden > 0)
      found_.left_out.push_back(
          Message("{0}, page {1}: layers that are off are left out, with {2} of its meshes; the "
                  "option for all layers (--all-layers) reads them.",
                  name_, number + 1, page.hidden));
    const std::vector<ArtistsGrid> records = read_mesh_records(page.private_data);
    const std::size_t before = objects_.size();
    PageTiles tiles;
    now_.total = page.painted.size();
    for (std::size_t n = 0; n < page.painted.size() && goes_on(); ++n) {
      auto shading = try_mesh(number, n, [&] { return shown(page.painted[n], n); });
      if (!shading || !has_room_for(*shading, number) || tiles.take(*shading)) continue;
      add_tiles(tiles, records, number);
      tiles = PageTiles();
      tiles.take(*shading);
    }
    add_tiles(tiles, records, number);
    if (objects_.size() == before) return;
    pages_.push_back({pixels_per_point * page.size.x, pixels_per_point * page.size.y,
                      page_name(number + 1).english(), int(number + 1)});
  }

  /// Returns what is made of mesh `number` of a page; nothing, and tells why, if it cannot be.
  template <class Work>
  auto try_mesh(std::size_t page, std::size_t number, const Work& work)
      -> std::optional<decltype(work())> try {
    return work();
  } catch (const InputError& error) {
    if (const auto* const large = dynamic_cast<const TooManyPatches*>(&error))
      patches_ += large->count;
    found_.left_out.push_back(
        Message("{0}, page {1}, mesh {2}: {3}.", name_, page + 1, number + 1, error.message()));
    return {};
  }

  ShadingOnPage shown(const PaintedShading& painted, std::size_t number) {
    ShadingOnPage shading{number, painted, painted_patches(painted, kept_)};
    if (shading.shown.shading.patches.empty()) throw InputError("it has no patches");
    return shading;
  }

  /// Adds shadings that follow one another, as few meshes where they are tiles of surfaces.
  void add_tiles(const PageTiles& tiles, const std::vector<ArtistsGrid>& records,
                 std::size_t page) {
    for (const PageTiles::Span surface : tiles.surfaces()) {
      const std::size_t before = objects_.size();
      add_tiles(tiles, surface, records, page);
      const std::size_t made = objects_.size() - before;
      if (surface.end - surface.begin >= many_tiles && made > 1 && !found_.is_stopped)
        found_.left_out.push_back(
            Message("{0}, page {1}, meshes {2} to {3}: they join to no one surface that looks the "
                    "same, so they are {4} meshes.",
                    name_, page + 1, tiles.shadings()[surface.begin].number + 1,
                    tiles.shadings()[surface.end - 1].number + 1, made));
    }
  }

  /// Adds some of them: where they are no surface their halves may be, since what is painted later
  /// may lie on top.
  void add_tiles(const PageTiles& tiles, PageTiles::Span span,
                 const std::vector<ArtistsGrid>& records, std::size_t page) {
    const auto& [begin, end] = span;
    now_.done = tiles.shadings()[begin].number;
    if (!goes_on()) return;
    if (const auto surface = tiles.surface(span)) {
      if (add_surface(*surface, end - begin, page)) return;
      const std::size_t middle = begin + (end - begin) / 2;
      add_tiles(tiles, {begin, middle}, records, page);
      add_tiles(tiles, {middle, end}, records, page);
      return;
    }
    for (const ShadingOnPage& each : std::span(tiles.shadings()).subspan(begin, end - begin)) {
      now_.done = each.number;
      if (!goes_on()) return;
      try_mesh(page, each.number, [&] {
        const auto& patches = each.shown.patches;
        auto chosen = choose(patches, forms_of(each.shown, record_of(patches, records)));
        if (chosen) add(each, std::move(*chosen), page, 1);
        return true;
      });
    }
  }

  /// Adds the surface of so many tiles, if they join to few parts and these look as they do.
  bool add_surface(const ShadingOnPage& surface, std::size_t tiles, std::size_t page) try {
    if (surface.shown.patches.size() > limits().patches) return false;
    auto chosen = choose(surface.shown.patches, forms_of(surface.shown, {}));
    if (!chosen || chosen->difference > look_of_page ||
        parts_of(chosen->mesh) > 1 + tiles / tiles_of_part)
      return false;
    add(surface, std::move(*chosen), page, tiles);
    return true;
  } catch (const InputError&) {
    return false;
  }

  static std::size_t parts_of(const Mesh& mesh) {
    return std::size_t(1 + std::ranges::max(face_components(mesh)));
  }

  /// Returns nothing where it is to end.
  std::optional<ChosenForm> choose(const std::vector<PagePatch>& patches, MeshForms forms) {
    return choose_form(patches, std::move(forms), [this] { return goes_on(); });
  }

  static MeshForms forms_of(const PaintedPatches& shown, const std::optional<ArtistsGrid>& record) {
    const auto corners = [&shown](const std::vector<ShadingPatch>& patches) {
      return corners_in_srgb(patches, shown.shading.colors);
    };
    return MeshForms(shown.shading.patches, shown.patches, corners, record);
  }

  /// Adds the mesh that stands for a shading of a page, or for several from that one on.
  void add(const ShadingOnPage& shading, ChosenForm chosen, std::size_t page,
           std::size_t shadings) {
    const auto& [number, painted, shown] = shading;
    Clips clips = shown.mask_clips;
    clips.insert(clips.end(), painted.clips.begin(), painted.clips.end());
    std::vector<SvgShape> shapes = shapes_of(chosen.mesh, clips, painted.stroke.get());
    if (shapes.empty()) throw InputError("its clip path hides it");
    if (shown.mask_left_out)
      found_.left_out.push_back(
          Message("{0}, page {1}, mesh {2}: a mask through which it is seen is left out.", name_,
                  page + 1, number + 1));
    if (painted.has_text_boxes)
      found_.left_out.push_back(Message(
          "{0}, page {1}, mesh {2}: it is seen through text whose letters the document does "
          "not hold, so that boxes stand for them.",
          name_, page + 1, number + 1));
    const auto is_as_in_svg = [](const PageGroup* group) {
      while (group && group->is_as_in_svg) group = group->around.get();
      return !group;
    };
    if (!is_as_in_svg(painted.group.get()))
      found_.left_out.push_back(
          Message("{0}, page {1}, mesh {2}: it lies in a group whose colours are mixed in a way "
                  "that SVG does not have.",
                  name_, page + 1, number + 1));
    if (painted.is_repeated)
      found_.left_out.push_back(
          Message("{0}, page {1}, mesh {2}: a pattern repeats it; it is read once.", name_,
                  page + 1, number + 1));
    if (shown.shading.is_damaged)
      found_.left_out.push_back(
          Message("{0}, page {1}, mesh {2}: it is damaged; patches of it are left out.", name_,
                  page + 1, number + 1));
    const std::string id =
        "page-" + std::to_string(page + 1) + "-mesh-" + std::to_string(number + 1);
    const int patches = int(shown.shading.patches.size());
    FoundMesh& found = found_.meshes.emplace_back();
    found = {id, int(page + 1), int(number + 1), shown.shading.type, patches};
    if (const auto grid = find_grid(chosen.mesh))
      std::tie(found.rows, found.columns) = std::pair(grid->rows, grid->columns);
    found.shadings = int(shadings);
    found.is_joined = shadings > 1 || chosen.kind != MeshForm::Kind::page;
    found.is_from_record = chosen.kind == MeshForm::Kind::record;
    found.is_smooth = chosen.mesh.is_smooth();
    found.difference = chosen.difference;
    found.handles = chosen.page_handles;
    std::optional<SvgStroke> stroke;
    if (painted.stroke) stroke = svg_stroke(painted.stroke->line);
    objects_.push_back({pages_.size(), id, std::move(shapes), std::move(chosen.mesh), patches,
                        chosen.page_handles, std::move(stroke), painted.blend_mode});
    if (painted.stroke) objects_.back().to_page = painted.stroke->pen;
    objects_.back().groups = svg_groups(painted.group);
  }

  /// Returns the groups of SVG that a group of a page and those around it become.
  std::vector<std::shared_ptr<const SvgGroup>> svg_groups(
      const std::shared_ptr<const PageGroup>& innermost) {
    std::vector<std::shared_ptr<const SvgGroup>> groups;
    for (auto group = innermost; group; group = group->around) {
      std::shared_ptr<const SvgGroup>& made = groups_[group];
      if (!made)
        made = std::make_shared<const SvgGroup>(
            SvgGroup{group->opacity, group->blend_mode, group->is_isolated});
      groups.insert(groups.begin(), made);
    }
    return groups;
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

  /// Counts a mesh. Returns false where the document has more patches than a mesh may have, each of
  /// which takes its time: from there on they are counted alone, for the sentence about them.
  bool has_room_for(const ShadingOnPage& shading, std::size_t page) {
    patches_ += shading.shown.shading.patches.size();
    now_.patches = clamped_int(double(patches_), 0, std::numeric_limits<int>::max());
    if (patches_ > limits().patches && !first_left_out_)
      first_left_out_ = std::pair(page + 1, shading.number + 1);
    return !first_left_out_;
  }

  const PdfFile file_;
  const bool all_layers_;
  KeptShadings kept_;
  const std::string name_;
  const ProgressCallback tell_;
  Progress now_;
  std::uint64_t patches_ = 0;
  /// The numbers of a page and of its mesh, from which on there are too many.
  std::optional<std::pair<std::size_t, std::size_t>> first_left_out_;
  std::vector<SvgPage> pages_;
  std::vector<PageObject> objects_;
  std::map<std::shared_ptr<const PageGroup>, std::shared_ptr<const SvgGroup>> groups_;
  FoundPages found_;
};

}  // namespace

PageMeshes read_pdf(std::string_view bytes, const std::string& name, const PageChoice& choice) {
  return PdfReader(bytes, name, choice).run();
}

}  // namespace gradmesh
