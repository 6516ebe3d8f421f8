#include <gtest/gtest.h>

#include "formats/svg/gradient/mesh_gradient.h"
#include "meshes.h"
#include "svg_documents.h"

namespace gradmesh {
namespace {

/// A rectangle (10, 20)..(110, 70) filled with the meshgradient `m1`.
SvgTree parse_mesh(const std::string& gradient) {
  return test::svg_tree(
      "<defs>" + gradient +
      "</defs><rect id='r' x='10' y='20' width='100' height='50' fill='url(#m1)'/>");
}

MeshParts read_only_mesh(SvgTree& document) {
  const auto objects = mesh_objects(document);
  EXPECT_EQ(objects.size(), 1u);
  return read_mesh(document, objects.at(0));
}

MeshParts read_gradient(const std::string& gradient) {
  SvgTree document = parse_mesh(gradient);
  return read_only_mesh(document);
}

using test::complaint;

std::string complaint(const std::string& gradient) {
  return complaint([&] { read_gradient(gradient); });
}

std::string mesh(const std::string& rows, const std::string& attributes = "") {
  return "<meshgradient id='m1' x='10' y='20' gradientUnits='userSpaceOnUse' " + attributes + ">" +
         rows + "</meshgradient>";
}

std::string row(const std::string& patches) { return "<meshrow>" + patches + "</meshrow>"; }

std::string stop(const std::string& path, const std::string& color = "black") {
  return "<stop path=\"" + path + "\" stop-color=\"" + color + "\"/>";
}

std::string patch(const std::string& stops, const std::string& attributes = "") {
  return "<meshpatch " + attributes + ">" + stops + "</meshpatch>";
}

const std::string square =
    patch(stop("l 10,0") + stop("l 0,10") + stop("l -10,0") + stop("l 0,-10"));
const std::string next_square = patch(stop("l 10,0") + stop("l 0,10") + stop("l -10,0"));
const std::string square_below = patch(stop("l 0,10") + stop("l -10,0") + stop("l 0,-10"));

void expect_near(const std::vector<Patch>& a, const std::vector<Patch>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    EXPECT_LE(test::difference(a[k], b[k]), tolerance) << "patch " << k;
}

// A 2x3 grid whose 7x10 Bezier points and 3x4 corner colours follow formulas, so that no two are
// equal and every side is curved.
constexpr int grid_rows = 2, grid_columns = 3;

glm::dvec2 grid_point(int i, int j) {
  return {10 * j + ((i * 7 + j * 3) % 5), 10 * i + ((i * 2 + j * 5) % 7)};
}

glm::dvec4 grid_color(int row, int column) {
  return {(row * 4 + column) / 255.0, (200 - 10 * row) / 255.0, (17 * column) / 255.0,
          1.0 - 0.125 * row - 0.0625 * column};
}

std::vector<Patch> grid_by_hand(bool with_tensor) {
  std::vector<Patch> patches;
  for (int r = 0; r < grid_rows; ++r)
    for (int c = 0; c < grid_columns; ++c) {
      BezierNet net;
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) net[i][j].position = grid_point(3 * r + i, 3 * c + j);
      if (!with_tensor) {
        const auto inner = coons_interior(net);
        for (int i = 0; i < 2; ++i)
          for (int j = 0; j < 2; ++j) net[i + 1][j + 1].position = inner[i][j];
      }
      for (int i : {0, 3})
        for (int j : {0, 3}) net[i][j].color = grid_color(r + i / 3, c + j / 3);
      patches.push_back(patch_from_bezier(net));
      make_color_bilinear(patches.back());
    }
  return patches;
}

struct Writing {
  bool relative = true;
  bool color_in_style = true;
  bool closing_point = true;
  bool tensor = false;
};

std::string point_text(glm::dvec2 p) { return std::to_string(p.x) + "," + std::to_string(p.y); }

/// The grid above as a meshgradient in one of the forms that mean the same.
std::string write_grid(const Writing& form) {
  std::string text;
  for (int r = 0; r < grid_rows; ++r) {
    std::string patches;
    for (int c = 0; c < grid_columns; ++c) {
      // Clockwise around the patch: where each corner is and which way its side goes.
      const int row_of[4] = {0, 0, 3, 3}, column_of[4] = {0, 3, 3, 0};
      const int di[4] = {0, 1, 0, -1}, dj[4] = {1, 0, -1, 0};
      const auto point = [&](int side, int k) {
        return grid_point(3 * r + row_of[side] + k * di[side],
                          3 * c + column_of[side] + k * dj[side]);
      };
      std::string stops;
      for (int side = r == 0 ? 0 : 1; side <= (c == 0 ? 3 : 2); ++side) {
        const bool closes = side == (c == 0 ? 3 : 2);
        std::string path = form.relative ? "c" : "C";
        for (int k = 1; k <= (closes && !form.closing_point ? 2 : 3); ++k)
          path.append(" ").append(
              point_text(point(side, k) - (form.relative ? point(side, 0) : glm::dvec2(0.0))));
        const bool is_known = (side == 0 && c > 0) || (side == 1 && r > 0);
        const glm::dvec4 color = is_known
                                     ? glm::dvec4(1, 0, 1, 0)
                                     : grid_color(r + row_of[side] / 3, c + column_of[side] / 3);
        const auto byte = [](double x) { return std::to_string(int(std::lround(255 * x))); };
        const std::string rgb =
            "rgb(" + byte(color.r) + "," + byte(color.g) + "," + byte(color.b) + ")";
        const std::string alpha = std::to_string(color.a);
        stops += "<stop path=\"" + path + "\" ";
        // The style wins over the attribute beside it.
        stops +=
            form.color_in_style
                ? "stop-color='lime' style=\"stop-color:" + rgb + ";stop-opacity:" + alpha + "\"/>"
                : "stop-color=\"" + rgb + "\" stop-opacity=\"" + alpha + "\"/>";
      }
      std::string tensor;
      const int ti[4] = {1, 1, 2, 2}, tj[4] = {1, 2, 2, 1};
      for (int k = 0; k < 4; ++k)
        tensor += point_text(grid_point(3 * r + ti[k], 3 * c + tj[k]) - point(k, 0)) + " ";
      patches += patch(stops, form.tensor ? "tensor=\"" + tensor + "\"" : "");
    }
    text += row(patches);
  }
  const std::string start = "x=\"" + std::to_string(grid_point(0, 0).x) + "\" y=\"" +
                            std::to_string(grid_point(0, 0).y) + "\"";
  return "<meshgradient id='m1' " + start + " gradientUnits='userSpaceOnUse'>" + text +
         "</meshgradient>";
}

TEST(SvgMesh, assembles_grid) {
  const MeshParts parts = read_gradient(write_grid({}));
  expect_near(parts.patches, grid_by_hand(false), 1e-11);
  EXPECT_EQ(parts.color_model, ColorModel::bilinear);
  // 2 x 2 sides between columns, 3 between rows.
  EXPECT_EQ(parts.curves.size(), 7u);
}

TEST(SvgMesh, neighbours_share_their_sides) {
  const MeshParts parts = read_gradient(write_grid({}));
  for (const CurveParts& curve : parts.curves) {
    const auto side = [&](const CurveSide& s) {
      return parts.patches[s.halfedges.at(0) / 4].side(s.halfedges.at(0) % 4);
    };
    EXPECT_EQ(side(curve.a), side(curve.b).reversed());
  }
}

TEST(SvgMesh, forms_that_mean_the_same) {
  const auto expected = grid_by_hand(false);
  for (const bool relative : {false, true})
    for (const bool style : {false, true})
      for (const bool closing : {false, true})
        expect_near(read_gradient(write_grid({relative, style, closing, false})).patches, expected,
                    1e-11);
}

TEST(SvgMesh, tensor_gives_interior_points) {
  const auto read = read_gradient(write_grid({.tensor = true})).patches;
  expect_near(read, grid_by_hand(true), 1e-11);
  EXPECT_GT(
      glm::length(read[0].at(0.5, 0.5).position - grid_by_hand(false)[0].at(0.5, 0.5).position),
      0.1);
}

TEST(SvgMesh, lines_have_handles_at_thirds) {
  const std::string curve = patch(stop("c 4,0,8,0,12,0") + stop("c0 3 0 6 0 9") +
                                  stop("c-4 0-8 0-12 0") + stop("c0-3 0-6"));
  const auto expected = read_gradient(mesh(row(curve))).patches;
  for (const std::string& lines :
       {patch(stop("l 12,0") + stop("l 0,9") + stop("l -12,0") + stop("l 0,-9")),
        patch(stop("l 12 0") + stop("l 0 9") + stop("l-12 0") + stop("l")),
        patch(stop("L 22,20") + stop("L 22,29") + stop("L 10,29") + stop("L 10,20")),
        patch(stop("L22 20") + stop("L22 29") + stop("L10 29") + stop("L"))})
    expect_near(read_gradient(mesh(row(lines))).patches, expected, 1e-12);
}

TEST(SvgMesh, closing_point_is_ignored) {
  const auto with = [](const std::string& end) {
    return read_gradient(mesh(row(patch(stop("l 10,0") + stop("l 0,10") + stop("l -10,0") +
                                        stop("c 1,-3 1,-6 " + end)))))
        .patches;
  };
  EXPECT_EQ(with("0,-10"), with("3,5"));
  EXPECT_EQ(with("0,-10"), with(""));
}

TEST(SvgMesh, bounding_box_units) {
  const std::string fractions =
      patch(stop("l .5,0", "red") + stop("l 0,1", "lime") + stop("l-.5,0", "blue") + stop("l0-1"));
  const std::string units = patch(stop("l 50,0", "red") + stop("l 0,50", "lime") +
                                  stop("l-50,0", "blue") + stop("l0-50"));
  const auto expected = read_gradient(mesh(row(units))).patches;
  // The default units, and percentages of the box.
  for (const std::string attributes : {"", "x='0%' gradientUnits='objectBoundingBox'"})
    expect_near(read_gradient("<meshgradient id='m1' " + attributes + ">" + row(fractions) +
                              "</meshgradient>")
                    .patches,
                expected, 1e-12);
  // The same through a transform inside the box's units.
  expect_near(
      read_gradient(
          "<meshgradient id='m1' x='-1' y='-4' gradientTransform='scale(.5 .25)translate(1 4)'>" +
          row(patch(stop("l 1,0", "red") + stop("l 0,4", "lime") + stop("l-1,0", "blue") +
                    stop("l"))) +
          "</meshgradient>")
          .patches,
      expected, 1e-12);
}

TEST(SvgMesh, lengths_of_the_start) {
  const auto start = [](const std::string& xy) {
    return read_gradient("<meshgradient id='m1' gradientUnits='userSpaceOnUse' " + xy + ">" +
                         row(square) + "</meshgradient>")
        .patches.at(0)
        .corner(0)
        .position;
  };
  EXPECT_EQ(start(""), glm::dvec2(0, 0));
  // As Inkscape paints it: not of the page.
  EXPECT_EQ(start("x='25%' y='25%'"), glm::dvec2(0.25, 0.25));
  EXPECT_EQ(start("x='1in' y='3px'"), glm::dvec2(96, 3));
}

TEST(SvgMesh, smooth_meshes_stay_in_the_coordinates_of_their_gradient) {
  const std::string attributes = "gradientTransform='matrix(2,0,0,5,7,1)' type='bicubic'";
  SvgTree document = parse_mesh(mesh(row(square), attributes));
  const MeshParts smooth = read_only_mesh(document);
  EXPECT_TRUE(smooth.smooth);
  EXPECT_EQ(smooth.patches, read_gradient(mesh(row(square))).patches);
  const MeshObject object = mesh_objects(document).at(0);
  EXPECT_EQ(mesh_to_user(document, object).point({10, 20}), glm::dvec2(27, 101));
  // Not inherited by href either.
  EXPECT_FALSE(read_only_mesh(*std::make_unique<SvgTree>(parse_mesh(
                                  "<meshgradient id='base' type='bicubic'>" + row(square) +
                                  "</meshgradient><meshgradient id='m1' xlink:href='#base'/>")))
                   .smooth);
}

TEST(SvgMesh, href_gives_rows_and_units) {
  const std::string base =
      "<meshgradient id='base' x='5' y='5' gradientUnits='userSpaceOnUse' "
      "gradientTransform='scale(7)'>" +
      row(square + next_square) + "</meshgradient>";
  const auto expected = read_gradient(mesh(row(square + next_square))).patches;
  for (const std::string link :
       {"xlink:href='#base'", "href='#base' xlink:href='#base'", "xlink:href='#%62ase'",
        "xlink:href='#between'", "xlink:href='./drawing.svg#base'"})
    EXPECT_EQ(read_gradient(base + "<meshgradient id='between' xlink:href='#base'/>" +
                            "<meshgradient id='m1' x='10' y='20' " + link + "/>")
                  .patches,
              expected);
  // As Inkscape 1.2 paints it: x, y and gradientTransform are not inherited.
  expect_near(
      read_gradient(
          base + "<meshgradient id='m1' xlink:href='#base' gradientTransform='translate(10 20)'/>")
          .patches,
      expected, 1e-12);
}

TEST(SvgMesh, stop_colors) {
  const auto color = [](const std::string& attributes, const std::string& around = "") {
    const std::string first = "<stop path='l 10,0' " + attributes + "/>";
    return read_gradient("<g " + around + ">" +
                         mesh(row(patch(first + stop("l 0,10") + stop("l -10,0") + stop("l")))) +
                         "</g>")
        .patches.at(0)
        .corner(0)
        .color;
  };
  EXPECT_EQ(color(""), glm::dvec4(0, 0, 0, 1));
  EXPECT_EQ(color("stop-color='red' stop-opacity='0.5'"), glm::dvec4(1, 0, 0, 0.5));
  EXPECT_EQ(color("stop-color='red' style='stop-color:blue'"), glm::dvec4(0, 0, 1, 1));
  EXPECT_EQ(color("stop-color='currentColor' color='lime'"), glm::dvec4(0, 1, 0, 1));
  // Stops inherit nothing in Inkscape.
  EXPECT_EQ(color("stop-color='currentColor'", "color='lime'"), glm::dvec4(0, 0, 0, 1));
  EXPECT_EQ(color("stop-color='inherit'", "stop-color='red'"), glm::dvec4(0, 0, 0, 1));
  EXPECT_EQ(color("color='red' style='stop-color:currentcolor'"), glm::dvec4(1, 0, 0, 1));
  // The opacity of a colour multiplies with that of the stop.
  EXPECT_EQ(color("stop-color='rgb(255 0 0 / 0.5)' stop-opacity='0.5'"), glm::dvec4(1, 0, 0, 0.25));
  EXPECT_EQ(color("style='stop-color:hsl(120, 100, 50)'"), glm::dvec4(0, 1, 0, 1));
  // What is no paint is black, as in Inkscape.
  for (const char* none : {"none", "inherit", "unset", "", "currentColor"})
    EXPECT_EQ(color("stop-color='" + std::string(none) + "' stop-opacity='none'"),
              glm::dvec4(0, 0, 0, 1))
        << none;
  // What is no colour is as if it were not there, beside one that is.
  EXPECT_EQ(color("stop-color='red' style='stop-color:puce'"), glm::dvec4(1, 0, 0, 1));
  EXPECT_EQ(color("style='stop-color:red;stop-color:none'"), glm::dvec4(1, 0, 0, 1));
}

TEST(SvgMesh, earlier_names) {
  const auto expected = read_gradient(mesh(row(square + next_square))).patches;
  std::string text = mesh(row(square + next_square));
  const auto rename = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
      text.replace(at, from.size(), to);
  };
  rename("meshrow", "meshRow");
  rename("meshpatch", "meshPatch");
  EXPECT_EQ(read_gradient(text).patches, expected);
  std::string name = "meshgradient";
  for (const std::string earlier : {"meshGradient", "mesh"}) {
    rename(name, earlier);
    EXPECT_EQ(read_gradient(text).patches, expected) << earlier;
    name = earlier;
  }
}

