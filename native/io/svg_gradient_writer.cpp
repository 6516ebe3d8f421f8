#include "io/svg_gradient_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geom/written.h"
#include "io/svg_number.h"
#include "io/xml_edit.h"
#include "io/xml_node.h"

namespace gradmesh {
namespace {

class GradientWriter {
 public:
  GradientWriter(const Mesh& mesh, const Block& block, double coons_tolerance, MeshChannel channel)
      : mesh_(mesh), block_(block), coons_tolerance_(coons_tolerance), channel_(channel) {}

  void write(xmlNode* gradient) {
    for (int row = 0; row < block_.rows; ++row) {
      xmlNode* meshrow = add_child(gradient, "meshrow");
      for (int column = 0; column < block_.columns; ++column)
        write_patch(add_child(meshrow, "meshpatch"), row, column);
    }
  }

 private:
  /// Sides that the patches above and to the left have given already are left out; so are
  /// colours (FACTS 1).
  void write_patch(xmlNode* node, int row, int column) {
    const Block::Cell& cell = block_.cell(row, column);
    const Patch patch = block_patch(mesh_, cell);
    for (int side = row == 0 ? 0 : 1; side < (column == 0 ? 4 : 3); ++side) {
      xmlNode* stop = add_child(node, "stop");
      const Cubic<Value> curve = mesh_.side_of(block_side(mesh_, cell, side));
      set_attribute(stop, "path",
                    "C " + format_point(curve.bezier1().position) + " " +
                        format_point(curve.bezier2().position) + " " +
                        format_point(curve.p1.position));
      const bool given = (side == 0 && column > 0) || (side == 1 && row > 0);
      if (!given) set_attribute(stop, "style", color_style(curve.p0.color));
    }
    if (needs_tensor(patch, coons_tolerance_)) write_tensor(node, patch);
  }

  static void write_tensor(xmlNode* node, const Patch& patch) {
    const BezierNet net = bezier_net(patch);
    const auto from_corner = [&](int i, int j, int corner_i, int corner_j) {
      return format_point(net[i][j].position - net[corner_i][corner_j].position);
    };
    set_attribute(node, "tensor",
                  from_corner(1, 1, 0, 0) + " " + from_corner(1, 2, 0, 3) + " " +
                      from_corner(2, 2, 3, 3) + " " + from_corner(2, 1, 3, 0));
  }

  std::string color_style(const glm::dvec4& color) const {
    const auto byte = [](double c) { return unsigned(std::lround(std::clamp(c, 0.0, 1.0) * 255)); };
    const glm::dvec4 shown = channel_ == MeshChannel::color ? color : glm::dvec4(color.a);
    char hex[8];
    std::snprintf(hex, sizeof hex, "#%02x%02x%02x", byte(shown.r), byte(shown.g), byte(shown.b));
    return std::string("stop-color:") + hex + ";stop-opacity:1";
  }

  const Mesh& mesh_;
  const Block& block_;
  double coons_tolerance_;
  MeshChannel channel_;
};

}  // namespace

std::string write_block_gradient(SvgDocument& document, xmlNode* defs, const Mesh& mesh,
                                 const Block& block, double coons_tolerance, MeshChannel channel,
                                 const std::string& prefix) {
  xmlNode* gradient = add_child(defs, "meshgradient");
  const std::string id = document.give_id(gradient, prefix);
  const Halfedge first = block_side(mesh, block.cell(0, 0), 0);
  const glm::dvec2 start = mesh.position(mesh.origin(first));
  set_attribute(gradient, "gradientUnits", "userSpaceOnUse");
  set_attribute(gradient, "x", format_number(start.x));
  set_attribute(gradient, "y", format_number(start.y));
  GradientWriter(mesh, block, coons_tolerance, channel).write(gradient);
  return id;
}

}  // namespace gradmesh
