#include "formats/pdf/grid/mesh_forms.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "formats/pdf/grid/joined_halves.h"
#include "formats/pdf/grid/page_grids.h"
#include "formats/pdf/grid/page_mesh.h"
#include "formats/pdf/grid/paired_triangles.h"
#include "formats/pdf/grid/refined_grid.h"
#include "formats/pdf/grid/smooth_grid.h"
#include "formats/pdf/grid/without_anchors.h"

namespace gradmesh {
namespace {

/// Points that are closer than this, in points of a page, are one: programs round to 1/2048, and
/// middles of sides are off by several times as much. Of patches that make no grid the smallest may
/// be narrower than that.
constexpr double grid_tolerance = 0.02, mesh_tolerance = 0.005;

/// Returns patches with colours as a document holds them.
std::vector<PagePatch> rounded_colors(std::vector<PagePatch> patches) {
  for (PagePatch& patch : patches)
    for (glm::dvec4& color : patch.colors)
      for (int channel = 0; channel < 3; ++channel)
        color[channel] = std::round(255 * color[channel]) / 255;
  return patches;
}

/// Returns the patches as one grid; nothing if they are none.
std::optional<ArtistsGrid> one_grid(const std::vector<PagePatch>& patches) {
  const PatchSides sides(patches, grid_tolerance);
  const std::vector<PageGrid> grids = page_grids(sides);
  return grids.size() == 1 ? std::optional(as_it_is(grids.front(), sides)) : std::nullopt;
}

PatchGrid patches_of(const ArtistsGrid& grid) {
  PatchGrid patches{grid.rows, grid.columns, {}};
  for (const PagePatch& page : grid.patches) patches.patches.push_back(mesh_patch(page));
  return patches;
}

MeshForm form_of(const PatchGrid& grid, MeshForm::Kind kind, bool is_smooth = false) {
  MeshForm form{parts_of({grid}), kind};
  form.mesh.smooth = is_smooth;
  return form;
}

/// Returns the grid, and before it the one with smooth colours as which Inkscape has painted it.
std::vector<MeshForm> forms_of_grid(const ArtistsGrid& grid) {
  std::vector<MeshForm> forms;
  if (const std::optional<ArtistsGrid> smooth = smooth_grid(grid))
    forms.push_back(form_of(patches_of(*smooth), MeshForm::Kind::artists, true));
  forms.push_back(form_of(patches_of(grid), MeshForm::Kind::page));
  return forms;
}

/// Gives the artist's grid with smooth colours, with more and more rows and columns, as long as it
/// has at most half as many patches as the page, beyond which what is on the page is as good, and
/// behind the first one that with bilinear colours.
class FinerGrids {
 public:
  FinerGrids(PatchGrid artists, MeshForm::Kind kind, const PageColors& colors, std::size_t on_page)
      : artists_(std::move(artists)), kind_(kind), colors_(&colors), on_page_(on_page) {}

  std::optional<MeshForm> operator()() {
    switch (given_++) {
      case 0:
        return form_of(artists_, kind_, true);
      case 1:
        return form_of(artists_, MeshForm::Kind::joined);
      default:
        break;
    }
    if (!refined_) refined_.emplace(artists_, *colors_);
    if (refined_->divide() && 2 * std::size_t(refined_->rows() * refined_->columns()) <= on_page_)
      return form_of(refined_->grid(), kind_, true);
    return {};
  }

 private:
  PatchGrid artists_;
  MeshForm::Kind kind_;
  const PageColors* colors_;
  std::size_t on_page_;
  std::size_t given_ = 0;
  std::optional<RefinedGrid> refined_;
};

}  // namespace

MeshParts loose_mesh(const std::vector<PagePatch>& patches) {
  MeshParts mesh;
  for (const PagePatch& patch : patches) mesh.patches.push_back(mesh_patch(patch));
  return mesh;
}

void MeshForms::add_grids(const ArtistsGrid& artists, MeshForm::Kind kind) {
  grids_.push_back({{}, FinerGrids(patches_of(artists), kind, *colors_, patches_of_page_)});
}

MeshForms::MeshForms(std::vector<MeshForm> forms) : others_(std::move(forms)) {}

MeshForms::MeshForms(const std::vector<ShadingPatch>& own, const std::vector<PagePatch>& page,
                     const CornerColors& corners, const std::optional<ArtistsGrid>& record)
    : patches_of_page_(page.size()), colors_(std::make_unique<PageColors>(page)) {
  const auto colored = [&](const std::vector<ShadingPatch>& patches) {
    std::vector<PagePatch> all = corners(patches);
    for (PagePatch& patch : all)
      for (std::size_t k = 0; k < 4; ++k) patch.colors[k].a = colors_->at(patch.outer[3 * k]).a;
    return rounded_colors(std::move(all));
  };
  const std::vector<PagePatch> all = rounded_colors(page);
  const bool is_as_painted = own.size() == page.size();
  if (record) {
    ArtistsGrid drawn = *record;
    drawn.patches = rounded_colors(std::move(drawn.patches));
    add_grids(drawn, MeshForm::Kind::record);
  }
  if (const std::optional<ArtistsGrid> grid = one_grid(is_as_painted ? all : colored(own))) {
    // Halves of what is one grid already are the artist's own.
    if (is_as_painted) {
      grids_.clear();
      others_ = forms_of_grid(*grid);
      return;
    }
    add_grids(*grid, MeshForm::Kind::joined);
  } else if (const std::vector<ShadingPatch> whole = without_halving(own);
             whole.size() < own.size()) {
    const std::vector<PagePatch> joined = without_anchors(colored(whole), grid_tolerance).patches;
    if (const std::optional<ArtistsGrid> artists = one_grid(joined))
      add_grids(*artists, MeshForm::Kind::artists);
    else
      others_.push_back({page_mesh(joined, mesh_tolerance), MeshForm::Kind::joined});
  }
  if (const std::vector<ShadingPatch> pairs = paired_triangles(own); pairs.size() < own.size()) {
    const std::vector<PagePatch> joined = colored(pairs);
    if (const std::optional<ArtistsGrid> grid = one_grid(joined))
      grids_.push_back({form_of(patches_of(*grid), MeshForm::Kind::joined), nullptr});
    else
      others_.push_back({page_mesh(joined, mesh_tolerance), MeshForm::Kind::joined});
  }
  others_.push_back({page_mesh(all, mesh_tolerance)});
}

std::optional<MeshForm> MeshForms::next() {
  // A record and what the page shows may take different numbers of lines to the same look.
  Grids* coarsest = nullptr;
  for (Grids& grids : grids_) {
    if (!grids.next && grids.finer) grids.next = grids.finer();
    if (!grids.next) grids.finer = nullptr;
    if (grids.next &&
        (!coarsest || grids.next->mesh.patches.size() < coarsest->next->mesh.patches.size()))
      coarsest = &grids;
  }
  if (coarsest) return std::exchange(coarsest->next, std::nullopt);
  return passed_ < others_.size() ? std::optional(others_[passed_++]) : std::nullopt;
}

}  // namespace gradmesh
