#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <sstream>

#include "base/error.h"
#include "formats/hemesh/hemesh.h"
#include "formats/hemesh/hemesh_file.h"
#include "mesh/validate.h"
#include "meshes.h"
#include "random_meshes.h"
#include "same_mesh.h"

namespace gradmesh {
namespace {

using test::difference;
using test::junctions;
using test::leaves_of_faces;
using test::same;

Mesh read(const std::string& text) { return build_mesh(read_hemesh(text, "test.hemesh")); }

/// A grid with colour tangents and twists of its own and, at random corners, sharp colours.
MeshParts bicubic_parts(unsigned seed, int rows = 4, int columns = 4) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  MeshParts parts = test::grid_parts({.rows = rows,
                                      .columns = columns,
                                      .position_noise = 0.1,
                                      .color_noise = 0.2,
                                      .color_model = ColorModel::bicubic},
                                     random);
  for (Patch& patch : parts.patches)
    for (auto& row : patch.c)
      for (Value& v : row)
        if (random() % 8 == 0)
          for (int channel = 0; channel < 3; ++channel) v.color[channel] += 0.3 * unit(random);
  return parts;
}

/// A mesh with T-junctions, of which the format can hold all.
Mesh writable_mesh(unsigned seed, int steps) {
  return test::without_own_tangents(test::changed_mesh(bicubic_parts(seed), seed, steps, 2));
}

TEST(Hemesh, is_read_back_the_same_bit_for_bit) {
  std::size_t nested = 0, own = 0, dead = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Mesh mesh = writable_mesh(seed, int(seed % 60));
    const std::string text = write_hemesh(mesh);
    const Mesh again = read(text);
    ASSERT_EQ(validate(again), std::vector<std::string>{}) << "seed " << seed;
    ASSERT_TRUE(same(mesh, again)) << "seed " << seed;
    ASSERT_EQ(write_hemesh(again), text) << "seed " << seed;
    for (const Halfedge h : mesh.halfedges()) {
      nested += mesh.is_stem(h) && mesh.is_parent(h);
      own += mesh.is_leaf(h) && mesh[mesh.origin(h)].is_junction() && mesh[h].own_color;
    }
    dead += mesh.face_slots() - std::size_t(mesh.face_count());
  }
  EXPECT_GT(nested, 100u);
  EXPECT_GT(dead, 1000u);
  EXPECT_GT(own, 100u);
}

/// Patch 0 above, patches 1 and 2 below, which meet at a T-junction at 0.25 of patch 0's bottom.
MeshParts junction_parts() {
  const auto corner = [](double x, double y) {
    return Value{{x, y}, {0.1 + 0.1 * x, 0.2 + 0.3 * y, 0.5, 1}};
  };
  const auto box = [&](double x0, double x1, double y) {
    return test::straight_patch(
        {corner(x0, y), corner(x1, y), corner(x1, y + 1), corner(x0, y + 1)});
  };
  return {{box(0, 4, 0), box(0, 1, 1), box(1, 4, 1)},
          {{{{2}, {}}, {{4, 8}, {0.25}}}, {{{5}, {}}, {{11}, {}}}},
          ColorModel::bicubic};
}

TEST(Hemesh, a_junction_keeps_its_own_colours) {
  MeshParts parts = junction_parts();
  // The corner of patch 1 is another colour, that of patch 2 nearly the parent's.
  const glm::dvec4 other(0.9, 0.1, 0.2, 1),
      near(parts.patches[2].c[0][0].color + glm::dvec4(1e-7, 1e-7, 0, 0));
  parts.patches[1].c[0][3].color = other;
  parts.patches[2].c[0][0].color = near;
  parts.own_colors = {8};
  const Mesh mesh = build_mesh(parts);
  const Mesh again = read(write_hemesh(mesh));
  EXPECT_TRUE(same(mesh, again));
  EXPECT_EQ(again.patch(Face{1}).corner(1).color, other);
  EXPECT_EQ(again.patch(Face{2}).corner(0).color, near);
  EXPECT_TRUE(again[again.sides(Face{2})[0]].own_color);
}

