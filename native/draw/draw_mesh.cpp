#include <algorithm>
#include <glm/geometric.hpp>

#include "draw/draw.h"
#include "draw/legend.h"

namespace gradmesh {
namespace {

constexpr const char *curve_color = "#33415c", *handle_color = "#0072b2", *point_color = "#1d1d24",
                     *junction_color = "#d55e00", *number_color = "#7a0177";

/// Radii and widths of marks, from the line width.
struct Marks {
  explicit Marks(const Subject& subject)
      : curve{.stroke = curve_color, .stroke_width = 1.3 * subject.line_width()},
        handle{.stroke = handle_color, .stroke_width = 0.7 * subject.line_width()},
        knob{.fill = "white", .stroke = handle_color, .stroke_width = 0.7 * subject.line_width()},
        point{.fill = point_color},
        junction{
            .fill = junction_color, .stroke = "white", .stroke_width = 0.5 * subject.line_width()},
        knob_radius(1.5 * subject.line_width()),
        point_radius(2.4 * subject.line_width()),
        junction_radius(4.2 * subject.line_width()) {}

  Style curve, handle, knob, point, junction;
  double knob_radius, point_radius, junction_radius;
};

Layer curves_layer(const Subject& subject, const Style& style) {
  Layer layer{subject.say(Message("Curves")), {}, {}};
  for (const Halfedge h : subject.mesh().curves())
    layer.shapes.push_back(
        {subject.curve(h), style, subject.say(Message("Half-edge {0}", h.value))});
  return layer;
}

/// Returns a layer with the numbers of the inner edges, by which the method `manual` is told what
/// to merge.
Layer edge_numbers_layer(const Subject& subject) {
  const Mesh& mesh = subject.mesh();
  Layer layer{subject.say(Message("Numbers of half-edges")), {}, {}};
  for (const Halfedge h : subject.mesh().curves()) {
    if (!mesh[h].twin.valid()) continue;
    const Cubic<Value> curve = mesh.curve_of(h);
    const std::string number = std::to_string(h.value);
    const double room =
        glm::length(subject.point(curve.p1.position) - subject.point(curve.p0.position));
    const double size = std::min(1.2 * subject.unit(), 0.5 * room / double(number.size()));
    layer.labels.push_back({number,
                            subject.point(curve.at(0.5).position) + glm::dvec2(0, 0.36 * size),
                            size, number_color, Anchor::middle, true});
  }
  return layer;
}

/// Adds the layer, and room for handles that stick out.
void add_handles(Drawing& drawing, const Subject& subject, const Marks& marks) {
  PathText lines = subject.path(), knobs = subject.path();
  for (const Halfedge h : subject.mesh().curves()) {
    const Cubic<Value> curve = subject.mesh().curve_of(h);
    for (const auto& [end, knob] :
         {std::pair(curve.p0, curve.bezier1()), std::pair(curve.p1, curve.bezier2())}) {
      lines.move(end.position);
      lines.line(knob.position);
      knobs.circle(knob.position, marks.knob_radius);
      for (const double side : {-1.0, 1.0})
        drawing.box.add(subject.point(knob.position) + glm::dvec2(side * subject.unit()));
    }
  }
  drawing.layers.push_back({subject.say(Message("Handles")),
                            {{lines.text(), marks.handle, ""}, {knobs.text(), marks.knob, ""}},
                            {}});
}

Layer points_layer(const Subject& subject, const Marks& marks) {
  const Mesh& mesh = subject.mesh();
  Layer layer{subject.say(Message("Points")), {}, {}};
  for (const Point p : mesh.points()) {
    const bool is_junction = mesh[p].is_junction();
    PathText mark = subject.path();
    if (is_junction) {
      mark.diamond(mesh.position(p), marks.junction_radius);
    } else {
      mark.circle(mesh.position(p), marks.point_radius);
    }
    const Message title =
        is_junction ? Message("T-junction {0}", p.value) : Message("Point {0}", p.value);
    layer.shapes.push_back(
        {mark.text(), is_junction ? marks.junction : marks.point, subject.say(title)});
  }
  return layer;
}

glm::dvec3 mean_color(const Patch& patch) {
  glm::dvec4 sum(0);
  for (int k = 0; k < 4; ++k) sum += patch.corner(k).color;
  const double alpha = sum.a / 4;
  return glm::dvec3(sum) * 0.25 * alpha + glm::dvec3(1 - alpha);
}

bool is_light(const glm::dvec3& color) {
  return glm::dot(color, glm::dvec3(0.299, 0.587, 0.114)) > 0.55;
}

}  // namespace

Drawing draw_edges(const Subject& subject) {
  const Mesh& mesh = subject.mesh();
  const Marks marks(subject);
  Drawing drawing = blank_drawing(subject);
  drawing.layers.push_back(curves_layer(subject, marks.curve));
  add_handles(drawing, subject, marks);
  drawing.layers.push_back(points_layer(subject, marks));
  drawing.layers.push_back(edge_numbers_layer(subject));

  const auto is_junction = [&](Point p) { return mesh[p].is_junction(); };
  const auto points = mesh.points();
  const auto junctions = std::size_t(std::ranges::count_if(points, is_junction));
  const auto all = std::size_t(std::ranges::distance(points));
  Legend legend(subject, drawing, subject.say(Message("Gradient mesh")));
  legend.text(subject.say(Message("patches: {0}", mesh.face_count())));
  legend.gap();
  legend.line(marks.curve, subject.say(Message("curves: {0}", subject.mesh().curves().size())));
  legend.circle(marks.point, subject.say(Message("control points: {0}", all - junctions)));
  if (junctions > 0)
    legend.diamond(marks.junction, subject.say(Message("T-junctions: {0}", junctions)));
  legend.circle(marks.knob, subject.say(Message("ends of handles")));
  legend.text(subject.say(Message("numbers: half-edges")));
  std::move(legend).add_to(drawing);
  return drawing;
}

Drawing draw_faces(const Subject& subject) {
  const Mesh& mesh = subject.mesh();
  Drawing drawing = blank_drawing(subject);
  Layer layer{subject.say(Message("Patches")), {}, {}};
  for (const Face f : mesh.faces()) {
    const glm::dvec3 color = mean_color(mesh.patch(f));
    const std::string number = std::to_string(f.value);
    layer.shapes.push_back(
        {subject.outline(f),
         {.fill = hex_color(color), .stroke = "white", .stroke_width = subject.line_width()},
         subject.say(Message("Patch {0}", number))});
    const double size =
        std::min(2.4 * subject.unit(), 0.9 * subject.narrowness(f) / double(number.size() + 1));
    layer.labels.push_back({number, subject.center(f) + glm::dvec2(0, 0.36 * size), size,
                            is_light(color) ? "#1d1d24" : "white", Anchor::middle});
  }
  drawing.layers.push_back(std::move(layer));
  return drawing;
}

}  // namespace gradmesh
