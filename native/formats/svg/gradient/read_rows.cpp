#include <algorithm>
#include <array>

#include "formats/svg/gradient/rows.h"
#include "formats/svg/values/color.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/xml/node.h"
#include "formats/text/excerpt.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

bool is_current_color(std::string_view value) { return lower(value) == "currentcolor"; }

/// Returns true if a stop without a colour of its own is painted black by these: stops inherit
/// nothing in Inkscape, and a paint that is none is black there.
bool means_black(std::string_view value) {
  constexpr std::array<std::string_view, 7> words{"",      "none",   "inherit",     "initial",
                                                  "unset", "revert", "revert-layer"};
  return std::ranges::find(words, lower(value)) != words.end();
}

/// Returns true if Inkscape takes the value for a colour; it ignores all others.
bool is_color(std::string_view value) {
  return value == "inherit" || is_current_color(value) ||
         parse_translucent_color(value).has_value();
}

bool is_opacity(std::string_view value) {
  return value == "inherit" || parse_opacity(value).has_value();
}

/// Returns the text of a property of a stop that is a colour, as stop_color_text() does.
std::string own_color(const StyleSheet& styles, const xmlNode* stop, std::string_view property) {
  auto text = styles.declared(stop, property, is_color);
  if (!text) text = styles.declared(stop, property);
  if (!text || means_black(*text)) return "";
  if (!is_current_color(*text)) return *text;
  return property == "color" ? "" : own_color(styles, stop, "color");
}

double stop_opacity(const StyleSheet& styles, const xmlNode* stop) {
  const std::string opacity = styles.declared(stop, "stop-opacity", is_opacity).value_or("1");
  return parse_opacity(opacity).value_or(1.0);
}

Message place_name(int row, int column) {
  return Message("row {0}, patch {1}", row + 1, column + 1);
}

/// Reads the rows below a meshgradient into the net of the whole mesh, 3 rows + 1 times 3 columns
/// + 1 points, in Inkscape's order: where two patches share a point, the one read last counts.
class RowsReader {
 public:
  RowsReader(const StyleSheet& styles, const xmlNode* gradient, glm::dvec2 start)
      : styles_(styles), gradient_(gradient), start_(start) {}

