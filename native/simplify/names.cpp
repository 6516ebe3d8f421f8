#include <stdexcept>

#include "simplify/simplify.h"

namespace gradmesh {

const char* name(Method method) {
  switch (method) {
    case Method::random:
      return "random";
    case Method::grid:
      return "grid";
    case Method::dual_grid:
      return "dual-grid";
    case Method::motorcycle:
      return "motorcycle";
    case Method::gqe:
      return "gqe";
    case Method::gqe1:
      return "gqe1";
    case Method::best:
      return "best";
    case Method::lines:
      return "lines";
    case Method::manual:
      return "manual";
  }
  return "";
}

const char* name(MetricKind metric) { return metric == MetricKind::flip ? "flip" : "ssim"; }

const char* name(ColorModel model) {
  return model == ColorModel::bilinear ? "bilinear" : "bicubic";
}

const char* name(Stopped stopped) {
  switch (stopped) {
    case Stopped::done:
      return "done";
    case Stopped::budget:
      return "budget";
    case Stopped::cancelled:
      return "cancelled";
    case Stopped::nothing_to_merge:
      return "nothing to merge";
  }
  return "";
}

Method method_named(const std::string& wanted) {
  std::string known;
  for (const Method method : all_methods) {
    if (wanted == name(method)) return method;
    known.append(known.empty() ? "" : ", ").append(name(method));
  }
  throw std::invalid_argument("the method '" + wanted + "' is not known; there are: " + known +
                              ".");
}

MetricKind metric_named(const std::string& wanted) {
  for (const MetricKind metric : {MetricKind::flip, MetricKind::ssim})
    if (wanted == name(metric)) return metric;
  throw std::invalid_argument("the metric '" + wanted + "' is not known; there are: flip, ssim.");
}

ColorModel color_model_named(const std::string& wanted) {
  for (const ColorModel model : {ColorModel::bilinear, ColorModel::bicubic})
    if (wanted == name(model)) return model;
  throw std::invalid_argument("the color model '" + wanted +
                              "' is not known; there are: bilinear, bicubic.");
}

}  // namespace gradmesh
