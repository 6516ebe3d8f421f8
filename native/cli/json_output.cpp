#include "cli/json_output.h"

namespace gradmesh {

nlohmann::ordered_json report_json(const std::vector<MeshReport>& reports,
                                   const SimplifyOptions& options, const std::string& original) {
  nlohmann::ordered_json meshes = nlohmann::ordered_json::array();
  const auto bound = options.max_local_error ? nlohmann::ordered_json(*options.max_local_error)
                                             : nlohmann::ordered_json();
  for (const auto& [id, result, refused] : reports) {
    if (refused) {
      meshes.push_back({{"id", id}, {"refused", refused->english()}});
      continue;
    }
    meshes.push_back({{"id", id},
                      {"method", result.method},
                      {"color_model", name(*options.color_model)},
                      {"metric", name(options.metric)},
                      {"epsilon", options.epsilon},
                      {"max_local_error", bound},
                      {"original", original.empty() ? nlohmann::ordered_json()
                                                    : nlohmann::ordered_json(original)},
                      {"resolution", options.resolution},
                      {"seed", options.seed},
                      {"omega", options.omega},
                      {"kappa", options.kappa},
                      {"handles_before", result.handles_before},
                      {"handles_after", result.handles_after},
                      {"patches_before", result.patches_before},
                      {"patches_after", result.patches_after},
                      {"objects", result.objects},
                      {"error", result.error},
                      {"local_error", result.local_error},
                      {"evaluations", result.evaluations},
                      {"renderer", result.renderer},
                      {"seconds",
                       {{"total", result.seconds.total},
                        {"rasterize", result.seconds.rasterize},
                        {"select", result.seconds.select}}},
                      {"stopped", name(result.stopped)}});
  }
  return {{"meshes", meshes}};
}

}  // namespace gradmesh
