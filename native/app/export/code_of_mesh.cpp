#include "app/export/code_of_mesh.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/limits.h"
#include "form/blocks.h"
#include "form/written_patch.h"
#include "geom/few_points.h"
#include "mesh/boundary.h"
#include "mesh/rectangle.h"
#include "raster/overlaps.h"
#include "raster/picture.h"
#include "simplify/options.h"

namespace gradmesh {
namespace {

/// How far an outline may be from the shape, in the unit square: a tenth of a pixel of a thousand.
constexpr double outline_tolerance = 1e-4;

class CodeMaker {
 public:
  CodeMaker(const SvgDocument& document, const MeshEntry& entry)
      : mesh_(document.mesh(entry)),
        entry_(entry),
        place_(document.place(entry)),
        effects_(document.effects(entry)),
        to_page_(place_.to_page * place_.to_user),
        frame_(fit_frame(mesh_, to_page_, std::min(usual_resolution, int(limits().resolution)))) {
    const Box box = bounding_box(mesh_, to_page_);
    glm::dvec2 size = box.size();
    // A transform may leave no width, or no height.
    constexpr double thinnest = 1e-4;
    const double longer = std::max(size.x, size.y);
    size = {std::max(size.x, thinnest * longer), std::max(size.y, thinnest * longer)};
    to_unit_ = Affine::scaling(1.0 / size) * Affine::translation(-box.low()) * to_page_;
    made_.code.id = entry.id;
    made_.code.smooth = mesh_.is_smooth();
    made_.code.opacity = effects_.opacity;
    made_.code.aspect_ratio = size.x / size.y;
  }

  CodeOfMesh run() {
    add_grids();
    tell_of_patches();
    add_clips();
    tell_of_effects();
    return std::move(made_);
  }

 private:
  void lose(const Message& sentence) { made_.lost.push_back(sentence); }

  void add_grids() {
    const std::optional<Rectangle> grid = find_grid(mesh_);
    if (grid && (mesh_.is_smooth() || has_one_color_at_each_point(mesh_))) {
      made_.code.grids.push_back(grid_of(*grid));
      return;
    }
    const BlockForm form = block_form(mesh_, coons_tolerance(frame_), find_overlaps(mesh_, frame_));
    for (const Rectangle& block : form.blocks) made_.code.grids.push_back(grid_of(block));
    if (form.blocks.size() > 1)
      lose(
          Message("it is painted as {0} mesh gradients side by side, between which thin seams may "
                  "be seen.",
                  form.blocks.size()));
  }

  CodeGrid grid_of(const Rectangle& rectangle) const {
    const int rows = rectangle.rows, columns = rectangle.columns;
    CodeGrid grid{rows, columns, {}};
    grid.vertices.resize(std::size_t(rows + 1) * std::size_t(columns + 1));
    const auto vertex = [&](int row, int column) -> CodeVertex& {
      return grid.vertices[std::size_t(row * (columns + 1) + column)];
    };
    // The corners of a patch, clockwise from the top left, and where they are in the grid.
    constexpr std::array<std::pair<int, int>, 4> corners{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}};
    std::vector<Patch> patches;
    for (const Halfedge top : rectangle.tops) {
      Patch& patch = patches.emplace_back(mesh_.patch(top));
      transform(patch, to_unit_);
      const int number = int(patches.size()) - 1;
      for (int k = 0; k < 4; ++k) {
        CodeVertex& at =
            vertex(number / columns + corners[k].first, number % columns + corners[k].second);
        at.position = patch.corner(k).position;
        at.color = patch.corner(k).color;
        at.handles.fill(at.position);
      }
    }
    // By the number of a side: where the handles at its start and at its end lie.
    using enum HandleSide;
    constexpr std::array<std::pair<HandleSide, HandleSide>, 4> handles{
        {{right, left}, {bottom, top}, {left, right}, {top, bottom}}};
    for (std::size_t i = 0; i < patches.size(); ++i)
      for (int k = 0; k < 4; ++k) {
        const Cubic<Value> side = patches[i].side(k);
        const auto at = [&](int corner) -> CodeVertex& {
          return vertex(int(i) / columns + corners[corner].first,
                        int(i) % columns + corners[corner].second);
        };
        at(k).handle(handles[k].first) = side.bezier1().position;
        at((k + 1) % 4).handle(handles[k].second) = side.bezier2().position;
      }
    return grid;
  }

  void tell_of_patches() {
    int tensors = 0;
    for (const Face f : mesh_.faces())
      if (needs_tensor(mesh_.patch(f), coons_tolerance(frame_))) ++tensors;
    if (tensors > 0)
      lose(
          Message("{0} of its patches have inner points of their own, which such mesh gradients do "
                  "not hold.",
                  tensors));
    if (mesh_.is_smooth())
      lose(
          Message("its smooth colours follow another rule there, so that they differ a little "
                  "between the points."));
  }

  /// Returns true if a set of outlines hides more of the mesh than a margin of a pixel.
  bool hides_some(const std::vector<FilledOutline>& set) {
    if (!picture_) picture_ = picture_of(mesh_, frame_);
    return covers_beyond(*picture_, set, frame_);
  }

  void add_clips() {
    if (!place_.seen) return;
    for (const std::vector<FilledOutline>& set : place_.seen->sets) {
      if (!hides_some(set)) continue;
      if (set.size() > 1) {
        lose(Message("a clip path or mask of several shapes is left out."));
        continue;
      }
      FilledOutline clip = set.empty() ? FilledOutline{} : mapped(set.front(), to_unit_);
      for (std::vector<glm::dvec2>& polygon : clip.outline)
        polygon = with_few_points(polygon, outline_tolerance);
      std::erase_if(clip.outline, [](const auto& polygon) { return polygon.size() < 3; });
      made_.code.clips.push_back(std::move(clip));
    }
  }

  void tell_of_effects() {
    const bool strokes = entry_.role == PaintRole::stroke;
    if (strokes)
      lose(Message("all of the mesh is painted, not only the stroke."));
    else if (!entry_.simplified && !place_.fills_shape)
      lose(Message("all of the mesh is painted, not only the text."));
    if (effects_.has_other_paint)
      lose(strokes ? Message("the fill of the object is left out.")
                   : Message("the stroke of the object is left out."));
    const std::size_t known = place_.seen ? place_.seen->sets.size() : 0;
    if (effects_.masks > 0)
      lose(Message("a mask is left out; at most its outline is kept."));
    else if (std::size_t(effects_.clips) + (place_.fills_shape ? 1 : 0) > known)
      lose(Message("a clip path is left out."));
    if (effects_.has_filter) lose(Message("a filter is left out."));
    if (effects_.has_blend_mode) lose(Message("a blend mode is left out."));
  }

  const Mesh& mesh_;
  const MeshEntry entry_;
  const SvgDocument::Place place_;
  const ObjectEffects effects_;
  const Affine to_page_;
  const Frame frame_;
  Affine to_unit_;
  /// Painted when it is first needed.
  std::optional<MeshImage> picture_;
  CodeOfMesh made_;
};

}  // namespace

CodeOfMesh code_of_mesh(const SvgDocument& document, const MeshEntry& entry) {
  return CodeMaker(document, entry).run();
}

}  // namespace gradmesh
