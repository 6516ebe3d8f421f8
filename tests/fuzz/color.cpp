#include "formats/svg/values/color.h"
#include "target.h"

namespace gradmesh::fuzz {

void check(std::string_view text) {
  const auto color = parse_translucent_color(text);
  if (color)
    for (int k = 0; k < 4; ++k)
      require((*color)[k] >= 0 && (*color)[k] <= 1, "the channel is between 0 and 1");
  const std::string own = own_color_text(text);
  require(own.empty() || parse_translucent_color(own) == color, "the text is the same colour");
}

}  // namespace gradmesh::fuzz
