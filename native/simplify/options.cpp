#include <stdexcept>

#include "simplify/simplify.h"

namespace gradmesh {

const char* name(ColorModel model) {
  return model == ColorModel::bilinear ? "bilinear" : "bicubic";
}

const char* name(Count count) { return count == Count::handles ? "handles" : "patches"; }

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
