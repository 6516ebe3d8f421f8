#include "service/sessions.h"

#include <cmath>
#include <stdexcept>

#include "service/results.h"

namespace gradmesh {
namespace {

Json name_json(const Message* name) { return name ? message_json(*name) : Json(); }

}  // namespace

Editing& editing(const Call& call) {
  const auto id = call.get<std::string>("id");
  const auto found = call.sessions().find(id);
  if (found == call.sessions().end())
    throw std::invalid_argument("there is no session over '" + id + "'.");
  return *found->second;
}

MeshKind kind_named(const std::string& wanted) {
  for (const MeshKind kind : {MeshKind::one_gradient, MeshKind::blocks})
    if (wanted == name(kind)) return kind;
  throw std::invalid_argument("a mesh is one gradient or blocks, not '" + wanted + "'.");
}

/// Returns the map from mesh units to the pixels of a picture, which shows the place (x, y) of what
/// a person sees in its middle.
Affine to_pixels(const Call& call) {
  const double scale = call.get<double>("scale");
  const glm::dvec2 middle(call.get<double>("x"), call.get<double>("y"));
  const glm::dvec2 half = glm::dvec2(call.get<int>("width"), call.get<int>("height")) / 2.0;
  if (!(scale > 0) || !std::isfinite(scale)) throw std::invalid_argument("a scale is above 0.");
  return Affine::translation(half) * Affine::scaling(glm::dvec2(scale)) *
         Affine::translation(-middle) * editing(call).view;
}

/// Returns the patches of the mesh that is shown whose numbers are an argument.
std::vector<Face> faces(const Call& call, const std::string& name) {
  return session(call).shown().faces_numbered(call.get<std::vector<int>>(name, {}));
}

Json numbers(const std::vector<Face>& faces) {
  Json list = Json::array();
  for (const Face face : faces) list.push_back(face.value);
  return list;
}

Json counts_json(const Candidate& shown, int objects) {
  const MeshCounts counts = shown.counts();
  return {{"handles", counts.handles},
          {"patches", counts.patches},
          {"objects", objects},
          {"error", shown.error},
          {"local_error", shown.local_error}};
}

Json status_json(const Editing& editing) {
  const Session& session = editing.session;
  Json json = counts_json(session.shown().now(), editing.objects());
  json["before"] = counts_json(session.shown().start(), editing.objects_before);
  json["form"] = name(session.shown().form());
  json["state"] = session.shown().state();
  json["unchanged"] = session.shown().is_unchanged();
  json["undo"] = name_json(session.history().undo_name());
  json["redo"] = name_json(session.history().redo_name());
  json["weighted"] = session.shown().problem().frame().weights != nullptr;
  json["protected"] = numbers(session.shown().protected_faces());
  return json;
}

}  // namespace gradmesh
