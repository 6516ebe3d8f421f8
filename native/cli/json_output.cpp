#include "cli/json_output.h"

#include <ranges>

namespace gradmesh {
namespace {

nlohmann::ordered_json role_json(const MeshEntry& entry) {
  if (!entry.role) return nullptr;
  return *entry.role == PaintRole::fill ? "fill" : "stroke";
}

}  // namespace

nlohmann::ordered_json report_json(const std::vector<MeshReport>& reports,
                                   const SimplifyOptions& options) {
  nlohmann::ordered_json meshes = nlohmann::ordered_json::array();
  for (const auto& [id, result] : reports)
    meshes.push_back({{"id", id},
                      {"method", name(options.method)},
                      {"metric", name(options.metric)},
                      {"epsilon", options.epsilon},
                      {"resolution", options.resolution},
                      {"seed", options.seed},
                      {"omega", options.omega},
                      {"kappa", options.kappa},
                      {"patches_before", result.patches_before},
                      {"patches_after", result.patches_after},
                      {"error", result.error},
                      {"evaluations", result.evaluations},
                      {"seconds",
                       {{"total", result.seconds.total},
                        {"rasterize", result.seconds.rasterize},
                        {"select", result.seconds.select},
                        {"verify", result.seconds.verify}}},
                      {"stopped", name(result.stopped)}});
  return {{"meshes", meshes}};
}

nlohmann::ordered_json info_json(const Document& document) {
  nlohmann::ordered_json meshes = nlohmann::ordered_json::array();
  for (const MeshEntry& entry : document.selected({})) {
    const Mesh mesh = document.mesh(entry);
    const auto is_junction = [&](Point p) { return mesh[p].is_junction(); };
    meshes.push_back({{"id", entry.id},
                      {"role", role_json(entry)},
                      {"simplified", entry.simplified},
                      {"patches", mesh.face_count()},
                      {"points", std::ranges::distance(mesh.points())},
                      {"t_junctions", std::ranges::count_if(mesh.points(), is_junction)}});
  }
  return {{"file", document.name()}, {"meshes", meshes}};
}

}  // namespace gradmesh
