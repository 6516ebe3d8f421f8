#include "form/reconcile.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "form/written_patch.h"
#include "geom/box.h"
#include "geom/nearest.h"
#include "mesh/build.h"
#include "mesh/dependence.h"

namespace gradmesh {
namespace {

/// Half a level of 8 bits.
constexpr double color_tolerance = 0.501 / 255;

double change(const glm::dvec4& a, const glm::dvec4& b) {
  const glm::dvec4 d = glm::abs(a - b);
  return std::max({d.r, d.g, d.b, d.a});
}

/// Returns the error that eight digits of coordinates, each relative to the last, may have.
double position_tolerance(const MeshParts& parts) {
  Box box;
  for (const Patch& patch : parts.patches)
    for (int k = 0; k < 4; ++k) box.add(patch.corner(k).position);
  const glm::dvec2 farthest = glm::max(glm::abs(box.low()), glm::abs(box.high()));
  return std::max(1e-5 * glm::length(box.size()), 1e-7 * std::max(farthest.x, farthest.y));
}

/// Gives what nobody has edited of a patch as written the very numbers of what was read, which
/// rounding may have changed. Returns true if something is left that somebody has edited.
bool settle(Patch& written, const Patch& read, double tolerance) {
  const BezierNet now = bezier_net(read);
  BezierNet before = bezier_net(written);
  bool edited = false, rounded = false;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      Value& value = before[i][j];
      const bool moved = glm::distance(now[i][j].position, value.position) > tolerance;
      const bool recolored = change(now[i][j].color, value.color) > color_tolerance;
      edited = edited || moved || recolored;
      const Value settled{moved ? value.position : now[i][j].position,
                          recolored ? value.color : now[i][j].color};
      rounded = rounded || settled != value;
      value = settled;
    }
  if (!edited) {
    written = read;
  } else if (rounded) {
    written = patch_from_bezier(before);
    make_color_bilinear(written);
  }
  return edited;
}

class Reconciler {
 public:
  Reconciler(const MeshParts& read, const MeshParts& written, double tolerance)
      : read_(read),
        written_(written),
        tolerance_(tolerance),
        mesh_(build_mesh(written)),
        put_(std::size_t(std::ranges::distance(mesh_.points()))),
        positions_(put_.size()),
        tangents_(std::size_t(std::ranges::distance(mesh_.handles()))),
        colors_(4 * read.patches.size()),
        follows_(colors_.size()) {}

  MeshParts run() {
    place_points();
    place_handles();
    choose_colors();
    place_junctions();
    return assembled();
  }

 private:
  /// A copy of a handle: at the start or the end of a patch's side, which is a part of the curve of
  /// length `length` in the curve's parameter.
  struct Copy {
    Halfedge leaf;
    bool at_end;
    double length;
  };

  static Value corner(const MeshParts& parts, Halfedge leaf) {
    return parts.patches[leaf.value / 4].corner(leaf.value % 4);
  }
  /// Returns the side on which a copy lies, from the copy's end.
  static Cubic<Value> side(const MeshParts& parts, const Copy& copy) {
    const Cubic<Value> side = parts.patches[copy.leaf.value / 4].side(copy.leaf.value % 4);
    return copy.at_end ? side.reversed() : side;
  }

  void place_points() {
    std::vector<double> farthest(put_.size(), tolerance_);
    for (int i = 0; i < int(colors_.size()); ++i) {
      const int point = mesh_.origin(Halfedge{i}).value;
      const glm::dvec2 now = corner(read_, Halfedge{i}).position;
      const double moved = glm::distance(corner(written_, Halfedge{i}).position, now);
      if (moved <= farthest[point]) continue;
      farthest[point] = moved;
      put_[point] = now;
    }
    for (const Point p : mesh_.points())
      positions_[p.value] = put_[p.value].value_or(mesh_.position(p));
  }

