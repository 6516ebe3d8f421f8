#include "formats/svg/values/color.h"
#include "target.h"

namespace gradmesh::fuzz {

void check(std::string_view text) {
  const auto color = parse_color(text);
  if (color)
    for (int k = 0; k < 3; ++k)
      require((*color)[k] >= 0 && (*color)[k] <= 1, "the channel is between 0 and 1");
}

}  // namespace gradmesh::fuzz
