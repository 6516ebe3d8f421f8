#include "service/results.h"
#include "app/export/results_json.h"

namespace gradmesh {
namespace {

Json argument_json(const Message::Argument& argument) {
  if (const auto* message = std::get_if<Message>(&argument)) return message_json(*message);
  return std::get<std::string>(argument);
}

Json refusal_json(const std::optional<Message>& refused) {
  return refused ? message_json(*refused) : Json();
}

}  // namespace

Json message_json(const Message& message) {
  Json arguments = Json::array();
  for (const Message::Argument& a : message.arguments()) arguments.push_back(argument_json(a));
  return Json::array({message.text(), arguments});
}

Json meshes_json(const Document& document) {
  Json list = Json::array();
  for (const MeshEntry& entry : document.meshes()) {
    if (entry.kept) continue;
    Json& mesh = list.emplace_back(mesh_json(document, entry));
    mesh["refused"] = refusal_json(entry.refused);
  }
  // Says that there is none.
  if (list.empty()) document.selected({});
  return list;
}

Json results_json(const Document& document, const std::vector<MeshReport>& reports,
                  const RunOptions& options, const std::string& original) {
  Json list = Json::array();
  for (const MeshReport& report : reports) {
    Json& result = list.emplace_back(result_json(document, report, options, original));
    result["changed"] = report.result.changed;
    result["refused"] = refusal_json(report.refused);
  }
  return list;
}

Json update_json(const UpdateReport& report) {
  return {{"id", report.id},
          {"handles", report.counts.handles},
          {"patches", report.counts.patches},
          {"objects", report.objects},
          {"changed", report.changed}};
}

Json published_json(const PublishedMesh& mesh) {
  return {{"id", mesh.id},       {"shown_as", name(mesh.as)},
          {"width", mesh.width}, {"height", mesh.height},
          {"bytes", mesh.bytes}, {"refused", refusal_json(mesh.refused)}};
}

Json published_code_json(const PublishedCode& mesh) {
  Json lost = Json::array();
  for (const Message& sentence : mesh.lost) lost.push_back(message_json(sentence));
  return {{"id", mesh.id},
          {"name", mesh.name},
          {"source", mesh.source},
          {"lost", lost},
          {"refused", refusal_json(mesh.refused)}};
}

}  // namespace gradmesh
