#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "form/handles.h"
#include "form/rounding.h"
#include "formats/svg/gradient/rows.h"
#include "formats/svg/values/color.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

class RowsWriter {
 public:
  RowsWriter(const Mesh& mesh, const Rectangle& block, const GradientFormat& format)
      : mesh_(mesh), block_(block), format_(format), step_(format.precision.step) {}

  void write(xmlNode* gradient) {
    const Halfedge first = block_.top(0, 0);
    const glm::dvec2 start = mesh_.position(mesh_.origin(first));
    const glm::dvec2 placed = format_.precision.to_written.point(start);
    set_attribute(gradient, "x", coordinate(placed.x));
    set_attribute(gradient, "y", coordinate(placed.y));
    for (int row = 0; row < block_.rows; ++row) {
      xmlNode* meshrow = add_child(gradient, mesh_row_name);
      for (int column = 0; column < block_.columns; ++column)
        write_patch(add_child(meshrow, mesh_patch_name), row, column);
    }
  }

 private:
  /// Writes a patch. Leaves out the sides and colours that the patches above and to the left have
  /// given already.
  void write_patch(xmlNode* node, int row, int column) {
    const Halfedge top = block_.top(row, column);
    const Patch patch = mesh_.patch(top);
    const PatchTolerance tolerance = patch_tolerance(mesh_, top, format_.precision);
    for (int side = row == 0 ? 0 : 1; side < (column == 0 ? 4 : 3); ++side) {
      xmlNode* stop = add_child(node, "stop");
      const Cubic<Value> curve = mesh_.side_of(mesh_.sides(top)[side]);
      set_attribute(stop, "path", path(curve, tolerance.straight[std::size_t(side)]));
      const bool given = (side == 0 && column > 0) || (side == 1 && row > 0);
      if (!given) write_color(stop, curve.p0.color);
    }
    if (needs_tensor(patch, tolerance.coons)) write_tensor(node, patch);
  }

  /// Returns the path data of a side from its start on. A line shows no handles in the mesh tool.
  std::string path(const Cubic<Value>& curve, double straight_within) const {
    const auto to = [&](const Value& v) {
      const glm::dvec2 start = format_.is_relative ? placed(curve.p0.position) : glm::dvec2(0.0);
      return pair(placed(v.position) - start);
    };
    const std::string end = to(curve.p1);
    if (is_straight(curve, step_ > 0 ? straight_within : least_of(straight_within)))
      return (format_.is_relative ? 'l' : 'L') + end;
    return (format_.is_relative ? 'c' : 'C') + to(curve.bezier1()) + " " + to(curve.bezier2()) +
           " " + end;
  }

  void write_tensor(xmlNode* node, const Patch& patch) const {
    const BezierNet net = bezier_net(patch);
    const auto from_corner = [&](int i, int j, int corner_i, int corner_j) {
      const glm::dvec2 offset = net[i][j].position - net[corner_i][corner_j].position;
      return pair(format_.precision.to_written.vector(offset));
    };
    set_attribute(node, "tensor",
                  from_corner(1, 1, 0, 0) + " " + from_corner(1, 2, 0, 3) + " " +
                      from_corner(2, 2, 3, 3) + " " + from_corner(2, 1, 3, 0));
  }

  void write_color(xmlNode* stop, const glm::dvec4& color) const {
    const glm::dvec4 limited = glm::clamp(color, 0.0, 1.0);
    const bool opaque = format_.channel != MeshChannel::both;
    const glm::dvec3 shown =
        format_.channel == MeshChannel::opacity ? mask_color(limited.a) : glm::dvec3(limited);
    const double alpha = opaque ? 1 : limited.a;
    const ColorText* const kept = format_.texts && format_.channel != MeshChannel::opacity
                                      ? format_.texts->find({shown, alpha})
                                      : nullptr;
    const std::string text = kept ? kept->text : color_text(shown);
    const std::string opacity = format_number(kept ? kept->opacity_beside(alpha) : alpha);
    if (format_.in_style) {
      const std::string mark(format_.is_important ? important_mark : "");
      set_attribute(stop, "style", "stop-color:" + text + mark + ";stop-opacity:" + opacity + mark);
    } else {
      set_attribute(stop, "stop-color", text);
      if (opacity != "1") set_attribute(stop, "stop-opacity", opacity);
    }
  }

  /// Returns the tolerance for lines where no coordinate is rounded, and nothing was measured with
  /// the rounding.
  double least_of(double straight_within) const {
    constexpr double rounding_share = 1e-3;
    return std::min(straight_within, rounding_share * format_.precision.coons_tolerance);
  }

  /// Returns a point of the mesh where it is written.
  glm::dvec2 placed(glm::dvec2 p) const {
    const glm::dvec2 there = format_.precision.to_written.point(p);
    return step_ > 0 ? round_to_step(there, step_) : there;
  }

  std::string coordinate(double x) const {
    if (step_ > 0) return format_multiple(x, step_);
    return std::abs(x) < format_.rounding.zero ? "0" : format_number(x, format_.rounding.digits);
  }
  std::string pair(glm::dvec2 p) const { return coordinate(p.x) + "," + coordinate(p.y); }

  const Mesh& mesh_;
  const Rectangle& block_;
  const GradientFormat& format_;
  const double step_;
};

}  // namespace

void write_rows(xmlNode* gradient, const Mesh& mesh, const Rectangle& block,
                const GradientFormat& format) {
  RowsWriter(mesh, block, format).write(gradient);
}

}  // namespace gradmesh
