#include "app/info.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ranges>

#include "form/handles.h"
#include "formats/json/elements.h"
#include "simplify/options.h"

namespace gradmesh {
namespace {

using nlohmann::ordered_json;

/// Appends a value as text: objects and arrays down to `depth` with a line for each member, deeper
/// ones in one line.
void append_text(const ordered_json& value, int depth, const std::string& indent,
                 std::string& out) {
  if (depth == 0 || !value.is_structured() || value.empty()) {
    out += value.dump();
    return;
  }
  const std::string inner = indent + "  ";
  out += value.is_object() ? "{" : "[";
  bool first = true;
  for (const auto& [key, member] : value.items()) {
    out += (first ? "\n" : ",\n") + inner;
    if (value.is_object()) out += ordered_json(key).dump() + ": ";
    append_text(member, depth - 1, inner, out);
    first = false;
  }
  out += "\n" + indent + (value.is_object() ? "}" : "]");
}

ordered_json weights_json(const std::vector<std::pair<std::string, double>>& weights) {
  ordered_json list = ordered_json::array();
  for (const auto& [id, factor] : weights) list.push_back({{"id", id}, {"factor", factor}});
  return list;
}

/// Returns what was found of an entry's mesh on a page; null if it was read from none.
const FoundMesh* found_of(const Document& document, const MeshEntry& entry) {
  if (!document.pages()) return nullptr;
  const auto& meshes = document.pages()->meshes;
  const auto found = std::ranges::find(meshes, entry.id, &FoundMesh::id);
  return found != meshes.end() ? &*found : nullptr;
}

}  // namespace

ordered_json found_json(const FoundMesh& found) {
  return {{"page", found.page},        {"number", found.number},
          {"type", found.type},        {"shadings", found.shadings},
          {"patches", found.patches},  {"handles", found.handles},
          {"rows", found.rows},        {"columns", found.columns},
          {"joined", found.is_joined}, {"record", found.is_from_record},
          {"smooth", found.is_smooth}, {"difference", found.difference}};
}

ordered_json mesh_json(const Document& document, const MeshEntry& entry) {
  ordered_json role = nullptr;
  if (entry.role) role = *entry.role == PaintRole::fill ? "fill" : "stroke";
  ordered_json json = {{"id", entry.id}, {"role", role}, {"simplified", entry.simplified}};
  if (entry.refused) return json;
  const Mesh& mesh = document.mesh(entry);
  const auto is_junction = [&](Point p) { return mesh[p].is_junction(); };
  json.update({{"remembers", document.remembers(entry)},
               {"color_model", name(mesh.color_model())},
               {"smooth", mesh.is_smooth()},
               {"handles", count_handles(mesh)},
               {"patches", mesh.face_count()},
               {"objects", document.objects(entry)},
               {"points", std::ranges::distance(mesh.points())},
               {"t_junctions", std::ranges::count_if(mesh.points(), is_junction)}});
  return json;
}

ordered_json result_json(const Document& document, const MeshReport& report,
                         const RunOptions& options, const std::string& original) {
  const SimplifyResult& result = report.result;
  const auto& seconds = result.seconds;
  const auto or_null = [](const auto& value) {
    return value ? ordered_json(*value) : ordered_json();
  };
  ordered_json json = {
      {"id", report.id},
      {"method", result.method},
      {"color_model", name(options.color_model.value_or(document.color_model()))},
      {"metric", name(options.metric)},
      {"epsilon", options.epsilon},
      {"max_local_error", or_null(options.max_local_error)},
      {"max_detail_error", or_null(options.max_detail_error)},
      {"original", original.empty() ? ordered_json() : ordered_json(original)},
      {"resolution", options.resolution},
      {"seed", options.seed},
      {"omega", options.omega},
      {"kappa", options.kappa},
      {"handles_before", result.handles_before},
      {"handles_after", result.handles_after},
      {"patches_before", result.patches_before},
      {"patches_after", result.patches_after},
      {"objects", result.objects},
      {"protected_patches", result.mesh.fixed_face_count()},
      {"error", result.error},
      {"error_before", result.error_before},
      {"local_error", result.local_error},
      {"detail_error", result.detail_error},
      {"evaluations", result.evaluations},
      {"renderer", result.renderer},
      {"seconds",
       {{"total", seconds.total}, {"rasterize", seconds.rasterize}, {"select", seconds.select}}},
      {"stopped", report.refused ? "refused" : name(result.stopped)}};
  if (!options.weights.empty()) json["weights"] = weights_json(options.weights);
  return json;
}

ordered_json edit_json(const EditReport& report) {
  return {{"id", report.id},
          {"handles_before", report.before.handles},
          {"handles_after", report.after.handles},
          {"patches_before", report.before.patches},
          {"patches_after", report.after.patches},
          {"objects", report.objects},
          {"error", report.error}};
}

ordered_json info_json(const Document& document) {
  ordered_json meshes = ordered_json::array(), unused = ordered_json::array();
  for (const MeshEntry& entry : document.meshes()) {
    if (entry.kept) continue;
    ordered_json& mesh = meshes.emplace_back(mesh_json(document, entry));
    if (entry.refused)
      mesh["refused"] = entry.refused->english();
    else
      mesh["elements"] = elements_json(document.mesh(entry));
    if (const FoundMesh* const found = found_of(document, entry))
      mesh["found"] = found_json(*found);
  }
  for (const UnusedMesh& mesh : document.unused())
    unused.push_back({{"id", mesh.id}, {"patches", mesh.patches}});
  // Says that there is none.
  if (meshes.empty() && unused.empty()) document.selected({});
  ordered_json json = {{"file", document.name()},
                       {"kind", document.pages() ? document.pages()->kind : document.format().name},
                       {"meshes", meshes},
                       {"unused", unused}};
  if (document.pages()) {
    ordered_json left_out = ordered_json::array();
    for (const Message& sentence : document.pages()->left_out)
      left_out.push_back(sentence.english());
    json["left_out"] = left_out;
  }
  return json;
}

std::string info_text(const Document& document) {
  // file, meshes / mesh / elements / points / point
  constexpr int depth_of_elements = 5;
  std::string text;
  append_text(info_json(document), depth_of_elements, "", text);
  return text + "\n";
}

}  // namespace gradmesh
