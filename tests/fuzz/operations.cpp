#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "branch_meshes.h"
#include "choices.h"
#include "form/blocks.h"
#include "formats/svg/group/memory.h"
#include "mesh/region.h"
#include "mesh/subdivide.h"
#include "ops/color.h"
#include "ops/merge/merge.h"
#include "ops/merge/merge_faces.h"
#include "ops/merge/merge_region.h"
#include "ops/split/split.h"
#include "ops/split/split_line.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

MeshParts chosen_parts(Choices& choices) {
  switch (choices.byte() % 8) {
    case 0:
      return test::l_branch();
    case 1:
      return test::u_branch();
    case 2:
      return test::cross(1 + int(choices.byte() % 2));
    case 3:
      return test::ring(3 + int(choices.byte() % 5));
    default:
      break;
  }
  const unsigned size = choices.byte(), noise = choices.byte();
  std::mt19937 random(choices.byte());
  return test::grid_parts({.rows = 1 + int(size % 4),
                           .columns = 1 + int(size / 4 % 4),
                           .position_noise = noise % 8 / 10.0,
                           .color_noise = noise / 8 % 4 / 10.0,
                           .color_model = noise < 128 ? ColorModel::bilinear : ColorModel::bicubic},
                          random);
}

/// Splits only make meshes larger; from here on they are left out.
constexpr int many_faces = 40;

class Operations {
 public:
  Operations(Mesh& mesh, Choices& choices) : mesh_(mesh), choices_(choices), journal_(mesh) {}

  void next() {
    const unsigned byte = choices_.byte(), which = byte % 10;
    if (byte >= 250) return byte % 2 ? recolor_corner() : join_some_colors();
    const bool may_grow = mesh_.face_count() < many_faces;
    if (which < 4) return merge_edge();
    if (which == 4) return undo();
    if (which == 5) return merge_some_faces();
    if (which == 6) return merge_some_region();
    if (!may_grow) return;
    const Halfedge side = leaf();
    if (which == 7) split(journal_, side, choices_.share());
    if (which == 8) split_line(journal_, side, choices_.share());
    if (which == 9) split_line_across(journal_, side, choices_.share());
  }

  void undo_all() {
    while (journal_.depth() > 0) journal_.undo();
  }

 private:
  Face face() {
    const auto faces = mesh_.faces();
    return *std::next(faces.begin(), choices_.below(std::size_t(mesh_.face_count())));
  }
  Halfedge leaf() { return mesh_.sides(face())[choices_.byte() % 4]; }

  void merge_edge() {
    const Halfedge edge = leaf();
    if (can_merge(mesh_, edge) == MergeObstacle::none) merge(journal_, edge);
  }

  void merge_some_faces() {
    std::vector<Face> faces{face(), face(), face()};
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    merge_faces(journal_, faces);
  }

  void merge_some_region() {
    const unsigned shape = choices_.byte();
    const Region region{face(), int(shape % 4), 1 + int(shape / 4 % 4), 1 + int(shape / 16 % 4)};
    merge_region(journal_, region);
  }

  void recolor_corner() {
    const auto channel = [&] { return choices_.byte() / 255.0; };
    const Halfedge corner = leaf();
    const double r = channel(), g = channel();
    if (can_recolor(mesh_, corner)) recolor(journal_, corner, {r, g, channel(), 1});
  }

  void join_some_colors() { join_colors(journal_, mesh_.origin(leaf())); }

  void undo() {
    if (journal_.depth() > 0) journal_.undo();
  }

  Mesh& mesh_;
  Choices& choices_;
  Journal journal_;
};

Cubic<glm::dvec2> positions(const Cubic<Value>& curve) {
  return {curve.p0.position, curve.m0.position, curve.m1.position, curve.p1.position};
}

/// That each side of a patch, as the patch itself is painted, lies on the curve of the patches
/// across, and each stem starts on its bar's curve: there are no gaps, at T-junctions either.
void require_no_gaps(const Mesh& mesh) {
  for (const Face f : mesh.faces()) {
    const Patch patch = mesh.patch(f);
    const std::array<Halfedge, 4> sides = mesh.sides(f);
    for (int k = 0; k < 4; ++k) {
      const Halfedge side = sides[std::size_t(k)], across = mesh.other_side(side);
      if (!across.valid()) continue;
      const auto painted = positions(patch.side(k)), curve = positions(mesh.curve_of(across));
      const Interval span = mesh.span(side);
      const double size = glm::length(curve.p0) + glm::length(curve.m0) + glm::length(curve.m1) +
                          glm::length(curve.p1);
      // Two cubic curves that agree in four places agree.
      for (const double t : {0.0, 0.3, 0.7, 1.0}) {
        const double place = 1 - (span.first + t * span.length());
        require(glm::distance(painted.at(t), curve.at(place)) <= 1e-9 * size, "there are no gaps");
      }
    }
  }
}

/// What the writers make of such a mesh is the same mesh to the readers.
void require_writable(const Mesh& mesh) {
  must_accept(
      [&] {
        const auto remembered = recall(remember(mesh));
        require(remembered.has_value(), "what is remembered can be recalled");
        const Mesh recalled = build_mesh(*remembered);
        require_sound(recalled);
        require(recalled.face_count() == mesh.face_count(), "no patch is lost");
        if (mesh.color_model() == ColorModel::bilinear)
          require_sound(build_mesh(block_parts(mesh, block_form(mesh, 0.01))));
        require_sound(build_mesh(subdivided(mesh, 2)));
      },
      "what is written can be read");
}

}  // namespace

void check(std::string_view bytes) {
  Choices choices(bytes);
  const bool writes = choices.byte() % 8 == 0;
  const Mesh start = build_mesh(chosen_parts(choices));
  require_sound(start);
  Mesh mesh = start;
  Operations operations(mesh, choices);
  while (!choices.at_end()) {
    operations.next();
    require_sound(mesh);
    require_no_gaps(mesh);
  }
  if (writes) require_writable(mesh);
  operations.undo_all();
  require(mesh == start, "all undone, the mesh is what it was");
}

}  // namespace gradmesh::fuzz