TEST(SvgMesh, stops_more_or_less_than_needed) {
  // The last stop of a row's first patch: a line to a corner without a colour.
  const auto open = read_gradient(
      mesh(row(patch(stop("l 10,0", "red") + stop("l 0,10", "red") + stop("l -10,0", "red")))));
  const auto whole =
      read_gradient(mesh(row(patch(stop("l 10,0", "red") + stop("l 0,10", "red") +
                                   stop("l -10,0", "red") + "<stop path='l' stop-opacity='0'/>"))));
  EXPECT_EQ(open.patches, whole.patches);
  // A left side that the patch before has given already is given anew.
  const auto twice =
      read_gradient(mesh(row(square + patch(stop("l 10,0") + stop("l 0,10") + stop("l -10,0") +
                                            stop("c 2,-3 2,-6 1,-11", "red")))));
  EXPECT_EQ(twice.patches.at(1).corner(0).position, glm::dvec2(21, 19));
  EXPECT_EQ(twice.patches.at(0).corner(1), twice.patches.at(1).corner(0));
  EXPECT_EQ(twice.patches.at(0).corner(2).color, glm::dvec4(1, 0, 0, 1));
}

TEST(SvgMesh, bad_meshes_are_named) {
  const std::string m = "drawing.svg: meshgradient \"m1\": ";
  const auto broken_stop = [](const std::string& path) {
    return mesh(row(patch(stop(path) + stop("l 0,10") + stop("l -10,0") + stop("l 0,-10"))));
  };
  const auto path_complaint = [&](const std::string& path) {
    return m + "row 1, patch 1, stop 1: the path \"" + path +
           "\" is not one c, C, l or L segment of numbers between -1e9 and 1e9.";
  };
  EXPECT_EQ(complaint(mesh(row(square + next_square) + row(square_below))),
            m + "row 2 does not have as many patches as row 1: 1, not 2.");
  EXPECT_EQ(complaint(mesh(row(square) + row("") + row(square_below))),
            m + "row 2 does not have as many patches as row 1: 0, not 1.");
  EXPECT_EQ(complaint(mesh(row("") + row(square))), m + "row 1 has no patches.");
  EXPECT_EQ(complaint(mesh("")), m + "it has no meshrow.");
  EXPECT_EQ(complaint(mesh(row(patch(stop("l 10,0") + stop("l 0,10"))))),
            m + "row 1, patch 1 does not have as many stops as it needs: 2, not 4.");
  EXPECT_EQ(complaint(mesh(row(square + patch(stop("l 10,0") + stop("l 0,10"))))),
            m + "row 1, patch 2 does not have as many stops as it needs: 2, not 3.");
  EXPECT_EQ(complaint(mesh(row(square) + row(patch(stop("l 0,10"))))),
            m + "row 2, patch 1 does not have as many stops as it needs: 1, not 3.");
  for (const std::string path : {"", "c 1,2 3,4", "c 1,2 3,4 5", "q 1,2 3,4", "l 1", "l", "z",
                                 "l nan,0", "l inf,0", "l 1e30,0", "l 1e999,0", "1,2"})
    EXPECT_EQ(complaint(broken_stop(path)), path_complaint(path));
  for (const std::string color : {"puce", "oklch(0.7 0.15)", "var(--x)", "#12345"})
    EXPECT_EQ(complaint(mesh(row(patch(stop("l 10,0") + stop("l 0,10", color) + stop("l -10,0") +
                                       stop("l 0,-10"))))),
              m + "row 1, patch 1, stop 2: the colour \"" + color + "\" is none that can be read.");
  EXPECT_EQ(complaint(mesh(
                row(square + patch(stop("l 10,0", "puce") + stop("l 0,10") + stop("l -10,0"))))),
            "nothing was thrown")
      << "the patch before has given it";
  EXPECT_EQ(complaint(mesh(row(patch(stop("l 0,0") + stop("l 0,0") + stop("l 0,0") + stop("l"))))),
            m + "row 1, patch 1 is degenerate: all its points coincide.");
  EXPECT_EQ(complaint(mesh(row(square), "gradientTransform='turn(3)'")),
            m + "its gradientTransform \"turn(3)\" is malformed.");
  EXPECT_EQ(complaint(mesh(row(square), "gradientTransform='scale(3 0)'")),
            m + "its gradientTransform flattens the mesh to a line.");
  EXPECT_EQ(complaint(mesh(row(square), "gradientTransform='scale(1e8)'")),
            m + "row 1, patch 1 reaches beyond 5e8 user units.");
  EXPECT_EQ(complaint("<meshgradient id='m1' x='1furlong'>" + row(square) + "</meshgradient>"),
            m + "its x \"1furlong\" is not a known length.");
}

