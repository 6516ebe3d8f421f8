#include "simplify/options.h"

#include <cmath>
#include <stdexcept>

#include "base/limits.h"

namespace gradmesh {

void check(const SimplifyOptions& options) {
  if (!(options.epsilon >= 0 && options.epsilon <= 1))
    throw std::invalid_argument("epsilon must be between 0 and 1.");
  if (options.max_local_error && !(*options.max_local_error >= 0 && *options.max_local_error <= 1))
    throw std::invalid_argument("the largest local error must be between 0 and 1.");
  check_resolution(options.resolution);
  if (!std::isfinite(options.time_budget) || options.time_budget < 0)
    throw std::invalid_argument("the time budget must be 0 or more seconds.");
  if (!(options.omega >= 0 && options.omega <= 1))
    throw std::invalid_argument("omega must be between 0 and 1.");
  if (!std::isfinite(options.kappa) || options.kappa < 0)
    throw std::invalid_argument("kappa must be 0 or more.");
  if (options.threads < 0) throw std::invalid_argument("threads must be 0 or more.");
}

void check_resolution(int resolution) {
  const std::uint64_t most = limits().resolution;
  if (resolution < least_resolution || std::uint64_t(resolution) > most)
    throw std::invalid_argument("the resolution must be between 16 and " + std::to_string(most) +
                                " pixels.");
}

const char* name(ColorModel model) {
  return model == ColorModel::bilinear ? "bilinear" : "bicubic";
}

const char* name(Count count) { return count == Count::handles ? "handles" : "patches"; }

ColorModel color_model_named(const std::string& wanted) {
  for (const ColorModel model : {ColorModel::bilinear, ColorModel::bicubic})
    if (wanted == name(model)) return model;
  throw std::invalid_argument("the color model '" + wanted +
                              "' is not known; there are: bilinear, bicubic.");
}

Count count_named(const std::string& wanted) {
  for (const Count count : {Count::handles, Count::patches})
    if (wanted == name(count)) return count;
  throw std::invalid_argument("what is counted is handles or patches, not '" + wanted + "'.");
}

}  // namespace gradmesh
