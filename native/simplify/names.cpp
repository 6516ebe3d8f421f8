#include <stdexcept>

#include "simplify/simplify.h"

namespace gradmesh {

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

ColorModel color_model_named(const std::string& wanted) {
  for (const ColorModel model : {ColorModel::bilinear, ColorModel::bicubic})
    if (wanted == name(model)) return model;
  throw std::invalid_argument("the color model '" + wanted +
                              "' is not known; there are: bilinear, bicubic.");
}

}  // namespace gradmesh