TEST(SvgMesh, bad_links_are_named) {
  const auto link = [](const std::string& id, const std::string& target) {
    return "<meshgradient id=\"" + id + "\" xlink:href=\"" + target + "\"/>";
  };
  EXPECT_EQ(
      complaint(link("m1", "#nowhere")),
      "drawing.svg: meshgradient \"m1\": its href \"#nowhere\" leads nowhere in this document.");
  EXPECT_EQ(
      complaint(link("m1", "other.svg#m")),
      "drawing.svg: meshgradient \"m1\": its href \"other.svg#m\" leads nowhere in this document.");
  EXPECT_EQ(complaint(link("m1", "#r")),
            "drawing.svg: meshgradient \"m1\": its href \"#r\" does not lead to a gradient.");
  EXPECT_EQ(complaint(link("m1", "#m2") + link("m2", "#m3") + link("m3", "#m2")),
            "drawing.svg: meshgradient \"m1\": its href leads back to itself.");
  // Inkscape 1.2 does not follow it, 1.4 does.
  EXPECT_EQ(complaint("<meshgradient id='m1' href='#m2'/>" + link("m2", "#m1")),
            "drawing.svg: meshgradient \"m1\": its href without xlink: is followed by some "
            "versions of Inkscape and not by others.");
}

TEST(SvgMesh, a_rule_for_all_elements_paints_the_mesh_itself) {
  EXPECT_EQ(complaint([] {
              SvgTree document =
                  test::svg_tree("<style>*{fill:url(#m1)}</style><meshgradient id='m1'>" +
                                 row(square) + "</meshgradient><rect/>");
              read_only_mesh(document);
            }),
            "drawing.svg: meshgradient \"m1\": a rule, such as one for all elements, paints the "
            "gradient itself.");
}

TEST(SvgMesh, bounding_box_must_be_known) {
  const auto with = [](const std::string& shape) {
    return complaint([&] {
      SvgTree document =
          test::svg_tree("<meshgradient id='m1'>" + row(square) + "</meshgradient>" + shape);
      read_only_mesh(document);
    });
  };
  EXPECT_EQ(with("<text id='t' fill='url(#m1)'>A</text>"),
            "drawing.svg: text \"t\": its mesh is placed by its bounding box (objectBoundingBox), "
            "which is known for shapes only.");
  EXPECT_EQ(with("<path id='p' fill='url(#m1)' d='M 0 0 H 9'/>"),
            "drawing.svg: path \"p\": its mesh is placed by its bounding box (objectBoundingBox), "
            "which has no width or no height.");
  EXPECT_EQ(with("<path id='p' fill='url(#m1)' d='M 0 0 H'/>"),
            "drawing.svg: path \"p\": its path data \"M 0 0 H\" are malformed.");
  EXPECT_EQ(with("<polygon id='g' fill='url(#m1)' points='1 2 3'/>"),
            "drawing.svg: polygon \"g\": its points \"1 2 3\" are malformed.");
}

}  // namespace
}  // namespace gradmesh