  void place_handles() {
    for (const Halfedge h : mesh_.halfedges()) {
      if (mesh_.is_bar(h)) continue;
      const Halfedge twin = mesh_[h].twin;
      place_handle(mesh_[h].handles[0], mesh_.origin(h), copies_at_start(h));
      if (!twin.valid()) place_handle(mesh_[h].handles[1], mesh_.end(h), {{h, true, 1}});
    }
  }

  /// Returns the copies at the start of `side`: those of patches along the whole curve, if there
  /// are any, otherwise those of patches along a part of it.
  std::vector<Copy> copies_at_start(Halfedge side) const {
    const Halfedge twin = mesh_[side].twin;
    std::vector<Copy> copies;
    for (const bool whole : {true, false}) {
      const auto add = [&](Halfedge leaf, bool at_end) {
        if (mesh_.is_bar(leaf) != whole)
          copies.push_back({leaf, at_end, mesh_.span(leaf).length()});
      };
      add(mesh_.first_leaf(side), false);
      if (twin.valid()) add(mesh_.last_leaf(twin), true);
      if (!copies.empty()) break;
    }
    return copies;
  }

  void place_handle(Handle handle, Point at, const std::vector<Copy>& copies) {
    glm::dvec2& tangent = tangents_[handle.value];
    tangent = mesh_[handle].tangent.position;
    double farthest = tolerance_;
    for (const Copy& copy : copies) {
      const Cubic<Value> before = side(written_, copy), now = side(read_, copy);
      const glm::dvec2 place = now.bezier1().position;
      const double moved = glm::distance(before.bezier1().position, place);
      if (mesh_[at].is_junction()) {
        // The handle follows the junction, wherever that will be, unless the handle was moved
        // against it.
        const double turned = glm::distance(before.m0.position, now.m0.position) / 3;
        if (moved > farthest && turned > tolerance_) tangent = now.m0.position / copy.length;
      } else if (moved > farthest || (farthest == tolerance_ && point_moved(before, now))) {
        tangent = 3.0 * (place - positions_[at.value]) / copy.length;
      }
      farthest = std::max(farthest, moved);
    }
  }

  bool point_moved(const Cubic<Value>& before, const Cubic<Value>& now) const {
    return glm::distance(before.p0.position, now.p0.position) > tolerance_;
  }

  void choose_colors() {
    std::vector<std::vector<Halfedge>> around(put_.size());
    for (int i = 0; i < int(colors_.size()); ++i)
      around[mesh_.origin(Halfedge{i}).value].push_back(Halfedge{i});
    for (const std::vector<Halfedge>& corners : around)
      for (const Halfedge h : corners) choose_color(h, corners);
  }

  void choose_color(Halfedge h, const std::vector<Halfedge>& corners) {
    const glm::dvec4 color = corner(written_, h).color;
    colors_[h.value] = color;
    double most = color_tolerance;
    for (const Halfedge other : corners) {
      const glm::dvec4 before = corner(written_, other).color, now = corner(read_, other).color;
      const double changed = change(before, now);
      if (change(before, color) > color_tolerance || changed <= most) continue;
      colors_[h.value] = now;
      most = changed;
    }
    const bool changed = most > color_tolerance;
    follows_[h.value] = mesh_[mesh_.origin(h)].is_junction() && !mesh_[h].own_color && !changed;
  }

  Cubic<glm::dvec2> curve(Halfedge side) const {
    const auto [start, end] = mesh_[side].handles;
    return {positions_[mesh_.origin(side).value], tangents_[start.value], -tangents_[end.value],
            positions_[mesh_.end(side).value]};
  }

  /// Places the T-junctions of each curve once the curve's ends are placed.
  void place_junctions() {
    for (const Halfedge h : mesh_.halfedges())
      if (mesh_.is_leaf(h)) starts_.emplace(h, mesh_.span(h).first);
    for (const Halfedge curve : in_order_of_dependence(mesh_, mesh_.curves()))
      for (const Halfedge side : {curve, mesh_[curve].twin})
        if (side.valid())
          for (const Halfedge stem : mesh_.stems(side)) place_junction(side, stem);
  }

