#include "metric/worst_places.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "metric/detail_errors.h"

namespace gradmesh {

std::vector<WorstPlace> worst_places(const Plane& errors, const Raster<std::uint8_t, 1>& counts,
                                     int most) {
  constexpr double apart = 32;
  Plane details(errors.window());
  update_detail_errors(errors, counts, errors.window(), details);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < details.samples.size(); ++i)
    if (details.samples[i] > 0) order.push_back(i);
  std::ranges::stable_sort(order, std::greater{},
                           [&](std::size_t i) { return details.samples[i]; });
  std::vector<WorstPlace> worst;
  for (const std::size_t i : order) {
    if (int(worst.size()) >= most) break;
    const auto width = std::size_t(details.width);
    const glm::dvec2 place(double(i % width), double(i / width));
    const auto is_close = [&](const WorstPlace& other) {
      return glm::distance(place, other.place) < apart;
    };
    if (std::ranges::none_of(worst, is_close)) worst.push_back({place, details.samples[i]});
  }
  return worst;
}

}  // namespace gradmesh