/// The text of that mesh, written down by hand in the manner of the authors' programs: a word for
/// the first child, children listed at the end, what merges left behind, and a stale parent.
constexpr const char* handmade = R"(HEMESH
7 18 4 15
0 0 0
4 0 1
4 1 2
0 1 3
1 2 6
0 2 7
4 2 10
0 4 0 0 0 0
1 -4 0 0 0 0
1 0 1 0 0 0
2 0 -1 0 0 0
2 -4 0 0.3 0 0
12 4 0 0.3 0 0
3 0 -1 0 0 0
0 0 1 0 0 0
5 0 1 0 0 0
6 0 -1 0 0 0
6 -1 0 0 0 0
7 1 0 0 0 0
7 0 -1 0 0 0
12 0 1 0 0 0
2 0 1 0 0 0
10 0 -1 0 0 0
10 -3 0 0 0 0
6 3 0 0 0 0
0
-1
4
8
0 1  0 0 0 0 0  0.1 0.2 0.5  0 1  -1 3 1 0  merpity 0 0 1 0 0 0 0
0 1  0 0 0 0 0  0.5 0.2 0.5  2 3  -1 0 2 0  merpity 0 2 3 1 0 0 0
0 1  0 0 0 0 0  0.5 0.5 0.5  4 5  12 1 3 0  merpity 0 4 5 2 0 0 0
0 1  0 0 0 0 0  0.1 0.5 0.5  6 7  -1 2 0 0  merpity 0 6 7 3 0 0 0
0 0.25  0 0 0 0 0  0.1 0.5 0.5  -1 -1  2 7 5 2  merpity 1 12 -1 -1 0 0.25 0
0.25 0.25  0 0 0 0 0  0.21250 0.5 0.5  8 9  11 4 6 2  merpity 1 12 8 9 0.25 0.25 0
0 1  0 0 0 0 0  0.2 0.8 0.5  10 11  -1 5 7 2  merpity 0 10 11 4 0 0 0
0 1  0 0 0 0 0  0.1 0.8 0.5  12 13  -1 6 4 2  merpity 0 12 13 5 0 0 0
0.25 1  0 0 0 0 0  0.21250 0.5 0.5  -1 -1  2 11 9 3  merpity 1 12 -1 -1 0.25 1 0
0 1  0 0 0 0 0  0.5 0.5 0.5  14 15  -1 8 10 3  merpity 0 14 15 2 0 0 0
0 1  0 0 0 0 0  0.5 0.8 0.5  16 17  -1 9 11 3  merpity 0 16 17 6 0 0 0
0 1  0 0 0 0 0  0.2 0.8 0.5  9 8  5 10 8 3  merpity 0 9 8 4 0 0 0
0 1  9 9 9 9 9  0.1 0.5 0.5  5 4  2 7 5 2  merpity 0 5 4 3 0 0 0 4 8 5
0 1  0 0 0 0 0  1 1 1  77 88  99 14 13 -1  merpity 0 77 88 99 0 0 0
0 1  0 0 0 0 0  1 1 1  -1 -1  -1 -1 -1 -1  merpity 0 -1 -1 -1 0 0 0
)";

TEST(Hemesh, reads_a_text_written_by_hand) {
  const MeshParts parts = read_hemesh(handmade, "test.hemesh");
  EXPECT_EQ(parts.color_model, ColorModel::bicubic);
  const Mesh mesh = build_mesh(parts);
  EXPECT_EQ(validate(mesh), std::vector<std::string>{});
  ASSERT_EQ(mesh.face_count(), 3);
  EXPECT_EQ(junctions(mesh), 1u);
  EXPECT_EQ(std::ranges::distance(mesh.points()), 8);
  const Patch above = mesh.patch(Face{0}), left = mesh.patch(Face{1}), right = mesh.patch(Face{2});
  EXPECT_EQ(above.corner(0), (Value{{0, 0}, {0.1, 0.2, 0.5, 1}}));
  EXPECT_EQ(above.corner(2), (Value{{4, 1}, {0.5, 0.5, 0.5, 1}}));
  // The second handle points back into the curve, so the tangent at the end is its opposite.
  EXPECT_EQ(above.side(2).m0, (Value{{-4, 0}, {0.3, 0, 0, 0}}));
  EXPECT_EQ(above.side(2).m1, (Value{{-4, 0}, {-0.3, 0, 0, 0}}));
  // The junction: an x of 4 t; a red of 0.1 (1 - 3 t^2 + 2 t^3) + 0.5 (3 t^2 - 2 t^3) and 0.3 times
  // t - 2 t^2 + t^3 from the start and t^2 - t^3 from the end.
  const double t = 0.25, red = 0.1 + 0.4 * (3 * t * t - 2 * t * t * t) + 0.3 * (t - t * t);
  for (const Value& v : {left.corner(1), right.corner(0)}) {
    EXPECT_NEAR(v.position.x, 1, 1e-12);
    EXPECT_NEAR(v.position.y, 1, 1e-12);
  }
  EXPECT_NEAR(left.side(0).p1.color.r, 0.2125, 1e-12);
  EXPECT_NEAR(right.side(0).p0.color.r, 0.2125, 1e-12);
  EXPECT_GT(std::abs(red - 0.2125),
            1e-3);  // the file's colour differs, so it is the junction's own
  EXPECT_EQ(right.side(1).p1, (Value{{4, 2}, {0.5, 0.8, 0.5, 1}}));
}

