#include "app/export/results_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ranges>

#include "form/handles.h"
#include "simplify/options.h"

namespace gradmesh {
namespace {

using nlohmann::ordered_json;

ordered_json weights_json(const std::vector<std::pair<std::string, double>>& weights) {
  ordered_json list = ordered_json::array();
  for (const auto& [id, factor] : weights) list.push_back({{"id", id}, {"factor", factor}});
  return list;
}

ordered_json errors_json(const PictureErrors& errors) {
  return {{"rmse", errors.rmse}, {"mean", errors.mean}, {"flip", errors.flip}};
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

ordered_json mesh_json(const MeshSource& document, const MeshEntry& entry) {
  ordered_json role = nullptr;
  if (entry.role) role = *entry.role == PaintRole::fill ? "fill" : "stroke";
  ordered_json json = {{"id", entry.id}, {"role", role}, {"simplified", entry.simplified}};
  if (entry.refused) return json;
  const Mesh& mesh = document.mesh(entry);
  const auto is_junction = [&](Point p) { return mesh[p].is_junction(); };
  json.update({{"remembers", document.remembered_original(entry) != nullptr},
               {"color_model", name(mesh.color_model())},
               {"smooth", mesh.is_smooth()},
               {"handles", count_handles(mesh)},
               {"patches", mesh.face_count()},
               {"objects", document.objects(entry)},
               {"points", std::ranges::distance(mesh.points())},
               {"t_junctions", std::ranges::count_if(mesh.points(), is_junction)}});
  return json;
}

ordered_json result_json(const MeshSource& document, const MeshReport& report,
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

ordered_json tracing_json(const Tracing& tracing) {
  return {{"handles", tracing.counts.handles},
          {"patches", tracing.counts.patches},
          {"rows", tracing.rows},
          {"columns", tracing.columns},
          {"errors", errors_json(tracing.errors)},
          {"errors_without_detail", errors_json(tracing.errors_without_detail)},
          {"unused_guides", tracing.unused_guides},
          {"stopped", tracing.was_stopped},
          {"seconds", tracing.seconds}};
}

ordered_json curve_json(MeshKind kind, const StateCurve& curve) {
  ordered_json states = ordered_json::array();
  for (const CurveState& state : curve.states)
    states.push_back({{"handles", state.counts.handles},
                      {"patches", state.counts.patches},
                      {"objects", state.objects},
                      {"error", state.error},
                      {"local_error", state.local_error}});
  ordered_json marks = ordered_json::object();
  for (const auto& [amount, state] : curve.marks) marks[amount] = state;
  return {{"kind", name(kind)}, {"states", states}, {"marks", marks}};
}

ordered_json curves_json(const std::vector<MeshCurve>& curves) {
  ordered_json meshes = ordered_json::array();
  for (const MeshCurve& c : curves) {
    ordered_json& mesh = meshes.emplace_back(ordered_json{{"id", c.entry.id}});
    mesh.update(curve_json(c.kind, c.curve));
  }
  return {{"meshes", meshes}};
}

ordered_json traced_curve_json(const std::string& id, const StateCurve& curve) {
  ordered_json mesh{{"id", id}};
  mesh.update(curve_json(MeshKind::one_gradient, curve));
  return {{"meshes", ordered_json::array({std::move(mesh)})}};
}

}  // namespace gradmesh
