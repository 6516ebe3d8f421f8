#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "form/reconcile.h"
#include "mesh/validate.h"
#include "same_mesh.h"
#include "written_blocks.h"

/// Meshes of 400 x 400 units, so that 0.006 units are within the rounding.
namespace gradmesh {
namespace {

using test::difference;

constexpr std::pair<int, int> corner_place[] = {{0, 0}, {0, 3}, {3, 3}, {3, 0}};

/// Moves one Bezier point of a patch.
void move(Patch& patch, std::pair<int, int> place, glm::dvec2 by) {
  BezierNet net = bezier_net(patch);
  net[place.first][place.second].position += by;
  patch = patch_from_bezier(net);
}

void recolor(Patch& patch, int corner, const glm::dvec4& color) {
  patch.c[corner_place[corner].first][corner_place[corner].second].color = color;
  make_color_bilinear(patch);
}

/// The place of the handle at the start of a side, or at its end.
std::pair<int, int> handle_place(int side, bool at_end) {
  const auto [i0, j0] = corner_place[side];
  const auto [i1, j1] = corner_place[(side + 1) % 4];
  return at_end ? std::pair((i0 + 2 * i1) / 3, (j0 + 2 * j1) / 3)
                : std::pair((2 * i0 + i1) / 3, (2 * j0 + j1) / 3);
}

glm::dvec2 point(const MeshParts& parts, Halfedge leaf, bool at_end = false) {
  return parts.patches[leaf.value / 4].corner((leaf.value + (at_end ? 1 : 0)) % 4).position;
}
glm::dvec2 handle(const MeshParts& parts, Halfedge leaf, bool at_end) {
  const auto [i, j] = handle_place(leaf.value % 4, at_end);
  return bezier_net(parts.patches[leaf.value / 4])[i][j].position;
}

void expect_sound(const Reconciled& result) {
  const Mesh mesh = build_mesh(result.parts);
  ASSERT_EQ(validate(mesh), std::vector<std::string>{});
  // Patches that share a curve have the same curve: what is returned has no gaps.
  for (const Face f : mesh.faces())
    EXPECT_LE(difference(mesh.patch(f), result.parts.patches[f.value]), 1e-9);
}

/// Random points and handles of random patches are moved; copies in other patches are not.
MeshParts edited_at_random(const MeshParts& written, std::mt19937& random) {
  MeshParts read = written;
  std::uniform_real_distribution<double> shift(-12, 12);
  for (int i = 0; i < 4; ++i) {
    Patch& patch = read.patches[random() % read.patches.size()];
    const int side = int(random() % 4);
    const glm::dvec2 by{shift(random), shift(random)};
    switch (random() % 3) {
      case 0:
        move(patch, corner_place[side], by);
        break;
      case 1:
        move(patch, handle_place(side, random() % 2 == 0), by);
        break;
      default:  // As Inkscape moves a corner.
        move(patch, corner_place[side], by);
        move(patch, handle_place(side, false), by);
        move(patch, handle_place((side + 3) % 4, true), by);
    }
  }
  return read;
}

/// Checks points that are no T-junctions: those that moved are where they were put, all others
/// where they were.
int check_points(const Mesh& before, const MeshParts& written, const MeshParts& read,
                 const Mesh& after) {
  std::map<Point, std::pair<double, glm::dvec2>> put;
  for (const Halfedge h : before.halfedges()) {
    if (!before.is_leaf(h)) continue;
    const double moved = glm::distance(point(read, h), point(written, h));
    auto& [most, place] = put[before.origin(h)];
    if (moved > most) std::tie(most, place) = std::pair(moved, point(read, h));
  }
  int moved = 0;
  for (const auto& [p, farthest] : put) {
    if (before[p].is_junction()) continue;
    const bool was_moved = farthest.first > 0.01;
    moved += was_moved;
    EXPECT_EQ(after.position(p), was_moved ? farthest.second : before.position(p));
  }
  return moved;
}

/// The same for handles there, of curves with one patch along each side.
int check_handles(const Mesh& before, const MeshParts& written, const MeshParts& read,
                  const Mesh& after) {
  int moved = 0;
  for (const Halfedge h : before.halfedges()) {
    if (!before.is_leaf(h) || before.is_bar(h) || before[before.origin(h)].is_junction()) continue;
    const Halfedge twin = before[h].twin;
    if (twin.valid() && before.is_parent(twin)) continue;
    double most = 0.01;
    std::optional<glm::dvec2> put;
    bool untouched = true;
    for (const bool other : {false, true}) {
      const Halfedge leaf = other ? twin : h;
      if (!leaf.valid()) continue;
      const glm::dvec2 now = handle(read, leaf, other);
      const double distance = glm::distance(now, handle(written, leaf, other));
      untouched =
          untouched && distance < 1e-9 && point(read, leaf, other) == point(written, leaf, other);
      if (distance > most) std::tie(most, put) = std::pair(distance, std::optional(now));
    }
    const Cubic<Value> curve = after.curve_of(h);
    if (put) {
      ++moved;
      EXPECT_LE(glm::distance(curve.bezier1().position, *put), 1e-9);
    } else if (untouched) {
      EXPECT_LE(glm::distance(curve.m0.position, before.curve_of(h).m0.position), 1e-9);
    }
  }
  return moved;
}

TEST(Reconcile, random_points_in_random_copies) {
  int points = 0, handles = 0;
  std::size_t junctions = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const MeshParts written = test::written_parts(seed);
    std::mt19937 random(seed);
    const MeshParts read = edited_at_random(written, random);
    const Reconciled result = reconcile(read, written);
    EXPECT_TRUE(result.edited);
    SCOPED_TRACE(seed);
    expect_sound(result);
    const Mesh before = build_mesh(written), after = build_mesh(result.parts);
    points += check_points(before, written, read, after);
    handles += check_handles(before, written, read, after);
    junctions += test::junctions(after);
    // It is the mesh as a person wants it now, and nothing is left to mend.
    const Reconciled again = reconcile(result.parts, result.parts);
    EXPECT_FALSE(again.edited);
    EXPECT_EQ(again.parts.patches, result.parts.patches);
  }
  EXPECT_GT(points, 100);
  EXPECT_GT(handles, 100);
  EXPECT_GT(junctions, 300u);
}

TEST(Reconcile, rounding_is_no_edit) {
  const MeshParts written = test::written_parts(1);
  for (const double size : {0.001, 0.1}) {
    MeshParts read = written;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> shift(-size, size);
    for (Patch& patch : read.patches)
      for (auto& row : patch.c)
        for (Value& v : row) v.position += glm::dvec2{shift(random), shift(random)};
    const Reconciled result = reconcile(read, written);
    EXPECT_EQ(result.edited, size > 0.01);
    EXPECT_EQ(result.parts.patches == read.patches, size < 0.01);
  }
}

/// Two rows: one patch above, two below, of which the first is 60 wide.
///     0 --------- 100        corners' colours: top 0 and 0.4, middle 0.2 and 0.6, bottom as there
///     |     0     |
///    100 --+----- +
///     |  1 |  2   |
///     +----+------+ 200
class Hanging : public ::testing::Test {
 protected:
  Hanging() {
    const auto value = [](double x, double y) {
      return Value{{x, y}, {(y / 500) + (x / 100) * 0.4, 0.5, 0.5, 1}};
    };
    const auto box = [&](double x0, double y0, double x1, double y1) {
      return test::straight_patch({value(x0, y0), value(x1, y0), value(x1, y1), value(x0, y1)});
    };
    written.patches = {box(0, 0, 100, 100), box(0, 100, 60, 200), box(60, 100, 100, 200)};
    // Side 2 of patch 0 runs from right to left, so the other side is broken at 0.6 of its own.
    written.curves = {{{{2}, {}}, {{4, 8}, {0.6}}}, {{{5}, {}}, {{11}, {}}}};
    read = written;
  }

