#include "service/options.h"

#include "app/devices.h"
#include "base/utf8_path.h"

namespace gradmesh {

std::filesystem::path path_argument(const Call& call, const std::string& name) {
  const std::string path = call.get<std::optional<std::string>>(name).value_or("");
  return utf8_path(path);
}

RunOptions pricing_options(const Call& call) {
  RunOptions options;
  options.metric = metric_named(call.get<std::string>("metric"));
  options.epsilon = call.get<double>("epsilon");
  options.resolution = call.get<int>("resolution");
  if (const auto model = call.get<std::optional<std::string>>("color_model"))
    options.color_model = color_model_named(*model);
  options.threads = call.get<int>("threads");
  return options;
}

RunOptions run_options(const Call& call) {
  RunOptions options = pricing_options(call);
  take_renderer(options, call);
  options.method = call.get<std::string>("method");
  method_named(options.method);
  options.max_local_error = call.get<std::optional<double>>("max_local_error");
  options.handles = call.get<std::optional<int>>("handles");
  options.patches = call.get<std::optional<int>>("patches");
  options.ratio = call.get<std::optional<double>>("ratio");
  if (const auto count = call.get<std::optional<std::string>>("count"))
    options.count = count_named(*count);
  options.visible_only = call.get<bool>("visible_only");
  options.seed = call.get<std::uint64_t>("seed");
  options.omega = call.get<double>("omega");
  options.kappa = call.get<double>("kappa");
  options.edges = call.get<std::vector<int>>("edges");
  options.time_budget = call.get<double>("time_budget");
  options.progress = call.progress();
  return options;
}

AnalysisPaths analysis_paths(const Call& call) {
  return {path_argument(call, "load_analysis"), path_argument(call, "save_analysis"),
          path_argument(call, "analysis_cache")};
}

MeasureOptions measure_options(const Call& call) {
  const int resolution = call.get<int>("resolution");
  check_resolution(resolution);
  return {metric_named(call.get<std::string>("metric")), resolution};
}

void take_renderer(RunOptions& options, const Call& call) {
  use_renderer(options, renderer_named(call.get<std::string>("renderer")), call.device_lost());
}

}  // namespace gradmesh
