#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "formats/pdf/grid/joined_curves.h"
#include "formats/pdf/grid/page_patch.h"
#include "formats/pdf/grid/welded_points.h"

namespace gradmesh {

/// Two chains of sides along one line, one on either side of it, that are not the same curve:
/// `there` runs against `here`. What lies between two sides of a chain is a T-junction; chains of
/// one side each differ by more than what rounds them.
struct Slit {
  std::vector<int> here, there;
};

/// How the sides of loose patches lie along each other. Side k of patch n is side 4 n + k; sides
/// run clockwise (y down), so patches that are listed the other way around are mirrored.
class LooseSides {
 public:
  LooseSides(const std::vector<PagePatch>& patches, double tolerance);

  int count() const { return int(sides_.size()); }
  const std::vector<PagePatch>& patches() const { return patches_; }
  const ControlRow& curve(int side) const { return at(side).curve; }
  int from(int side) const { return at(side).points[0]; }
  int to(int side) const { return at(side).points[3]; }
  glm::dvec2 point(int number) const { return welded_.point(number); }
  static int patch(int side) { return side / 4; }
  static int next(int side) { return side / 4 * 4 + (side + 1) % 4; }
  static int previous(int side) { return side / 4 * 4 + (side + 3) % 4; }

  /// Returns the side that is the same curve as this one and runs against it, or -1.
  int twin(int side) const { return at(side).twin; }
  /// Returns the slit of which a side is a part; null if it is none.
  const Slit* slit(int side) const;
  const std::vector<Slit>& slits() const { return slits_; }
  /// Returns the side that ends where this one starts, beyond it; -1 if there is none.
  int across(int side) const { return at(side).across; }

 private:
  struct Side {
    ControlRow curve{};
    std::array<int, 4> points{};
    double length = 0;
    int twin = -1, across = -1, slit = -1;
  };
  using Chain = std::vector<int>;

  void add(PagePatch patch);
  void find_twins();
  void find_slits();
  std::optional<Slit> slit_from(int here, int there) const;
  bool lengthen(Chain& chain, bool is_forward) const;
  /// Return where a side goes where it starts and ends; (0, 0) if it is one point.
  glm::dvec2 start_direction(int side) const;
  glm::dvec2 end_direction(int side) const;
  bool lies_along(const Chain& chain, const Chain& other) const;
  double chain_length(const Chain& chain) const;
  bool is_loose(int side) const;
  void keep(Slit slit);
  const Side& at(int side) const { return sides_[std::size_t(side)]; }

  const double tolerance_;
  WeldedPoints welded_;
  std::vector<PagePatch> patches_;
  std::vector<Side> sides_;
  std::vector<Slit> slits_;
  /// The sides that start and that end at a point, without a twin.
  std::map<int, std::vector<int>> starting_, ending_;
};

}  // namespace gradmesh