/// Gives every second side of a patch a child that spans all of it and takes its place.
HemeshFile with_doubled_sides(HemeshFile file) {
  const int leaves = 4 * int(file.patches.size());
  for (int h = 0; h < leaves; h += 2) {
    const HemeshFile::Halfedge side = file.halfedges[h];
    if (side.is_bar()) continue;
    const int child = int(file.halfedges.size());
    HemeshFile::Halfedge copy = side;
    copy.is_child = true;
    copy.handles = {-1, -1};
    copy.parent = h;
    // Some files are off by rounding.
    copy.interval = {h % 3 == 0 ? -1.5e-7 : 0.0, 1};
    file.halfedges.push_back(copy);
    file.halfedges[copy.prev].next = file.halfedges[copy.next].prev = child;
    if (file.patches[copy.patch] == h) file.patches[copy.patch] = child;
    // What the side itself says of patch and colours is stale from now on.
    file.halfedges[h].patch = 0;
    file.halfedges[h].next = h;
    file.halfedges[h].color = glm::dvec4(9);
    file.halfedges[h].twist = Value{{9, 9}, glm::dvec4(9)};
  }
  return file;
}

/// Puts a bar of its own above all bars but the first of each side that has more than two.
HemeshFile with_bars_of_bars(HemeshFile file, int& made) {
  const int count = int(file.halfedges.size());
  for (int side = 0; side < count; ++side) {
    std::vector<int> bars;
    for (int h = 0; h < count; ++h)
      if (file.halfedges[h].is_bar() && file.halfedges[h].parent == side) bars.push_back(h);
    if (bars.size() < 3) continue;
    std::ranges::sort(bars, {}, [&](int h) { return file.halfedges[h].interval.first; });
    const int bar = int(file.halfedges.size());
    HemeshFile::Halfedge above = file.halfedges[bars[1]];
    const double from = above.interval.first;
    above.interval.second = 1;
    file.halfedges.push_back(above);
    for (HemeshFile::Halfedge& h : file.halfedges) {
      if (!h.is_child || h.parent != side || &h == &file.halfedges[bar]) continue;
      if (h.interval.first < from || (h.is_stem() && h.interval.first == from)) continue;
      h.parent = bar;
      h.interval = {(h.interval.first - from) / (1 - from),
                    (h.interval.second - from) / (1 - from)};
    }
    ++made;
  }
  return file;
}

TEST(Hemesh, doubled_sides_and_bars_of_bars_are_read_as_what_they_stand_for) {
  int bars_of_bars = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Mesh mesh = writable_mesh(seed, 60);
    const HemeshFile file = parse_hemesh(write_hemesh(mesh), "test.hemesh");
    const Mesh doubled = read(format_hemesh(with_doubled_sides(file)));
    EXPECT_TRUE(same(doubled, mesh));

    const Mesh flat = read(format_hemesh(with_bars_of_bars(file, bars_of_bars)));
    EXPECT_EQ(validate(flat), std::vector<std::string>{});
    ASSERT_EQ(flat.face_count(), mesh.face_count());
    EXPECT_EQ(junctions(flat), junctions(mesh));
    int i = 0;
    for (const Face f : mesh.faces())
      EXPECT_LE(difference(flat.patch(Face{i++}), mesh.patch(f)), 1e-9);
  }
  EXPECT_GT(bars_of_bars, 30);
}

