#include <stdexcept>

#include "simplify/simplify.h"

namespace gradmesh {

const char* name(Method method) {
  switch (method) {
    case Method::grid:
      return "grid";
  }
  return "";
}

const char* name(MetricKind metric) { return metric == MetricKind::flip ? "flip" : "ssim"; }

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
  if (wanted == name(Method::grid)) return Method::grid;
  throw std::invalid_argument("the method '" + wanted + "' is not known; there is: grid.");
}

MetricKind metric_named(const std::string& wanted) {
  for (const MetricKind metric : {MetricKind::flip, MetricKind::ssim})
    if (wanted == name(metric)) return metric;
  throw std::invalid_argument("the metric '" + wanted + "' is not known; there are: flip, ssim.");
}

}  // namespace gradmesh
