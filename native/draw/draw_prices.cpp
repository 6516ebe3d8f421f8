#include <algorithm>
#include <cmath>

#include "draw/draw.h"
#include "draw/heat_scale.h"
#include "draw/legend.h"
#include "draw/part_tints.h"

namespace gradmesh {
namespace {

constexpr const char *boundary_color = "#8a8f9c", *unmergeable_color = "#0077b6";

Style boundary_style(const Subject& subject) {
  return {.stroke = boundary_color, .stroke_width = 0.8 * subject.line_width()};
}

Style unmergeable_style(const Subject& subject) {
  return {.stroke = unmergeable_color,
          .stroke_width = 1.6 * subject.line_width(),
          .dash = 4 * subject.line_width()};
}

/// Returns a layer of the curves with a patch on one side only.
Layer boundary_layer(const Subject& subject) {
  Layer layer{subject.say(Message("Boundary")), {}, {}};
  for (const Halfedge h : subject.mesh().curves())
    if (!subject.mesh()[h].twin.valid())
      layer.shapes.push_back({subject.curve(h), boundary_style(subject), ""});
  return layer;
}

Message half_edge(Halfedge h) { return Message("Half-edge {0}", h.value); }

}  // namespace

Drawing draw_errors(const Subject& subject, const std::vector<EdgePrice>& prices,
                    const std::string& measure) {
  std::vector<EdgePrice> known, unmergeable;
  for (const EdgePrice& p : prices) (std::isfinite(p.error) ? known : unmergeable).push_back(p);
  // Costly edges last, so that they lie on top.
  std::ranges::stable_sort(known, {}, &EdgePrice::error);

  Drawing drawing = blank_drawing(subject);
  drawing.layers.push_back(boundary_layer(subject));
  Legend legend(subject, drawing, subject.say(Message("Error of merging single edges")));
  legend.text(measure);
  legend.gap();

  Layer edges{subject.say(Message("Single-edge errors")), {}, {}},
      blocked{subject.say(Message("Unmergeable edges")), {}, {}};
  if (!known.empty()) {
    const double least = known.front().error, largest = known.back().error;
    // Where nothing costs anything, all edges are at the low end of some scale.
    const HeatScale scale(largest > 0 ? largest : 1e-3);
    for (const EdgePrice& p : known)
      edges.shapes.push_back(
          {subject.curve(p.edge),
           {.stroke = scale.color(p.error), .stroke_width = 3 * subject.line_width()},
           subject.say(Message("{0}: {1}", half_edge(p.edge), short_number(p.error)))});
    legend.scale(scale, least);
    legend.gap();
  }
  for (const EdgePrice& p : unmergeable) {
    const Message title =
        p.obstacle == MergeObstacle::none
            ? Message("Half-edge {0} cannot be merged", p.edge.value)
            : Message("Half-edge {0} cannot be merged: {1}", p.edge.value, describe(p.obstacle));
    blocked.shapes.push_back(
        {subject.curve(p.edge), unmergeable_style(subject), subject.say(title)});
  }
  if (!unmergeable.empty())
    legend.line(unmergeable_style(subject),
                subject.say(Message("{0} cannot be merged", unmergeable.size())));
  legend.line(boundary_style(subject), subject.say(Message("boundary")));
  drawing.layers.push_back(std::move(edges));
  drawing.layers.push_back(std::move(blocked));
  std::move(legend).add_to(drawing);
  return drawing;
}

namespace {

Layer parts_layer(const Subject& subject, const MotorcycleGraph& graph) {
  const Mesh& mesh = subject.mesh();
  const PartTints tints(mesh, graph);
  Layer layer{subject.say(Message("Parts")), {}, {}};
  for (const Face f : mesh.faces())
    if (const int i = tints.part(f); i >= 0)
      layer.shapes.push_back({subject.outline(f),
                              {.fill = hex_color(tints.color(i)), .fill_opacity = part_opacity},
                              subject.say(Message("Part {0}", i + 1))});
  return layer;
}

void add_edges(Layer& layer, const Subject& subject, const std::vector<Halfedge>& edges,
               const Style& style) {
  for (const Halfedge h : edges)
    layer.shapes.push_back({subject.curve(h), style, subject.say(half_edge(h))});
}

}  // namespace

Drawing draw_motorcycle(const Subject& subject, const MotorcycleGraph& graph, double limit) {
  const double width = subject.line_width();
  const Style inner{.stroke = "#5b6170", .stroke_width = 0.7 * width},
      costly{.stroke = "#c8102e", .stroke_width = 3 * width},
      traced{.stroke = "#1d1d24", .stroke_width = 2 * width, .dash = 4.5 * width};
  Drawing drawing = blank_drawing(subject);
  drawing.layers.push_back(parts_layer(subject, graph));
  drawing.layers.push_back(boundary_layer(subject));
  Layer edges{subject.say(Message("Motorcycle graph")), {}, {}};
  std::size_t inner_edges = 0;
  for (const auto& part : graph.parts) {
    add_edges(edges, subject, part, inner);
    inner_edges += part.size();
  }
  add_edges(edges, subject, graph.costly, costly);
  add_edges(edges, subject, graph.unmergeable, unmergeable_style(subject));
  add_edges(edges, subject, graph.traced, traced);
  drawing.layers.push_back(std::move(edges));

  Legend legend(subject, drawing, subject.say(Message("Motorcycle graph")));
  legend.gap();
  legend.line(costly, subject.say(Message("{0} cost more than {1}", graph.costly.size(),
                                          short_number(limit))));
  legend.line(unmergeable_style(subject),
              subject.say(Message("{0} cannot be merged", graph.unmergeable.size())));
  legend.line(traced, subject.say(Message("{0} traced from their ends", graph.traced.size())));
  legend.line(inner, subject.say(Message("{0} left to merge", inner_edges)));
  legend.area({.fill = hex_color(first_part_color), .fill_opacity = part_opacity},
              subject.say(Message("parts: {0}", graph.parts.size())));
  std::move(legend).add_to(drawing);
  return drawing;
}

}  // namespace gradmesh