  Mesh mended() {
    const Reconciled result = reconcile(read, written);
    EXPECT_TRUE(result.edited);
    expect_sound(result);
    return build_mesh(result.parts);
  }
  static glm::dvec2 junction(const Mesh& mesh) { return mesh.position(mesh.origin(Halfedge{8})); }

  MeshParts written, read;
};

TEST_F(Hanging, junction_follows_the_long_curve) {
  move(read.patches[0], {3, 1}, {0, 30});
  move(read.patches[0], {3, 2}, {0, 30});
  const Mesh mesh = mended();
  // 3 s^2 t + 3 s t^2 of 30 at t = 0.6.
  EXPECT_NEAR(junction(mesh).x, 60, 1e-9);
  EXPECT_NEAR(junction(mesh).y, 100 + 3 * 0.6 * 0.4 * 30, 1e-9);
  // Below it has moved along, as a patch of straight opposite sides does.
  EXPECT_NEAR(mesh.curve_of(Halfedge{11}).bezier2().position.y, junction(mesh).y + 100.0 / 3, 1e-9);
  EXPECT_EQ(mesh.position(mesh.origin(Halfedge{6})), glm::dvec2(60, 200));
}

TEST_F(Hanging, a_junction_slides_along_the_curve) {
  for (const int patch : {1, 2}) {
    move(read.patches[patch], corner_place[patch == 1 ? 1 : 0], {-20, 5});
    const Mesh mesh = mended();
    EXPECT_NEAR(junction(mesh).x, 40, 1e-6);
    EXPECT_NEAR(junction(mesh).y, 100, 1e-9);
    EXPECT_NEAR(mesh.span(Halfedge{8}).first, 0.4, 1e-8);
    // Its colours are those of the long curve there.
    EXPECT_NEAR(mesh[Halfedge{8}].color.r, 0.2 + 0.4 * 0.4, 1e-9);
    EXPECT_FALSE(mesh[Halfedge{8}].own_color);
    read = written;
  }
}

TEST_F(Hanging, a_junction_stays_between_its_neighbours) {
  move(read.patches[2], corner_place[0], {500, 0});
  const Mesh mesh = mended();
  EXPECT_GT(junction(mesh).x, 60);
  EXPECT_LT(junction(mesh).x, 100);
}

TEST_F(Hanging, the_long_curve_wins_over_its_parts) {
  move(read.patches[1], handle_place(0, true), {0, 20});
  const Mesh mesh = mended();
  EXPECT_EQ(mesh.curve_of(Halfedge{2}), build_mesh(written).curve_of(Halfedge{2}));
}

TEST_F(Hanging, handles_of_a_stem_follow_the_junction) {
  move(read.patches[0], {3, 0}, {0, 30});
  move(read.patches[0], {3, 3}, {0, 30});
  move(read.patches[0], {3, 1}, {0, 30});
  move(read.patches[0], {3, 2}, {0, 30});
  // The first third, which the person has turned beside it.
  move(read.patches[1], handle_place(1, false), {7, 0});
  const Mesh mesh = mended();
  EXPECT_NEAR(junction(mesh).y, 130, 1e-9);
  const glm::dvec2 handle = mesh.curve_of(Halfedge{5}).bezier1().position;
  EXPECT_NEAR(handle.x, 67, 1e-9);
  EXPECT_NEAR(handle.y, 130 + 100.0 / 3, 1e-9);
}

TEST_F(Hanging, colours_that_were_one_are_one) {
  const glm::dvec4 reddish(0.9, 0.1, 0.1, 1);
  recolor(read.patches[1], 0, reddish);
  const Mesh mesh = mended();
  // The corner at (0, 100) in both patches; and on the long curve the junction's colour follows.
  EXPECT_EQ(mesh[Halfedge{3}].color, reddish);
  EXPECT_EQ(mesh[Halfedge{4}].color, reddish);
  for (const int h : {5, 8}) {
    EXPECT_FALSE(mesh[Halfedge{h}].own_color);
    EXPECT_NEAR(mesh[Halfedge{h}].color.r, 0.4 * 0.9 + 0.6 * 0.6, 1e-9);
  }
}

TEST_F(Hanging, a_step_in_colour_stays) {
  recolor(written.patches[1], 0, {0, 0, 0, 1});
  read = written;
  const glm::dvec4 reddish(0.9, 0.1, 0.1, 1);
  recolor(read.patches[1], 0, reddish);
  const Mesh mesh = mended();
  EXPECT_EQ(mesh[Halfedge{4}].color, reddish);
  EXPECT_EQ(mesh[Halfedge{3}].color, written.patches[0].corner(3).color);
}

TEST_F(Hanging, a_junction_can_be_given_a_colour) {
  const glm::dvec4 reddish(0.9, 0.1, 0.1, 1);
  recolor(read.patches[2], 0, reddish);
  const Mesh mesh = mended();
  for (const int h : {5, 8}) EXPECT_EQ(mesh[Halfedge{h}].color, reddish);
}

TEST_F(Hanging, a_coons_patch_stays_one) {
  move(read.patches[0], corner_place[2], {10, 10});
  make_coons(read.patches[0]);
  const Reconciled result = reconcile(read, written);
  for (const Patch& patch : result.parts.patches) EXPECT_FALSE(needs_tensor(patch, 1e-9));
}

TEST_F(Hanging, a_tensor_stays_too) {
  move(written.patches[2], {1, 1}, {3, 3});
  read = written;
  move(read.patches[2], corner_place[2], {10, 10});
  move(read.patches[2], {2, 1}, {-4, 1});
  const Reconciled result = reconcile(read, written);
  const BezierNet net = bezier_net(result.parts.patches[2]), put = bezier_net(read.patches[2]);
  for (const auto& [i, j] : {std::pair(1, 1), std::pair(2, 1)})
    EXPECT_LE(glm::distance(net[i][j].position, put[i][j].position), 1e-9);
}

TEST_F(Hanging, a_block_moved_as_a_whole_takes_its_corners_along) {
  transform(read.patches[2], Affine::translation({25, 15}));
  const Mesh mesh = mended();
  EXPECT_EQ(mesh.position(mesh.origin(Halfedge{9})), glm::dvec2(125, 115));
  EXPECT_EQ(mesh.position(mesh.origin(Halfedge{6})), glm::dvec2(85, 215));
  EXPECT_EQ(mesh.position(mesh.origin(Halfedge{2})), glm::dvec2(125, 115));
}

TEST_F(Hanging, all_moved_together_need_no_mending) {
  const Affine turned{glm::dmat2(0, 2, -2, 0), {10, 20}};
  for (Patch& patch : read.patches) transform(patch, turned);
  const Reconciled result = reconcile(read, written);
  EXPECT_TRUE(result.edited);
  for (std::size_t f = 0; f < read.patches.size(); ++f)
    EXPECT_LE(difference(read.patches[f], result.parts.patches[f]), 1e-9);
}

TEST_F(Hanging, without_memory_a_copy_beside_the_first_counts_as_moved) {
  move(read.patches[1], corner_place[0], {4, 4});
  const Reconciled result = reconcile(read);
  EXPECT_TRUE(result.edited);
  expect_sound(result);
  EXPECT_EQ(result.parts.patches[0].corner(3).position, glm::dvec2(4, 104));
  const Reconciled sound = reconcile(written);
  EXPECT_FALSE(sound.edited);
  EXPECT_EQ(sound.parts.patches, written.patches);
}

}  // namespace
}  // namespace gradmesh
