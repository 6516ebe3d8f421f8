#include "formats/pdf/grid/without_anchors.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "formats/pdf/grid/loose_sides.h"
#include "formats/pdf/grid/page_grids.h"

namespace gradmesh {
namespace {

/// Sides that follow one another, clockwise around a patch of the artist.
using SideChain = std::vector<int>;

/// Which patches lie along lines that end in T-junctions.
class AnchorLines {
 public:
  explicit AnchorLines(const LooseSides& sides)
      : sides_(sides),
        is_removed_(std::size_t(sides.count()), false),
        group_(sides.patches().size()) {
    std::iota(group_.begin(), group_.end(), 0);
    for (const Slit& slit : sides.slits())
      for (const auto* chain : {&slit.here, &slit.there})
        for (std::size_t n = 1; n < chain->size(); ++n)
          remove_line(LooseSides::next((*chain)[n - 1]));
    for (int patch = 0; patch < int(group_.size()); ++patch)
      group_[std::size_t(patch)] = root(patch);
  }

  bool is_removed(int side) const { return is_removed_[std::size_t(side)]; }
  /// Returns the least patch of those with which one is joined.
  int group(int patch) const { return group_[std::size_t(patch)]; }

 private:
  int root(int patch) {
    while (group(patch) != patch) patch = group_[std::size_t(patch)] = group(group(patch));
    return patch;
  }

  /// Removes the line that begins with a side, as far as it goes straight on.
  void remove_line(int side) {
    while (side >= 0 && !is_removed(side)) {
      const int last = remove_piece(side);
      side = last < 0 ? -1 : straight_on(last);
    }
  }

  /// Removes what a side is a part of as far as the next crossing, from both sides. Returns the
  /// last side there, or -1 if nothing lies beyond the line.
  int remove_piece(int side) {
    if (sides_.twin(side) >= 0) {
      join({side}, {sides_.twin(side)});
      return side;
    }
    const Slit* slit = sides_.slit(side);
    if (!slit) return -1;
    join(slit->here, slit->there);
    return side == slit->here.front()    ? slit->here.back()
           : side == slit->there.front() ? slit->there.back()
                                         : -1;
  }

  void join(const SideChain& here, const SideChain& there) {
    for (const auto* chain : {&here, &there})
      for (const int side : *chain) {
        is_removed_[std::size_t(side)] = true;
        const int a = root(LooseSides::patch(here.front())), b = root(LooseSides::patch(side));
        group_[std::size_t(std::max(a, b))] = std::min(a, b);
      }
  }

  /// Returns the side that goes straight on where one ends and four patches meet; -1 elsewhere.
  int straight_on(int side) const {
    int at = LooseSides::next(side), straight = -1;
    const int first = at;
    for (int corner = 0; corner < 4; ++corner) {
      const int across = sides_.across(at);
      if (across < 0) return -1;
      at = LooseSides::next(across);
      if (corner == 0) straight = at;
    }
    return at == first ? straight : -1;
  }

  const LooseSides& sides_;
  std::vector<bool> is_removed_;
  std::vector<int> group_;
};

class ArtistsPatches {
 public:
  ArtistsPatches(const LooseSides& sides, const AnchorLines& lines)
      : sides_(sides), lines_(lines) {}

  std::optional<JoinedPatches> run() {
    // More than there are on any side that an artist has divided.
    constexpr std::size_t most_parts = 32;
    std::map<int, std::vector<int>> corners;
    for (int side = 0; side < sides_.count(); ++side)
      if (!lines_.is_removed(side) && !lines_.is_removed(LooseSides::previous(side)))
        corners[lines_.group(LooseSides::patch(side))].push_back(side);
    std::vector<std::array<SideChain, 4>> around;
    for (int patch = 0; patch < int(sides_.patches().size()); ++patch) {
      if (lines_.group(patch) != patch) continue;
      if (corners[patch].size() != 4) return {};
      const auto chains = chains_from(corners[patch].front());
      if (!chains) return {};
      for (const SideChain& chain : *chains) {
        if (chain.size() > most_parts) return {};
        chains_[ends(chain)].push_back(chain);
      }
      around.push_back(*chains);
    }
    JoinedPatches joined;
    for (const auto& chains : around) joined.patches.push_back(patch_within(chains));
    joined.distance = distance_;
    // A side that bends more at an anchor than a cubic curve can.
    constexpr double largest_share = 0.03;
    if (largest_share_ > largest_share) return {};
    return joined;
  }

 private:
  std::pair<int, int> ends(const SideChain& chain) const {
    return {sides_.from(chain.front()), sides_.to(chain.back())};
  }

