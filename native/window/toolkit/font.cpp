#include "window/toolkit/font.h"

#include <imgui.h>

#include "dejavu_sans.h"

namespace gradmesh {

void add_font(ImFontAtlas& fonts, float density) {
  constexpr float pixels = 15;
  // Latin to its extended letters, then what of punctuation, arrows and signs the font has.
  static constexpr ImWchar ranges[] = {0x20,   0x17f,  0x2013, 0x203a, 0x2190,
                                       0x2193, 0x21b6, 0x21b7, 0x2212, 0x2212,
                                       0x25b6, 0x25c0, 0x2713, 0x2713, 0};
  ImFontConfig config;
  // The atlas reads the letters, and never frees them.
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = config.OversampleV = 2;
  fonts.AddFontFromMemoryTTF(const_cast<unsigned char*>(dejavu::DejaVuSans_Latin_ttf),
                             int(sizeof dejavu::DejaVuSans_Latin_ttf), density * pixels, &config,
                             ranges);
}

}  // namespace gradmesh
