#include "io/svg_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <string>

#include "base/limits.h"
#include "io/svg_color.h"
#include "io/svg_length.h"
#include "io/svg_scanner.h"
#include "io/svg_shape.h"
#include "io/svg_transform.h"
#include "io/xml_node.h"

namespace gradmesh {
namespace {

/// The gradient and those that its href leads to, in this order.
std::vector<const xmlNode*> href_chain(const SvgDocument& document, const xmlNode* gradient) {
  std::vector<const xmlNode*> chain;
  std::set<const xmlNode*> seen;
  for (const xmlNode* node = gradient; node;) {
    if (!seen.insert(node).second) fail(gradient, Message("its href leads back to itself"));
    chain.push_back(node);
    auto href = attribute(node, "href");
    if (!href) href = attribute(node, "href", xlink_namespace);
    const std::string_view target = trimmed(href ? std::string_view(*href) : "");
    if (target.empty()) break;
    const xmlNode* next = target.starts_with('#') ? document.find(target.substr(1)) : nullptr;
    if (!next) fail(node, Message("its href {0} leads nowhere in this document", excerpt(target)));
    if (svg_name(next) != "meshgradient")
      fail(node, Message("its href {0} does not lead to a meshgradient", excerpt(target)));
    node = next;
  }
  if (const std::size_t most = limits().links; chain.size() > most)
    fail(gradient, Message("{0} gradients refer to one another, {1}", chain.size(),
                           beyond_limit("links", most, chain.size())));
  return chain;
}

bool uses_bounding_box(const std::vector<const xmlNode*>& chain) {
  for (const xmlNode* node : chain)
    if (const auto units = attribute(node, "gradientUnits"))
      return trimmed(*units) != "userSpaceOnUse";
  return true;
}

/// Value of a property that is not inherited unless it says so.
std::optional<std::string> own_value(const StyleSheet& styles, const xmlNode* node,
                                     std::string_view property) {
  for (; node; node = parent_element(node)) {
    auto value = styles.declared(node, property);
    if (!value || lower(*value) != "inherit") return value;
  }
  return std::nullopt;
}

/// What `currentColor` stands for at a stop.
std::string current_color(const StyleSheet& styles, const xmlNode* node) {
  for (; node; node = parent_element(node)) {
    const auto value = styles.inherited(node, "color");
    if (!value) break;
    if (lower(*value) != "currentcolor") return *value;
  }
  return "black";
}

Message place_name(int row, int column) {
  return Message("row {0}, patch {1}", row + 1, column + 1);
}

/// Reads the rows below one meshgradient, from left to right and from top to bottom, since each
/// patch takes its top and left sides from the patches before.
class GridReader {
 public:
  GridReader(const StyleSheet& styles, const xmlNode* holder, glm::dvec2 start)
      : styles_(styles), holder_(holder), start_(start) {}

  MeshGrid read() {
    const auto rows = child_elements(holder_, "meshrow");
    for (rows_ = 0; rows_ < int(rows.size()); ++rows_) {
      const auto patches = child_elements(rows[std::size_t(rows_)], "meshpatch");
      const int count = int(patches.size());
      if (rows_ == 0) columns_ = count;
      if (columns_ == 0) fail(holder_, Message("row 1 has no patches"));
      if (count != columns_)
        fail(holder_, Message("row {0} does not have as many patches as row 1: {1}, not {2}",
                              rows_ + 1, count, columns_));
      for (int column = 0; column < columns_; ++column)
        read_patch(patches[std::size_t(column)], rows_, column);
    }
    return finish();
  }

 private:
  BezierNet& net(int row, int column) {
    return nets_[std::size_t(row) * std::size_t(columns_) + std::size_t(column)];
  }

  /// Point j, 0..3, of side `side` in the side's direction (clockwise).
  static Value& side_point(BezierNet& net, int side, int j) {
    switch (side) {
      case 0:
        return net[0][std::size_t(j)];
      case 1:
        return net[std::size_t(j)][3];
      case 2:
        return net[3][std::size_t(3 - j)];
      default:
        return net[std::size_t(3 - j)][0];
    }
  }

