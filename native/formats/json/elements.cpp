#include "formats/json/elements.h"

#include <nlohmann/json.hpp>

namespace gradmesh {
namespace {

using nlohmann::ordered_json;

template <class Record>
ordered_json json(Index<Record> index) {
  return index.valid() ? ordered_json(index.value) : ordered_json(nullptr);
}

ordered_json json(glm::dvec2 p) { return {p.x, p.y}; }
ordered_json json(const glm::dvec4& c) { return {c.r, c.g, c.b, c.a}; }

ordered_json json(const Value& v, ColorModel model) {
  ordered_json array = json(v.position);
  if (model == ColorModel::bicubic)
    array.insert(array.end(), {v.color.r, v.color.g, v.color.b, v.color.a});
  return array;
}

template <class Elements>
ordered_json json_list(const Elements& elements) {
  ordered_json list = ordered_json::array();
  for (const auto element : elements) list.push_back(json(element));
  return list;
}

ordered_json halfedge_json(const Mesh& mesh, Halfedge h) {
  const HalfedgeRecord& record = mesh[h];
  ordered_json interval = nullptr, handles = nullptr, color = nullptr, own = nullptr,
               twist = nullptr;
  if (mesh.is_child(h)) interval = {record.interval.first, record.interval.second};
  if (!mesh.is_bar(h)) handles = json_list(record.handles);
  if (mesh.is_leaf(h)) {
    color = json(record.color);
    own = record.own_color;
    twist = json(record.twist, mesh.color_model());
  }
  return {{"id", h.value},
          {"origin", json(record.origin)},
          {"face", json(record.face)},
          {"next", json(record.next)},
          {"prev", json(record.prev)},
          {"twin", json(record.twin)},
          {"parent", json(record.parent)},
          {"children", json_list(mesh.children(h))},
          {"interval", interval},
          {"handles", handles},
          {"color", color},
          {"own_color", own},
          {"twist", twist}};
}

}  // namespace

ordered_json elements_json(const Mesh& mesh) {
  ordered_json points = ordered_json::array(), handles = points, faces = points, halfedges = points;
  for (const Point p : mesh.points())
    points.push_back({{"id", p.value},
                      {"position", json(mesh[p].position)},
                      {"halfedge", json(mesh[p].halfedge)},
                      {"stem", json(mesh[p].stem)}});
  for (const Handle h : mesh.handles())
    handles.push_back({{"id", h.value},
                       {"halfedge", json(mesh[h].halfedge)},
                       {"tangent", json(mesh[h].tangent, mesh.color_model())}});
  for (const Face f : mesh.faces())
    faces.push_back({{"id", f.value}, {"halfedges", json_list(mesh.sides(f))}});
  for (const Halfedge h : mesh.halfedges()) halfedges.push_back(halfedge_json(mesh, h));
  return {{"points", points}, {"handles", handles}, {"faces", faces}, {"halfedges", halfedges}};
}

}  // namespace gradmesh