/// The junction's mesh without patch 0, whose bottom is now the boundary.
HemeshFile divided_boundary() {
  HemeshFile file = parse_hemesh(write_hemesh(build_mesh(junction_parts())), "test.hemesh");
  file.patches[0] = -1;
  for (HemeshFile::Halfedge& h : file.halfedges)
    if (h.twin == 2) h.twin = -1;
  return file;
}

TEST(Hemesh, a_divided_curve_on_the_boundary_becomes_two) {
  const Mesh mesh = read(format_hemesh(divided_boundary()));
  EXPECT_EQ(validate(mesh), std::vector<std::string>{});
  ASSERT_EQ(mesh.face_count(), 2);
  EXPECT_EQ(junctions(mesh), 0u);
  EXPECT_EQ(std::ranges::distance(mesh.points()), 6);
  const Mesh whole = build_mesh(junction_parts());
  EXPECT_LE(difference(mesh.patch(Face{0}), whole.patch(Face{1})), 1e-12);
  EXPECT_LE(difference(mesh.patch(Face{1}), whole.patch(Face{2})), 1e-12);
  EXPECT_TRUE(same(mesh, read(write_hemesh(mesh))));
}

TEST(Hemesh, opacities_are_dropped) {
  MeshParts parts = junction_parts();
  for (Patch& patch : parts.patches)
    for (const int i : {0, 3})
      for (const int j : {0, 3}) patch.c[i][j].color.a = 0.5;
  const Mesh mesh = read(write_hemesh(build_mesh(parts)));
  for (const Halfedge leaf : leaves_of_faces(mesh)) EXPECT_EQ(mesh[leaf].color.a, 1);
}

// --- what is refused ---

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