  void read_patch(const xmlNode* patch, int row, int column) {
    BezierNet& points = nets_.emplace_back();
    points[0][0].position = start_;
    if (row > 0) points[0] = net(row - 1, column)[3];
    if (column > 0)
      for (std::size_t i = 0; i < 4; ++i) points[i][0] = net(row, column - 1)[i][3];

    const int first = row == 0 ? 0 : 1, last = column == 0 ? 3 : 2;
    const auto stops = child_elements(patch, "stop");
    if (int(stops.size()) != last - first + 1)
      fail(holder_, Message("{0} does not have as many stops as it needs: {1}, not {2}",
                            place_name(row, column), stops.size(), last - first + 1));
    for (int side = first; side <= last; ++side) {
      const xmlNode* stop = stops[std::size_t(side - first)];
      const auto place = Message("{0}, stop {1}", place_name(row, column), side - first + 1);
      const std::string path = attribute(stop, "path").value_or("");
      if (!read_side(points, side, side == last, path))
        fail(
            holder_,
            Message(
                "{0}: the path {1} is not one c, C, l or L segment of numbers between -1e9 and 1e9",
                place, excerpt(path)));
      const bool is_known = (side == 0 && column > 0) || (side == 1 && row > 0);
      if (!is_known) side_point(points, side, 0).color = read_color(stop, place);
    }
    read_interior(points, patch, row, column);
    check_size(points, row, column);
  }

  /// One segment from the side's known start. Where the side closes the patch its end is known
  /// too: it may be left out and is ignored.
  static bool read_side(BezierNet& net, int side, bool closes, const std::string& path) {
    Scanner scanner(path);
    const char command = scanner.peek();
    const bool is_curve = command == 'c' || command == 'C';
    if (!is_curve && command != 'l' && command != 'L') return false;
    scanner.accept(command);

    const glm::dvec2 start = side_point(net, side, 0).position;
    const glm::dvec2 base = command == 'c' || command == 'l' ? start : glm::dvec2(0.0);
    const int complete = is_curve ? 3 : 1;
    glm::dvec2 points[3] = {};
    int count = 0;
    for (; !scanner.at_end() && count < complete; ++count) {
      if (count > 0) scanner.skip_comma();
      const auto x = scanner.number();
      scanner.skip_comma();
      const auto y = scanner.number();
      if (!x || !y) return false;
      points[count] = base + glm::dvec2(*x, *y);
    }
    if (!scanner.at_end() || count < complete - (closes ? 1 : 0)) return false;

    glm::dvec2& end = side_point(net, side, 3).position;
    if (!closes) end = points[complete - 1];
    side_point(net, side, 1).position = is_curve ? points[0] : start + (end - start) / 3.0;
    side_point(net, side, 2).position = is_curve ? points[1] : start + (end - start) * (2.0 / 3.0);
    return true;
  }

  /// `tensor` is Inkscape's own: the interior points, each relative to its corner, clockwise.
  void read_interior(BezierNet& net, const xmlNode* patch, int row, int column) const {
    const auto tensor = attribute(patch, "tensor");
    if (!tensor) {
      const auto interior = coons_interior(net);
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) net[i + 1][j + 1].position = interior[i][j];
      return;
    }
    Value* const interior[4] = {&net[1][1], &net[1][2], &net[2][2], &net[2][1]};
    Scanner scanner(*tensor);
    for (int corner = 0; corner < 4; ++corner) {
      if (corner > 0) scanner.skip_comma();
      const auto x = scanner.number();
      scanner.skip_comma();
      const auto y = scanner.number();
      if (!x || !y || (corner == 3 && !scanner.at_end()))
        fail(holder_,
             Message("{0}: the tensor {1} is not four points of numbers between -1e9 and 1e9",
                     place_name(row, column), excerpt(*tensor)));
      interior[corner]->position = side_point(net, corner, 0).position + glm::dvec2(*x, *y);
    }
  }

  glm::dvec4 read_color(const xmlNode* stop, const Message& place) const {
    std::string text = own_value(styles_, stop, "stop-color").value_or("black");
    if (lower(text) == "currentcolor") text = current_color(styles_, stop);
    const auto color = parse_color(text);
    if (!color) fail(holder_, Message("{0}: {1} is not a known colour", place, excerpt(text)));
    const std::string opacity = own_value(styles_, stop, "stop-opacity").value_or("1");
    const auto alpha = parse_fraction(opacity);
    if (!alpha) fail(holder_, Message("{0}: {1} is not an opacity", place, excerpt(opacity)));
    return {glm::dvec3(*color), color->a * *alpha};
  }

  void check_size(BezierNet& net, int row, int column) const {
    bool is_point = true;
    for (int side = 0; side < 4; ++side)
      for (int j = 0; j < 3; ++j)
        is_point = is_point && side_point(net, side, j).position == net[0][0].position;
    if (is_point)
      fail(holder_, Message("{0} is degenerate: all its points coincide", place_name(row, column)));
  }

