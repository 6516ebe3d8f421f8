#include "formats/pdf/page/blend_mode.h"

#include <array>
#include <utility>

namespace gradmesh {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 15> words{
    {{"/Multiply", "multiply"},
     {"/Screen", "screen"},
     {"/Overlay", "overlay"},
     {"/Darken", "darken"},
     {"/Lighten", "lighten"},
     {"/ColorDodge", "color-dodge"},
     {"/ColorBurn", "color-burn"},
     {"/HardLight", "hard-light"},
     {"/SoftLight", "soft-light"},
     {"/Difference", "difference"},
     {"/Exclusion", "exclusion"},
     {"/Hue", "hue"},
     {"/Saturation", "saturation"},
     {"/Color", "color"},
     {"/Luminosity", "luminosity"}}};

}  // namespace

std::string blend_mode_of(QPDFObjectHandle modes) {
  if (modes.isArray()) {
    for (QPDFObjectHandle mode : modes.getArrayAsVector())
      if (mode.isName())
        if (const std::string word = blend_mode_of(mode); word != "normal") return word;
    return "normal";
  }
  if (modes.isName())
    for (const auto& [name, word] : words)
      if (modes.getName() == name) return word;
  return "normal";
}

}  // namespace gradmesh