std::string refusal(const std::string& text) {
  try {
    read_hemesh(text, "test.hemesh");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The text with value `column` (from 1) of line `line` (from 1) replaced.
std::string with_value(int line, int column, const std::string& value) {
  std::vector<std::string> lines = lines_of(handmade);
  std::istringstream stream(lines[std::size_t(line - 1)]);
  std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
  words[std::size_t(column - 1)] = value;
  lines[std::size_t(line - 1)].clear();
  for (const std::string& word : words) lines[std::size_t(line - 1)] += word + ' ';
  return joined(lines);
}

TEST(Hemesh, refuses_a_start_that_is_not_on_the_parent) {
  for (const double t : {-1.0, 7.0}) {
    HemeshFile file = divided_boundary();
    for (HemeshFile::Halfedge& h : file.halfedges)
      if (h.is_stem()) h.interval = {t, t};
    const std::string message = refusal(format_hemesh(file));
    EXPECT_NE(message.find("it does not start on its parent"), std::string::npos) << message;
  }
}

TEST(Hemesh, refuses_a_mesh_that_it_could_not_write) {
  HemeshFile file = divided_boundary();
  for (HemeshFile::Point& p : file.points) p.position.x = p.position.x > 0 ? 1e9 : -1e9;
  EXPECT_EQ(refusal(format_hemesh(file)), "test.hemesh: its mesh has numbers beyond 1e9.");
}

TEST(Hemesh, refuses_with_file_and_line) {
  // Lines of the text above: points from 3, handles from 10, patches from 28, half-edges from 32.
  const auto expect_refusal = [](const std::string& text, const std::string& start) {
    const std::string message = refusal(text);
    EXPECT_EQ(message.substr(0, start.size()), start) << message;
    EXPECT_TRUE(message.ends_with(".")) << message;
  };
  expect_refusal("", "test.hemesh, line 1: it does not say HEMESH");
  expect_refusal("<svg/>", "test.hemesh, line 1: it does not say HEMESH");
  expect_refusal(with_value(2, 1, "-7"), "test.hemesh, line 2: ");
  expect_refusal(with_value(2, 4, "2000000000"), "test.hemesh, line 2: ");
  expect_refusal(with_value(2, 4, "16"), "test.hemesh: the file ends too early");
  expect_refusal(with_value(2, 4, "14"), "test.hemesh, line 46: there are more lines");
  expect_refusal(with_value(3, 1, "nan"), "test.hemesh, line 3: \"nan\" is not a number");
  expect_refusal(with_value(10, 2, "1e300"), "test.hemesh, line 10: \"1e300\" is not a number");
  expect_refusal(with_value(40, 9, "0.5x"), "test.hemesh, line 40: \"0.5x\" is not a number");
  expect_refusal(with_value(4, 3, "1 2"), "test.hemesh, line 4: \"2\" is too much");
  expect_refusal(with_value(28, 1, "0.5"), "test.hemesh, line 28: \"0.5\" is not a whole number");
  expect_refusal(with_value(28, 1, "99"), "test.hemesh, line 28: there is no half-edge 99");
  expect_refusal(with_value(29, 1, "0"), "test.hemesh, line 32: this half-edge is on two sides");
  expect_refusal(with_value(35, 15, "2"), "test.hemesh, line 34: the half-edge before it");
  expect_refusal(with_value(35, 15, "-3"), "test.hemesh, line 35: there is no half-edge -3");
  expect_refusal(with_value(35, 16, "1"), "test.hemesh, line 35: this half-edge lies in a patch");
  expect_refusal(with_value(34, 13, "9"), "test.hemesh, line 34: its twin is not");
  expect_refusal(with_value(33, 11, "18"), "test.hemesh, line 33: there is no handle 18");
  expect_refusal(with_value(33, 21, "7"), "test.hemesh, line 33: there is no point 7");
  expect_refusal(with_value(34, 21, "4"), "test.hemesh, line 34: it does not start where");
  expect_refusal(with_value(34, 11, "6"), "test.hemesh, line 34: it does not share its handles");
  expect_refusal(with_value(40, 22, "0.5"), "test.hemesh, line 44: the intervals of its children");
  expect_refusal(with_value(36, 19, "8"), "test.hemesh, line");
  // Line 36 is a bar, which may become its own parent.
  expect_refusal(with_value(36, 19, "4"), "test.hemesh, line 36: its parents go round");

  std::vector<std::string> lines = lines_of(handmade);
  for (std::size_t kept = 0; kept < lines.size(); ++kept)
    EXPECT_NE(refusal(joined({lines.begin(), lines.begin() + long(kept)})), "") << kept << " lines";
}

/// Damages a valid text at random.
std::string mutated(const std::string& text, std::mt19937& random) {
  std::vector<std::string> lines = lines_of(text);
  const auto pick = [&](std::size_t n) { return std::size_t(random() % n); };
  std::string& line = lines[pick(lines.size())];
  switch (random() % 6) {
    case 0: {
      std::string bytes = joined(lines);
      bytes[pick(bytes.size())] = char(random() % 256);
      return bytes;
    }
    case 1:
      lines.erase(lines.begin() + long(pick(lines.size())));
      return joined(lines);
    case 2:
      std::swap(line, lines[pick(lines.size())]);
      return joined(lines);
    case 3:
      return joined(lines).substr(0, pick(text.size()));
    default: {
      // Another number in the place of one: mostly another index.
      std::istringstream stream(line);
      std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
      static const std::vector<std::string> values{"-1",   "0",   "1",     "nan", "1e9",
                                                   "-1e9", "0.5", "99999", "-2",  "1e-300"};
      if (!words.empty())
        words[pick(words.size())] =
            random() % 2 ? std::to_string(random() % 60) : values[pick(values.size())];
      line.clear();
      for (const std::string& word : words) line += word + ' ';
      return joined(lines);
    }
  }
}

TEST(Hemesh, a_damaged_text_is_refused_or_makes_a_sound_mesh) {
  int refused = 0, read = 0;
  for (unsigned seed = 0; seed < 6000; ++seed) {
    std::mt19937 random(seed);
    const Mesh mesh = test::changed_mesh(bicubic_parts(seed % 7, 2, 2), seed % 7, 8, 2);
    std::string text = mutated(seed % 3 ? write_hemesh(mesh) : handmade, random);
    for (unsigned more = unsigned(random() % 3); more > 0; --more)
      if (!text.empty()) text = mutated(text, random);
    try {
      const Mesh again = build_mesh(read_hemesh(text, "test.hemesh"));
      ASSERT_EQ(validate(again), std::vector<std::string>{}) << "seed " << seed << "\n" << text;
      ++read;
    } catch (const InputError& error) {
      ASSERT_TRUE(std::string(error.what()).starts_with("test.hemesh")) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(read, 500);
}

}  // namespace
}  // namespace gradmesh
