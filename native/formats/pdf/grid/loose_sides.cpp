#include "formats/pdf/grid/loose_sides.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "geom/cross.h"

namespace gradmesh {
LooseSides::LooseSides(const std::vector<PagePatch>& patches, double tolerance)
    : tolerance_(tolerance), welded_(tolerance) {
  for (const PagePatch& patch : patches) {
    const bool is_clockwise =
        cross(patch.outer[6] - patch.outer[0], patch.outer[9] - patch.outer[3]) >= 0;
    add(is_clockwise ? patch : patch.mirrored());
  }
  find_twins();
  find_slits();
}

const Slit* LooseSides::slit(int side) const {
  return at(side).slit < 0 ? nullptr : &slits_[std::size_t(at(side).slit)];
}

void LooseSides::add(PagePatch patch) {
  std::array<int, PagePatch::outer_count> points{};
  for (std::size_t n = 0; n < points.size(); ++n) {
    points[n] = welded_.number(patch.outer[n]);
    patch.outer[n] = welded_.point(points[n]);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    Side& side = sides_.emplace_back();
    for (std::size_t n = 0; n < 4; ++n) {
      side.points[n] = points[(3 * k + n) % points.size()];
      side.curve[n] = patch.side_point(k, n);
    }
    side.length = length_of(side.curve);
  }
  patches_.push_back(std::move(patch));
}

void LooseSides::find_twins() {
  std::map<std::array<int, 4>, Chain> by_points;
  for (int side = 0; side < count(); ++side) by_points[at(side).points].push_back(side);
  for (int side = 0; side < count(); ++side) {
    std::array<int, 4> points = at(side).points;
    // A side that is one point lies along nothing.
    const bool is_point = std::ranges::count(points, points[0]) == 4;
    const bool is_only = by_points[points].size() == 1;
    std::ranges::reverse(points);
    const auto others = by_points.find(points);
    const bool is_pair = !is_point && is_only && others != by_points.end() &&
                         others->second.size() == 1 && patch(others->second[0]) != patch(side);
    if (is_pair) {
      sides_[std::size_t(side)].twin = others->second[0];
      sides_[std::size_t(side)].across = others->second[0];
    } else if (!is_point) {
      starting_[from(side)].push_back(side);
      ending_[to(side)].push_back(side);
    }
  }
}

void LooseSides::find_slits() {
  // More than there are at any point of a mesh; time does not grow with the square of their number.
  constexpr std::size_t most = 16;
  for (int here = 0; here < count(); ++here) {
    const auto others = ending_.find(from(here));
    if (others == ending_.end() || others->second.size() > most) continue;
    for (const int there : others->second)
      if (is_loose(here) && is_loose(there) && patch(there) != patch(here))
        if (auto slit = slit_from(here, there)) keep(*std::move(slit));
  }
}

bool LooseSides::is_loose(int side) const {
  return at(side).twin < 0 && at(side).slit < 0 && from(side) != to(side);
}

/// Follows the line from the start of one side, which is the end of the other.
std::optional<Slit> LooseSides::slit_from(int here, int there) const {
  // More than there are on any side that an artist has divided.
  constexpr std::size_t most = 32;
  if (glm::dot(start_direction(here), end_direction(there)) > 0) return {};
  Slit slit{{here}, {there}};
  while (to(slit.here.back()) != from(slit.there.back())) {
    const bool is_here_shorter = chain_length(slit.here) < chain_length(slit.there);
    const bool is_longer =
        is_here_shorter ? lengthen(slit.here, true) : lengthen(slit.there, false);
    if (!is_longer || slit.here.size() + slit.there.size() > most) return {};
  }
  for (const int side : slit.here)
    if (std::ranges::any_of(slit.there, [&](int other) { return patch(other) == patch(side); }))
      return {};
  if (!lies_along(slit.here, slit.there) || !lies_along(slit.there, slit.here)) return {};
  std::ranges::reverse(slit.there);
  return slit;
}

/// Adds the side that goes on the most straight where a chain ends, if there is one.
bool LooseSides::lengthen(Chain& chain, bool is_forward) const {
  const auto& sides = is_forward ? starting_ : ending_;
  const int last = chain.back();
  const auto found = sides.find(is_forward ? to(last) : from(last));
  constexpr std::size_t most = 16;
  if (found == sides.end() || found->second.size() > most) return false;
  int best = -1;
  double least_turn = -1;
  for (const int side : found->second) {
    if (!is_loose(side) || std::ranges::find(chain, side) != chain.end()) continue;
    const double turn = is_forward ? glm::dot(end_direction(last), start_direction(side))
                                   : glm::dot(start_direction(last), end_direction(side));
    if (best >= 0 && turn <= least_turn) continue;
    best = side;
    least_turn = turn;
  }
  if (best >= 0) chain.push_back(best);
  return best >= 0;
}

glm::dvec2 LooseSides::start_direction(int side) const {
  const ControlRow& row = curve(side);
  for (std::size_t n = 1; n < 4; ++n)
    if (row[n] != row[0]) return glm::normalize(row[n] - row[0]);
  return {};
}

glm::dvec2 LooseSides::end_direction(int side) const {
  const ControlRow& row = curve(side);
  for (std::size_t n = 3; n-- > 0;)
    if (row[n] != row[3]) return glm::normalize(row[3] - row[n]);
  return {};
}

bool LooseSides::lies_along(const Chain& chain, const Chain& other) const {
  // Each side has been rounded, and more so where it was joined of halves.
  const double hardly = 4 * tolerance_;
  const auto is_beside = [&](glm::dvec2 place) {
    return std::ranges::any_of(other, [&](int side) {
      const double at = nearest_on(curve(side), place);
      return glm::distance(cubic_of(curve(side)).at(at), place) <= hardly;
    });
  };
  return std::ranges::all_of(chain, [&](int side) {
    const auto line = cubic_of(curve(side));
    return is_beside(line.at(0.25)) && is_beside(line.at(0.75)) && is_beside(line.at(1));
  });
}

double LooseSides::chain_length(const Chain& chain) const {
  double sum = 0;
  for (const int side : chain) sum += at(side).length;
  return sum;
}

void LooseSides::keep(Slit slit) {
  const auto meets = [this](int a, int b) { sides_[std::size_t(a)].across = b; };
  meets(slit.here.front(), slit.there.back());
  meets(slit.there.front(), slit.here.back());
  for (const auto* chain : {&slit.here, &slit.there})
    for (const int side : *chain) sides_[std::size_t(side)].slit = int(slits_.size());
  slits_.push_back(std::move(slit));
}

}  // namespace gradmesh