  PatchGrid read() {
    std::vector<std::vector<xmlNode*>> patches;
    for (const xmlNode* row : mesh_rows(gradient_)) patches.push_back(mesh_patches(row));
    while (patches.size() > 1 && patches.back().empty()) patches.pop_back();
    rows_ = int(patches.size());
    columns_ = int(patches.front().size());
    if (columns_ == 0) fail(gradient_, Message("row 1 has no patches"));
    for (int row = 1; row < rows_; ++row)
      if (const int count = int(patches[std::size_t(row)].size()); count != columns_)
        fail(gradient_, Message("row {0} does not have as many patches as row 1: {1}, not {2}",
                                row + 1, count, columns_));
    nodes_.resize(std::size_t(3 * rows_ + 1) * std::size_t(3 * columns_ + 1));
    node(0, 0).value.position = start_;
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column)
        read_patch({row, column}, patches[std::size_t(row)][std::size_t(column)]);
    return finish();
  }

 private:
  struct Node {
    Value value{glm::dvec2(0.0), glm::dvec4(0.0)};
    /// At the first handle of a side: true if the side is a line, with handles at its thirds.
    bool is_line = false;
    /// At an interior point: true if `tensor` gives it.
    bool is_given = false;
  };

  struct Place {
    int row, column;
    Message name() const { return place_name(row, column); }
  };

  Node& node(int i, int j) {
    return nodes_[std::size_t(i) * std::size_t(3 * columns_ + 1) + std::size_t(j)];
  }
  /// Returns point (i, j), 0..3, of a patch.
  Node& node(Place place, int i, int j) { return node(3 * place.row + i, 3 * place.column + j); }

  /// Returns point j, 0..3, of side `side` in the side's direction (clockwise).
  Node& side_node(Place place, int side, int j) {
    switch (side) {
      case 0:
        return node(place, 0, j);
      case 1:
        return node(place, j, 3);
      case 2:
        return node(place, 3, 3 - j);
      default:
        return node(place, 3 - j, 0);
    }
  }
  /// Returns the side's Node::is_line, which is the same for both patches beside it.
  bool& is_line(Place place, int side) { return side_node(place, side, side < 2 ? 1 : 2).is_line; }

  void read_patch(Place place, const xmlNode* patch) {
    const int first = place.row == 0 ? 0 : 1, last = place.column == 0 ? 3 : 2;
    const auto stops = child_elements(patch, "stop");
    // Without a stop the left side is a line to a corner without a colour.
    const int most = int(stops.size()), least = last - first + 1 - (last == 3 ? 1 : 0);
    if (most < least)
      fail(gradient_, Message("{0} does not have as many stops as it needs: {1}, not {2}",
                              place.name(), most, last - first + 1));
    is_line(place, last) = true;
    for (int side = first; side <= 3 && side - first < most; ++side) {
      const xmlNode* stop = stops[std::size_t(side - first)];
      const std::string path = attribute(stop, "path").value_or("");
      if (!read_side(place, side, side == last, path))
        fail(gradient_,
             Message("{0}: the path {1} is not one c, C, l or L segment of numbers between "
                     "-1e9 and 1e9",
                     stop_name(place, side - first + 1), excerpt(path)));
      const bool is_known = (side == 0 && place.column > 0) || (side == 1 && place.row > 0);
      if (!is_known)
        side_node(place, side, 0).value.color = stop_color(stop, place, side - first + 1);
    }
    if (const auto tensor = attribute(patch, "tensor")) read_interior(place, *tensor);
  }

  static Message stop_name(Place place, int number) {
    return Message("{0}, stop {1}", place.name(), number);
  }

  glm::dvec4 stop_color(const xmlNode* stop, Place place, int number) const {
    const std::string text = stop_color_text(styles_, stop);
    const auto color = parse_translucent_color(text.empty() ? "black" : text);
    if (!color)
      fail(gradient_, Message("{0}: the colour {1} is none that can be read",
                              stop_name(place, number), excerpt(text)));
    return {glm::dvec3(*color), color->a * stop_opacity(styles_, stop)};
  }

  /// Reads one segment from the side's known start; text after it is ignored. If the side closes
  /// the patch its end is known too, and is ignored if given.
  bool read_side(Place place, int side, bool closes, std::string path) {
    std::ranges::replace(path, ',', ' ');
    Scanner scanner(path);
    const char command = scanner.peek();
    scanner.accept(command);
    const bool is_curve = command == 'c' || command == 'C';
    const bool ends = closes && (command == 'z' || command == 'Z');
    if (!is_curve && !ends && command != 'l' && command != 'L') return false;

    const bool is_relative = command == 'c' || command == 'l';
    const glm::dvec2 start = side_node(place, side, 0).value.position;
    const glm::dvec2 base = is_relative ? start : glm::dvec2(0.0);
    is_line(place, side) = !is_curve;
    for (int j = is_curve ? 1 : 3; j <= (closes ? 2 : 3); ++j) {
      const auto x = scanner.number(), y = scanner.number();
      if (!x || !y) return false;
      side_node(place, side, j).value.position = base + glm::dvec2(*x, *y);
    }
    return true;
  }

  /// Reads `tensor`, Inkscape's own attribute: the interior points, each relative to its corner,
  /// clockwise. From the first that is no point on, all are as if there were no tensor.
  void read_interior(Place place, std::string tensor) {
    std::ranges::replace(tensor, ',', ' ');
    Scanner scanner(tensor);
    constexpr int interior[4][2] = {{1, 1}, {1, 2}, {2, 2}, {2, 1}};
    for (int corner = 0; corner < 4; ++corner) {
      const auto x = scanner.number(), y = scanner.number();
      if (!x || !y) return;
      Node& inner = node(place, interior[corner][0], interior[corner][1]);
      inner.value.position = side_node(place, corner, 0).value.position + glm::dvec2(*x, *y);
      inner.is_given = true;
    }
  }

  /// Returns the points of a patch, including those that follow from others.
  BezierNet net(Place place) {
    for (int side = 0; side < 4; ++side) {
      if (!is_line(place, side)) continue;
      const glm::dvec2 start = side_node(place, side, 0).value.position;
      const glm::dvec2 end = side_node(place, side, 3).value.position;
      side_node(place, side, 1).value.position = start + (end - start) / 3.0;
      side_node(place, side, 2).value.position = start + (end - start) * (2.0 / 3.0);
    }
    BezierNet points;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) points[std::size_t(i)][std::size_t(j)] = node(place, i, j).value;
    const auto interior = coons_interior(points);
    for (int i = 1; i < 3; ++i)
      for (int j = 1; j < 3; ++j)
        if (!node(place, i, j).is_given)
          points[std::size_t(i)][std::size_t(j)].position =
              interior[std::size_t(i - 1)][std::size_t(j - 1)];
    return points;
  }

  void check_size(Place place, const BezierNet& points) {
    const glm::dvec2 first = points[0][0].position;
    for (int side = 0; side < 4; ++side)
      for (int j = 0; j < 3; ++j)
        if (side_node(place, side, j).value.position != first) return;
    fail(gradient_, Message("{0} is degenerate: all its points coincide", place.name()));
  }

  PatchGrid finish() {
    PatchGrid grid{rows_, columns_, {}};
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) {
        const BezierNet points = net({row, column});
        check_size({row, column}, points);
        grid.patches.push_back(patch_from_bezier(points));
        make_color_bilinear(grid.patches.back());
      }
    return grid;
  }

  const StyleSheet& styles_;
  const xmlNode* gradient_;
  glm::dvec2 start_;
  int rows_ = 0, columns_ = 0;
  std::vector<Node> nodes_;
};

}  // namespace

bool is_within_limits(const Patch& patch) {
  const BezierNet net = bezier_net(patch);
  return std::all_of(net.begin(), net.end(), [](const auto& row) {
    return std::all_of(row.begin(), row.end(), [](const Value& value) {
      const glm::dvec2 p = value.position;
      return std::abs(p.x) <= largest_reach && std::abs(p.y) <= largest_reach;
    });
  });
}

void check_limits(const PatchGrid& grid, const xmlNode* node) {
  for (std::size_t i = 0; i < grid.patches.size(); ++i)
    if (!is_within_limits(grid.patches[i]))
      fail(node, Message("{0} reaches beyond 5e8 user units",
                         place_name(int(i) / grid.columns, int(i) % grid.columns)));
}

std::string stop_color_text(const StyleSheet& styles, const xmlNode* stop) {
  return own_color(styles, stop, "stop-color");
}

PatchGrid read_rows(const StyleSheet& styles, const xmlNode* gradient, glm::dvec2 start) {
  PatchGrid grid = RowsReader(styles, gradient, start).read();
  check_limits(grid, gradient);
  return grid;
}

}  // namespace gradmesh