  MeshGrid finish() const {
    MeshGrid grid{rows_, columns_, {}};
    grid.patches.reserve(nets_.size());
    for (const BezierNet& points : nets_) {
      grid.patches.push_back(patch_from_bezier(points));
      make_color_bilinear(grid.patches.back());
    }
    return grid;
  }

  const StyleSheet& styles_;
  const xmlNode* holder_;
  glm::dvec2 start_;
  int rows_ = 0, columns_ = 0;
  std::vector<BezierNet> nets_;
};

void check_limits(const MeshGrid& grid, const xmlNode* node) {
  for (std::size_t i = 0; i < grid.patches.size(); ++i)
    if (!is_within_limits(grid.patches[i]))
      fail(node, Message("{0} reaches beyond 5e8 user units",
                         place_name(int(i) / grid.columns, int(i) % grid.columns)));
}

bool is_smooth(const xmlNode* gradient) {
  return trimmed(attribute(gradient, "type").value_or("")) == "bicubic";
}

/// From the gradient's coordinates to the object's user space.
Affine gradient_to_user(const SvgDocument& document, const MeshObject& object) {
  Affine to_user;
  if (const auto text = attribute(object.gradient, "gradientTransform")) {
    const auto transform = parse_transform(*text);
    if (!transform)
      fail(object.gradient, Message("its gradientTransform {0} is malformed", excerpt(*text)));
    to_user = *transform;
  }
  if (uses_bounding_box(href_chain(document, object.gradient))) {
    const auto box = shape_box(object.node);
    if (!box)
      fail(object.node, Message("its mesh is placed by its bounding box (objectBoundingBox), "
                                "which is known for shapes only"));
    if (box->empty() || box->size().x == 0 || box->size().y == 0)
      fail(object.node, Message("its mesh is placed by its bounding box (objectBoundingBox), "
                                "which has no width or no height"));
    to_user = Affine::translation(box->low()) * Affine::scaling(box->size()) * to_user;
  }
  // A determinant this small against the entries is zero but for rounding.
  const glm::dmat2& m = to_user.linear;
  if (std::abs(to_user.determinant()) <= 1e-14 * (glm::dot(m[0], m[0]) + glm::dot(m[1], m[1])))
    fail(object.gradient, Message("its gradientTransform flattens the mesh to a line"));
  return to_user;
}

MeshGrid read_grid(const SvgDocument& document, const xmlNode* gradient) {
  const auto chain = href_chain(document, gradient);
  const auto holder = std::find_if(chain.begin(), chain.end(), [](const xmlNode* node) {
    return !child_elements(node, "meshrow").empty();
  });
  if (holder == chain.end()) fail(gradient, Message("it has no meshrow"));
  const glm::dvec2 start =
      uses_bounding_box(chain)
          ? glm::dvec2(read_box_length(gradient, "x"), read_box_length(gradient, "y"))
          : glm::dvec2(read_length(gradient, "x", LengthAxis::x),
                       read_length(gradient, "y", LengthAxis::y));
  MeshGrid grid = GridReader(document.styles(), *holder, start).read();
  check_limits(grid, *holder);
  return grid;
}

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

MeshGrid read_mesh_gradient(const SvgDocument& document, const xmlNode* gradient) {
  if (is_smooth(gradient))
    fail(gradient, Message("its type \"bicubic\" is not supported here, where a mesh has several "
                           "gradients"));
  return read_grid(document, gradient);
}

MeshParts read_mesh(const SvgDocument& document, const MeshObject& object) {
  MeshGrid grid = read_grid(document, object.gradient), in_user = grid;
  const Affine to_user = gradient_to_user(document, object);
  for (Patch& patch : in_user.patches) transform(patch, to_user);
  check_limits(in_user, object.gradient);
  MeshParts parts{{}, grid_curves(grid.rows, grid.columns)};
  parts.smooth = is_smooth(object.gradient);
  parts.patches = std::move(parts.smooth ? grid.patches : in_user.patches);
  return parts;
}

Affine mesh_to_user(const SvgDocument& document, const MeshObject& object) {
  return is_smooth(object.gradient) ? gradient_to_user(document, object) : Affine();
}

Affine mesh_to_gradient(const SvgDocument& document, const MeshObject& object) {
  return is_smooth(object.gradient) ? Affine() : gradient_to_user(document, object).inverse();
}

bool in_bounding_box(const SvgDocument& document, const xmlNode* gradient) {
  return uses_bounding_box(href_chain(document, gradient));
}

}  // namespace gradmesh
