#include "formats/pdf/grid/page_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>

#include "formats/pdf/grid/welded_points.h"
#include "geom/cross.h"

namespace gradmesh {
namespace {

using Curve = std::array<glm::dvec2, 4>;
/// The numbers of a curve's welded points.
using CurvePoints = std::array<int, 4>;

Curve reversed(Curve curve) {
  std::ranges::reverse(curve);
  return curve;
}

/// Returns the parts [0, t] and [t, 1] of a curve, by de Casteljau's rule.
std::array<Curve, 2> parts_at(const Curve& c, double t) {
  const auto between = [t](glm::dvec2 a, glm::dvec2 b) { return a + t * (b - a); };
  const glm::dvec2 a = between(c[0], c[1]), b = between(c[1], c[2]), d = between(c[2], c[3]);
  const glm::dvec2 ab = between(a, b), bd = between(b, d), middle = between(ab, bd);
  return {{{c[0], a, ab, middle}, {middle, bd, d, c[3]}}};
}

bool is_same(const Curve& a, const Curve& b, double tolerance) {
  return std::ranges::equal(a, b, [tolerance](glm::dvec2 p, glm::dvec2 q) {
    return std::abs(p.x - q.x) <= tolerance && std::abs(p.y - q.y) <= tolerance;
  });
}

/// Returns the share of a curve that another is the beginning of; nothing if it is not.
std::optional<double> share_of(const Curve& part, const Curve& curve, double tolerance) {
  // The first point away from the start comes nearer to it as the share does, or, where handles
  // have no length, as its square or cube.
  for (std::size_t n = 1; n < 4; ++n) {
    const double all = glm::distance(curve[0], curve[n]);
    if (all <= 4 * tolerance) continue;
    const double share = std::pow(glm::distance(part[0], part[n]) / all, 1.0 / double(n));
    if (!(share > 0 && share <= 1 + tolerance / all)) return {};
    const double within = std::min(share, 1.0);
    return is_same(parts_at(curve, within)[0], part, tolerance) ? std::optional(within)
                                                                : std::nullopt;
  }
  return {};
}

Patch patch_of(const PagePatch& page) {
  BezierNet net;
  const auto points = page.net();
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) net[i][j].position = points[i][j];
  net[0][0].color = page.colors[0];
  net[0][3].color = page.colors[1];
  net[3][3].color = page.colors[2];
  net[3][0].color = page.colors[3];
  Patch patch = patch_from_bezier(net);
  make_color_bilinear(patch);
  return patch;
}

class Joiner {
 public:
  Joiner(const std::vector<PagePatch>& patches, double tolerance)
      : tolerance_(tolerance), welded_(tolerance) {
    for (const PagePatch& patch : patches) {
      const bool is_clockwise =
          cross(patch.outer[6] - patch.outer[0], patch.outer[9] - patch.outer[3]) >= 0;
      add(is_clockwise ? patch : patch.mirrored());
    }
  }

  MeshParts run() {
    for (int h = 0; h < int(sides_.size()); ++h) join_whole(h);
    for (int h = 0; h < int(sides_.size()); ++h) join_divided(h);
    return std::move(parts_);
  }

 private:
  struct Side {
    Curve curve;
    CurvePoints points;
    bool is_joined = false;
  };

  void add(PagePatch patch) {
    std::array<int, PagePatch::outer_count> points{};
    for (std::size_t n = 0; n < points.size(); ++n) {
      points[n] = welded_.number(patch.outer[n]);
      patch.outer[n] = welded_.point(points[n]);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      Side side;
      for (std::size_t n = 0; n < 4; ++n) {
        side.points[n] = points[(3 * k + n) % points.size()];
        side.curve[n] = patch.side_point(k, n);
      }
      const int number = int(sides_.size());
      // A side that is one point joins nothing.
      side.is_joined = std::ranges::count(side.points, side.points[0]) == 4;
      by_points_[side.points].push_back(number);
      from_[side.points[0]].push_back(number);
      sides_.push_back(side);
    }
    parts_.patches.push_back(patch_of(patch));
  }

  /// Joins a side with the one that is the same curve against it, if there is one.
  void join_whole(int h) {
    const CurvePoints& points = side(h).points;
    const auto others = by_points_.find({points[3], points[2], points[1], points[0]});
    const bool is_one =
        others != by_points_.end() && others->second.size() == 1 && by_points_[points].size() == 1;
    if (!is_one || others->second.front() / 4 == h / 4) return;
    join(CurveSide{{h}, {}}, CurveSide{others->second, {}});
  }

  /// Joins a side with those that divide it, if there are such.
  void join_divided(int h) {
    if (side(h).is_joined) return;
    // Of the rest of the curve, from the end of the side backwards.
    Curve rest = reversed(side(h).curve);
    int at = side(h).points[3];
    double way = 0;
    CurveSide parts;
    while (at != side(h).points[0]) {
      const auto next = part_of(rest, at, h);
      if (!next || parts.halfedges.size() > sides_.size()) return;
      parts.halfedges.push_back(next->side);
      at = side(next->side).points[3];
      way += (1 - way) * next->share;
      if (at != side(h).points[0]) parts.breaks.push_back(way);
      rest = parts_at(rest, next->share)[1];
    }
    if (parts.halfedges.size() > 1) join(CurveSide{{h}, {}}, parts);
  }

  struct Part {
    int side;
    /// Of the rest of the curve.
    double share;
  };

  /// Returns the side from a point on that is the beginning of a curve.
  std::optional<Part> part_of(const Curve& curve, int from, int besides) const {
    for (const int other : from_.at(from)) {
      if (side(other).is_joined || other / 4 == besides / 4) continue;
      const auto share = share_of(side(other).curve, curve, tolerance_);
      if (share) return Part{other, *share};
    }
    return {};
  }

  void join(const CurveSide& a, const CurveSide& b) {
    for (const CurveSide* each : {&a, &b})
      for (const int h : each->halfedges)
        if (side(h).is_joined) return;
    for (const CurveSide* each : {&a, &b})
      for (const int h : each->halfedges) sides_[std::size_t(h)].is_joined = true;
    parts_.curves.push_back({a, b});
  }

  const Side& side(int h) const { return sides_[std::size_t(h)]; }

  const double tolerance_;
  WeldedPoints welded_;
  MeshParts parts_;
  /// By half-edge: 4 times the patch's number, and the side's.
  std::vector<Side> sides_;
  std::map<CurvePoints, std::vector<int>> by_points_;
  /// The sides that begin at a point.
  std::map<int, std::vector<int>> from_;
};

}  // namespace

MeshParts page_mesh(const std::vector<PagePatch>& patches, double tolerance) {
  return Joiner(patches, tolerance).run();
}

}  // namespace gradmesh
