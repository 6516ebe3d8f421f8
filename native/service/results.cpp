#include "service/results.h"

#include "form/handles.h"
#include "mesh/mesh.h"

namespace gradmesh {
namespace {

Json argument_json(const Message::Argument& argument) {
  if (const auto* message = std::get_if<Message>(&argument)) return message_json(*message);
  return std::get<std::string>(argument);
}

Json refusal_json(const std::optional<Message>& refused) {
  return refused ? message_json(*refused) : Json();
}

Json mesh_json(const Document& document, const MeshEntry& entry) {
  Json role;
  if (entry.role) role = *entry.role == PaintRole::fill ? "fill" : "stroke";
  Json json = {{"id", entry.id},
               {"role", role},
               {"simplified", entry.simplified},
               {"smooth", false},
               {"handles", 0},
               {"patches", 0},
               {"objects", 0},
               {"refused", refusal_json(entry.refused)}};
  if (entry.refused) return json;
  const Mesh& mesh = document.mesh(entry);
  json["smooth"] = mesh.is_smooth();
  json["handles"] = count_handles(mesh);
  json["patches"] = mesh.face_count();
  json["objects"] = document.objects(entry);
  return json;
}

Json report_json(const MeshReport& report) {
  const SimplifyResult& r = report.result;
  return {{"id", report.id},
          {"method", r.method},
          {"handles_before", r.handles_before},
          {"handles_after", r.handles_after},
          {"patches_before", r.patches_before},
          {"patches_after", r.patches_after},
          {"objects", r.objects},
          {"changed", r.changed},
          {"error", r.error},
          {"local_error", r.local_error},
          {"evaluations", r.evaluations},
          {"renderer", r.renderer},
          {"stopped", report.refused ? "refused" : name(r.stopped)},
          {"seconds", r.seconds.total},
          {"refused", refusal_json(report.refused)}};
}

}  // namespace

Json message_json(const Message& message) {
  Json arguments = Json::array();
  for (const Message::Argument& a : message.arguments()) arguments.push_back(argument_json(a));
  return Json::array({message.text(), arguments});
}

Json meshes_json(const Document& document) {
  Json list = Json::array();
  for (const MeshEntry& entry : document.meshes())
    if (!entry.kept) list.push_back(mesh_json(document, entry));
  // Says that there is none.
  if (list.empty()) document.selected({});
  return list;
}

Json reports_json(const std::vector<MeshReport>& reports) {
  Json list = Json::array();
  for (const MeshReport& report : reports) list.push_back(report_json(report));
  return list;
}

Json update_json(const UpdateReport& report) {
  return {{"id", report.id},
          {"handles", report.counts.handles},
          {"patches", report.counts.patches},
          {"objects", report.objects},
          {"changed", report.changed}};
}

Json edit_json(const EditReport& report) {
  return {{"id", report.id},
          {"handles_before", report.before.handles},
          {"handles_after", report.after.handles},
          {"patches_before", report.before.patches},
          {"patches_after", report.after.patches},
          {"objects", report.objects},
          {"error", report.error}};
}

Json published_json(const PublishedMesh& mesh) {
  return {{"id", mesh.id},       {"shown_as", name(mesh.as)},
          {"width", mesh.width}, {"height", mesh.height},
          {"bytes", mesh.bytes}, {"refused", refusal_json(mesh.refused)}};
}

}  // namespace gradmesh
