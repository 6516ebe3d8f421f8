#include "service/options.h"

#include <cmath>
#include <stdexcept>

#include "app/runs/devices.h"
#include "base/utf8_path.h"

namespace gradmesh {

namespace {

/// Sets one option of a run to an argument, if that is not null.
struct Reading {
  const Call& call;
  const std::string& name;
  RunOptions& options;

  template <class T>
  void operator()(T SimplifyOptions::*member) const {
    if (call.has(name)) options.*member = call.get<T>(name);
  }
  void operator()(const NamedValue& value) const {
    if (call.has(name)) value.set(options, call.get<std::string>(name));
  }
};

/// Returns the polygons that an argument lists, each as x, y, x, y, ...
std::vector<FilledOutline> polygons(const Call& call, const std::string& name) {
  std::vector<FilledOutline> areas;
  for (const auto& numbers : call.get<std::vector<std::vector<double>>>(name, {})) {
    if (numbers.size() < 6 || numbers.size() % 2 != 0)
      throw std::invalid_argument("a polygon has three points or more.");
    areas.push_back({{{}}, FillRule::nonzero});
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
      if (!std::isfinite(numbers[i]) || !std::isfinite(numbers[i + 1]))
        throw std::invalid_argument("the points of a polygon are finite.");
      areas.back().outline.front().emplace_back(numbers[i], numbers[i + 1]);
    }
  }
  return areas;
}

void check_amount(const Call& call) {
  if (!call.has("amount")) return;
  for (const std::string& name : replaced_by_amount)
    if (call.has(name))
      throw std::invalid_argument("an amount has bounds of its own, beside which there is no " +
                                  name + ".");
}

}  // namespace

std::filesystem::path path_argument(const Call& call, const std::string& name) {
  return utf8_path(call.get<std::string>(name, ""));
}

RunOptions run_options(const Call& call) {
  RunOptions options;
  check_amount(call);
  for (const OptionEntry& option : all_options())
    std::visit(Reading{call, option.name, options}, option.value);
  options.protect = call.get<std::vector<std::string>>("protect", {});
  options.protect_areas = polygons(call, "protect_areas");
  options.weights = call.get<std::vector<std::pair<std::string, double>>>("weights", {});
  options.progress = call.progress();
  return options;
}

void take_renderer(RunOptions& options, const Call& call) {
  const std::string renderer = call.get<std::string>("renderer", name(Renderer::automatic));
  use_renderer(options, renderer_named(renderer), call.device_lost());
}

PricePaths analysis_paths(const Call& call) {
  return {path_argument(call, "load_analysis"), path_argument(call, "save_analysis"),
          path_argument(call, "analysis_cache")};
}

MeasureOptions measure_options(const Call& call) {
  MeasureOptions options;
  options.metric = metric_named(call.get<std::string>("metric", name(options.metric)));
  options.resolution = call.get("resolution", options.resolution);
  check_resolution(options.resolution);
  return options;
}

}  // namespace gradmesh