  void place_junction(Halfedge side, Halfedge stem) {
    const Halfedge before = mesh_.prev(mesh_.first_leaf(stem)), bar = mesh_[stem].next_sibling;
    const Cubic<glm::dvec2> long_curve = curve(side);
    const std::optional<glm::dvec2>& put = put_[mesh_.origin(stem).value];
    double& t = starts_.at(bar);
    if (put && glm::distance(long_curve.at(t), *put) > tolerance_) {
      const double low = starts_.at(before), high = mesh_.span(bar).second;
      const double margin = 0.01 * (high - low);
      t = nearest(long_curve, *put, low + margin, high - margin);
    }
    positions_[mesh_.origin(stem).value] = long_curve.at(t);
    for (const Halfedge leaf : {mesh_.first_leaf(stem), bar})
      if (follows_[leaf.value])
        colors_[leaf.value] = glm::mix(colors_[mesh_.first_leaf(side).value],
                                       colors_[mesh_.next(mesh_.last_leaf(side)).value], t);
  }

  MeshParts assembled() const {
    MeshParts parts = written_;
    for (int f = 0; f < int(parts.patches.size()); ++f) parts.patches[f] = patch(f);
    for (CurveParts& curve : parts.curves) {
      for (CurveSide* side : {&curve.a, &curve.b})
        for (std::size_t i = 0; i < side->breaks.size(); ++i)
          side->breaks[i] = starts_.at(Halfedge{side->halfedges[i + 1]});
      const auto [start, end] = mesh_[mesh_.curve_side(Halfedge{curve.a.halfedges[0]})].handles;
      curve.tangents = {{{tangents_[start.value], {}}, {tangents_[end.value], {}}}};
    }
    // The mesh gives the sides of patches that are parts of longer curves.
    const Mesh mesh = build_mesh(parts);
    for (const Face f : mesh.faces()) {
      Patch& patch = parts.patches[f.value] = mesh.patch(f);
      if (!needs_tensor(read_.patches[f.value], tolerance_)) make_coons(patch);
    }
    return parts;
  }

  Patch patch(int face) const {
    std::array<Cubic<Value>, 4> sides;
    std::array<Value, 4> twists;
    for (int k = 0; k < 4; ++k) {
      const Halfedge h{4 * face + k}, next{4 * face + (k + 1) % 4};
      const Cubic<glm::dvec2> side = mesh_.is_bar(h) ? Cubic<glm::dvec2>{} : curve(h);
      sides[k] = {{positions_[mesh_.origin(h).value], colors_[h.value]},
                  {side.m0, {}},
                  {side.m1, {}},
                  {positions_[mesh_.origin(next).value], colors_[next.value]}};
      twists[k] = read_.patches[face].twist(k);
    }
    Patch patch = patch_from_sides(sides, twists);
    make_color_bilinear(patch);
    return patch;
  }

  const MeshParts& read_;
  const MeshParts& written_;
  const double tolerance_;
  /// The mesh as it was written.
  const Mesh mesh_;
  /// For each point, where a person has put it.
  std::vector<std::optional<glm::dvec2>> put_;
  /// The values that points, handles and leaves will have.
  std::vector<glm::dvec2> positions_, tangents_;
  std::vector<glm::dvec4> colors_;
  /// True for leaves at T-junctions whose colour is that of the long curve.
  std::vector<bool> follows_;
  /// For each leaf, where it starts on its curve.
  std::map<Halfedge, double> starts_;
};

}  // namespace

Reconciled reconcile(const MeshParts& read, const MeshParts& written) {
  const double tolerance = position_tolerance(written);
  MeshParts before = written;
  bool edited = false;
  for (std::size_t f = 0; f < read.patches.size(); ++f)
    edited |= settle(before.patches[f], read.patches[f], tolerance);
  if (!edited) return {read, false};
  return {Reconciler(read, before, tolerance).run(), true};
}

Reconciled reconcile(const MeshParts& read) {
  MeshParts written = read;
  const Mesh mesh = build_mesh(read);
  for (const Face f : mesh.faces()) written.patches[f.value] = mesh.patch(f);
  return reconcile(read, written);
}

}  // namespace gradmesh