  /// Returns the four chains around a patch of the artist, the first of which begins with a side.
  std::optional<std::array<SideChain, 4>> chains_from(int first) const {
    std::array<SideChain, 4> chains;
    int side = first, steps = 0;
    for (SideChain& chain : chains) {
      bool is_corner = false;
      while (!is_corner) {
        if (++steps > sides_.count()) return {};
        chain.push_back(side);
        int next = LooseSides::next(side);
        is_corner = !lines_.is_removed(next);
        while (lines_.is_removed(next)) {
          const int across = sides_.across(next);
          if (across < 0 || ++steps > sides_.count()) return {};
          next = LooseSides::next(across);
        }
        side = next;
      }
    }
    if (side != first) return {};
    return chains;
  }

  /// Returns the curve along a chain: that of what lies beyond it where this is not divided.
  ControlRow curve_along(const SideChain& chain) {
    if (chain.size() == 1) return curve_of(chain.front());
    const auto [from, to] = ends(chain);
    const std::vector<CurvePart> along = parts_of(chain);
    std::vector<CurvePart> parts = along;
    const auto beyond = chains_.find({to, from});
    if (beyond != chains_.end() && beyond->second.size() == 1) {
      const SideChain& other = beyond->second.front();
      if (other.size() == 1) return reversed_row(sides_.curve(other.front()));
      for (const CurvePart& part : parts_of(other))
        parts.push_back({reversed_row(part.row), 1 - part.to, 1 - part.from});
    }
    const ControlRow line = closest_line(parts);
    for (const CurvePart& part : along) {
      const double here = distance_of_line(part.row, line);
      distance_ = std::max(distance_, here);
      largest_share_ = std::max(largest_share_, here / length_of(line));
    }
    return line;
  }

  /// Returns the curve of a side, the same to both patches where it is one but for rounding.
  ControlRow curve_of(int side) const {
    const Slit* slit = sides_.slit(side);
    if (!slit || slit->here.size() > 1 || slit->there.size() > 1 || slit->here.front() == side)
      return sides_.curve(side);
    return reversed_row(sides_.curve(slit->here.front()));
  }

  std::vector<CurvePart> parts_of(const SideChain& chain) const {
    std::vector<ControlRow> rows;
    for (const int side : chain) rows.push_back(sides_.curve(side));
    return parts_by_speed(rows);
  }

  PagePatch patch_within(const std::array<SideChain, 4>& chains) {
    PagePatch patch;
    bool is_joined = false;
    for (std::size_t k = 0; k < 4; ++k) {
      const int side = chains[k].front();
      is_joined = is_joined || chains[k].size() > 1;
      const ControlRow row = curve_along(chains[k]);
      for (std::size_t n = 0; n < 3; ++n) patch.outer[3 * k + n] = row[n];
      patch.colors[k] =
          sides_.patches()[std::size_t(LooseSides::patch(side))].colors[std::size_t(side % 4)];
    }
    if (is_joined)
      set_zero_twist(patch);
    else
      patch.inner = turned_inner(chains[0].front());
    return patch;
  }

  std::array<glm::dvec2, 4> turned_inner(int side) const {
    const PagePatch& patch = sides_.patches()[std::size_t(LooseSides::patch(side))];
    return patch.turned(std::size_t(side % 4)).inner;
  }

  const LooseSides& sides_;
  const AnchorLines& lines_;
  /// By the points where they start and end.
  std::map<std::pair<int, int>, std::vector<SideChain>> chains_;
  /// How far joined sides are from their parts, at most, also as a share of their lengths.
  double distance_ = 0, largest_share_ = 0;
};

std::optional<JoinedPatches> joined_along_lines(const std::vector<PagePatch>& patches,
                                                double tolerance) {
  const LooseSides sides(patches, tolerance);
  if (sides.slits().empty()) return {};
  const AnchorLines lines(sides);
  return ArtistsPatches(sides, lines).run();
}

bool is_one_grid(const std::vector<PagePatch>& patches, double tolerance) {
  return page_grids(PatchSides(patches, tolerance)).size() == 1;
}

}  // namespace

JoinedPatches without_anchors(const std::vector<PagePatch>& patches, double tolerance) {
  // More than an artist's grid with anchors has; it bounds the time that a stranger's takes.
  constexpr std::size_t most = 5000;
  if (patches.size() > most || is_one_grid(patches, tolerance)) return {patches, 0};
  // Between two anchors there may be patches that are hardly wider than errors of others.
  for (const double closer : {1.0, 0.5, 0.25, 0.125}) {
    auto joined = joined_along_lines(patches, closer * tolerance);
    if (joined && is_one_grid(joined->patches, tolerance)) return *std::move(joined);
  }
  return {patches, 0};
}

}  // namespace gradmesh
