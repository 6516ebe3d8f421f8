#include "formats/hemesh/hemesh.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "formats/hemesh/hemesh_file.h"
#include "mesh/build.h"

namespace gradmesh {
namespace {

/// Ends of intervals that differ by less are the same, as files have six digits.
constexpr double interval_tolerance = 1e-5;
/// Most levels of bars of bars; more are taken for a circle.
constexpr int most_levels = 1000;

bool is_in_range(const Value& v) {
  const auto is_small = [](double x) { return std::abs(x) <= largest_hemesh_number; };
  return is_small(v.position.x) && is_small(v.position.y) && is_small(v.color.r) &&
         is_small(v.color.g) && is_small(v.color.b);
}

/// Returns true if the mesh can be written: parts of a curve can need larger numbers than the
/// whole.
bool is_writable(const Mesh& mesh) {
  bool good = true;
  for (const Point p : mesh.points()) good = good && is_in_range({mesh.position(p), {}});
  for (const Handle h : mesh.handles()) good = good && is_in_range(mesh[h].tangent);
  for (const Halfedge h : mesh.halfedges())
    good = good && is_in_range(mesh[h].twist) && is_in_range({{}, mesh[h].color});
  return good;
}

/// Returns the parameter on the whole curve of the point t of a part; exact at both ends.
double within(Interval part, double t) { return std::lerp(part.first, part.second, t); }

class HemeshReader {
 public:
  HemeshReader(const HemeshFile& file, const std::string& name) : file_(file), name_(name) {}

  MeshParts read() {
    for (int p = 0; p < int(file_.patches.size()); ++p)
      if (file_.patches[p] >= 0) add_loop(p);
    if (loops_.empty()) throw InputError("{0}: there are no patches in it.", name_);
    for (const Loop& loop : loops_)
      for (const int h : loop) add_leaf(h);
    for (auto& [side, along] : sides_) check_side(side, along);

    parts_.color_model = ColorModel::bicubic;
    for (const auto& [side, along] : sides_) add_curve(side);
    add_patches();
    complete_patches();
    return std::move(parts_);
  }

 private:
  using Record = HemeshFile::Halfedge;
  using Loop = std::array<int, 4>;
  /// A half-edge of a face, and the part of its curve side that it spans.
  struct Leaf {
    int halfedge;
    Interval part;
  };

  const Record& at(int h) const { return file_.halfedges[h]; }

  [[noreturn]] void fail(int h, const Message& reason) const {
    fail_at_line(name_, file_.line_of_halfedge(h), reason);
  }
  /// Returns `index` if it is an index of `records`, otherwise throws InputError; the half-edge h
  /// has it.
  template <class Records>
  int checked(int h, int index, const Records& records, const Message& otherwise) const {
    if (index < 0 || index >= int(records.size())) fail(h, otherwise);
    return index;
  }
  int checked_halfedge(int h, int index) const {
    return checked(h, index, file_.halfedges, Message("there is no half-edge {0}", index));
  }

  void add_loop(int p) {
    const int line = file_.line_of_patch(p);
    Loop loop;
    int h = file_.patches[p];
    if (h >= int(file_.halfedges.size()))
      fail_at_line(name_, line, Message("there is no half-edge {0}", h));
    number_.resize(file_.halfedges.size(), -1);
    for (int k = 0; k < 4; ++k) {
      if (number_[h] >= 0) fail(h, Message("this half-edge is on two sides of patches"));
      number_[h] = 4 * int(loops_.size()) + k;
      loop[k] = h;
      const int next = checked_halfedge(h, at(h).next);
      if (at(next).prev != h)
        fail(next, Message("the half-edge before it is not the one it names"));
      if (at(h).patch != p)
        fail(h, Message("this half-edge lies in a patch that it does not name"));
      h = next;
    }
    if (h != file_.patches[p]) fail_at_line(name_, line, Message("this patch has not four sides"));
    loops_.push_back(loop);
  }

  // --- curve sides: half-edges that are no bars, and the leaves along them ---

  /// Returns the curve side of which `h` is a part, and the interval of that part.
  std::pair<int, Interval> place_on_side(int h) const {
    Interval part;
    int side = h;
    for (int level = 0; at(side).is_bar(); ++level) {
      const Interval in = at(side).interval;
      if (level == most_levels) fail(h, Message("its parents go round in a circle"));
      part = {within(in, part.first), within(in, part.second)};
      side = checked_halfedge(side, at(side).parent);
    }
    return {side, part};
  }

  void add_leaf(int h) {
    const auto [side, part] = place_on_side(h);
    sides_[side].push_back({h, part});
    if (at(h).recolored) parts_.own_colors.push_back(number_[h]);
  }

  /// Sorts the leaves of a side and makes them meet exactly. Returns false if they do not meet.
  static bool join_leaves(std::vector<Leaf>& leaves) {
    std::ranges::stable_sort(leaves, {}, [](const Leaf& leaf) { return leaf.part.first; });
    const auto meet = [](double a, double b) { return std::abs(a - b) <= interval_tolerance; };
    double end = 0;
    for (Leaf& leaf : leaves) {
      if (!meet(leaf.part.first, end)) return false;
      leaf.part.first = end;
      end = leaf.part.second;
    }
    if (!meet(end, 1)) return false;
    leaves.back().part.second = 1;
    return true;
  }

  void check_side(int side, std::vector<Leaf>& leaves) const {
    if (number_[side] >= 0 && leaves.size() > 1)
      fail(side, Message("this half-edge is a side of a patch and has children"));
    if (!join_leaves(leaves)) fail(side, Message("the intervals of its children do not fill it"));
  }

  const std::vector<Leaf>& leaves(int side) const { return sides_.at(side); }
  int first_leaf(int side) const { return leaves(side).front().halfedge; }
  /// Returns the half-edge that starts where a side ends, in its last patch.
  int leaf_after(int side) const { return at(leaves(side).back().halfedge).next; }

  /// Returns the other side of a curve; -1 on the boundary.
  int twin(int side) const {
    if (at(side).twin == -1) return -1;
    const int other = place_on_side(checked_halfedge(side, at(side).twin)).first;
    if (other == side || !sides_.contains(other) || at(other).twin == -1 ||
        place_on_side(checked_halfedge(other, at(other).twin)).first != side)
      fail(side, Message("its twin is not the other side of the same curve"));
    return other;
  }

  void add_curve(int side) {
    const int other = twin(side);
    if (other < side) return;
    check_points(side, other);
    check_points(other, side);
    if (at(other).handles[0] != at(side).handles[1] || at(other).handles[1] != at(side).handles[0])
      fail(side, Message("it does not share its handles with its twin"));
    parts_.curves.push_back(
        {curve_side(side), curve_side(other), std::array{tangent(side, 0), tangent(side, 1)}});
  }

  /// Throws InputError if a side does not start at the point where its twin ends, where both are
  /// control points.
  void check_points(int side, int other) const {
    const int p = control_point(first_leaf(side)), q = control_point(leaf_after(other));
    if (p >= 0 && q >= 0 && p != q) fail(side, Message("it does not start where its twin ends"));
  }

  CurveSide curve_side(int side) const {
    CurveSide result;
    for (const Leaf& leaf : leaves(side)) {
      result.halfedges.push_back(number_[leaf.halfedge]);
      result.breaks.push_back(leaf.part.second);
    }
    result.breaks.pop_back();
    return result;
  }

  // --- geometry ---

  Value tangent(int side, int end) const {
    const int handle = at(side).handles[end];
    const auto otherwise = Message("there is no handle {0}", handle);
    return file_.handles[checked(side, handle, file_.handles, otherwise)].tangent;
  }

  /// Returns the control point at the start of a leaf; -1 at a T-junction, where a stem or a bar
  /// other than the first starts.
  int control_point(int leaf) const {
    const int side = place_on_side(leaf).first;
    if (at(side).is_child || leaf != first_leaf(side)) return -1;
    const int point = at(side).origin;
    return checked(side, point, file_.points, Message("there is no point {0}", point));
  }

  /// Returns the curve side on which the T-junction at the start of a leaf lies, and its parameter
  /// there.
  std::pair<int, double> junction(int leaf) const {
    const auto [side, part] = place_on_side(leaf);
    if (leaf != first_leaf(side)) return {side, part.first};
    const auto [parent, over] = place_on_side(checked_halfedge(side, at(side).parent));
    if (!sides_.contains(parent)) fail(side, Message("its parent is no side of any patch"));
    const double t = within(over, at(side).interval.first);
    if (std::abs(t - 0.5) > 0.5 + interval_tolerance)
      fail(side, Message("it does not start on its parent"));
    return {parent, t};
  }

  /// Returns the position of the start of a leaf; 0 for T-junctions, since build_mesh places those.
  /// On the boundary a T-junction of the file becomes a control point.
  glm::dvec2 start(int leaf) const {
    const int point = control_point(leaf);
    if (point >= 0) return file_.points[point].position;
    const auto [side, t] = junction(leaf);
    if (twin(side) >= 0) return glm::dvec2(0.0);
    const int first = control_point(first_leaf(side)), last = control_point(leaf_after(side));
    if (first < 0 || last < 0)
      fail(side, Message("this curve on the boundary ends at a T-junction"));
    const Cubic<glm::dvec2> curve{file_.points[first].position, tangent(side, 0).position,
                                  -tangent(side, 1).position, file_.points[last].position};
    return curve.at(t);
  }

  Value corner(int leaf) const { return {start(leaf), at(leaf).color}; }

  void add_curves_of(int side) {
    const Cubic<Value> whole{corner(first_leaf(side)), tangent(side, 0), -tangent(side, 1),
                             corner(leaf_after(side))};
    for (const Leaf& leaf : leaves(side)) {
      Cubic<Value>& curve = curves_[std::size_t(number_[leaf.halfedge])];
      curve = whole.part(leaf.part.first, leaf.part.second);
      curve.p0 = corner(leaf.halfedge);
      curve.p1 = corner(at(leaf.halfedge).next);
    }
  }

  void add_patches() {
    curves_.resize(4 * loops_.size());
    for (const auto& [side, along] : sides_) add_curves_of(side);
    for (std::size_t p = 0; p < loops_.size(); ++p) {
      std::array<Cubic<Value>, 4> sides;
      std::array<Value, 4> twists;
      for (std::size_t k = 0; k < 4; ++k) {
        sides[k] = curves_[4 * p + k];
        twists[k] = at(loops_[p][k]).twist;
      }
      parts_.patches.push_back(patch_from_sides(sides, twists));
    }
  }

  /// Lets build_mesh put T-junctions, and with them the sides of patches, on the T-junctions'
  /// parents.
  void complete_patches() {
    try {
      const Mesh mesh = build_mesh(parts_);
      if (!is_writable(mesh)) throw InputError("its mesh has numbers beyond 1e9.");
      for (const Face f : mesh.faces()) parts_.patches[std::size_t(f.value)] = mesh.patch(f);
    } catch (const InputError& error) {
      throw InputError("{0}: {1}", name_, error.message());
    }
  }

  const HemeshFile& file_;
  const std::string& name_;
  MeshParts parts_;
  std::vector<Loop> loops_;
  /// 4 * patch + side for each half-edge of a patch, counting the patches that were not taken out;
  /// else -1.
  std::vector<int> number_;
  /// The leaves of each side, by the half-edge that is the side.
  std::map<int, std::vector<Leaf>> sides_;
  std::vector<Cubic<Value>> curves_;
};

}  // namespace

MeshParts read_hemesh(std::string_view text, const std::string& name) {
  return HemeshReader(parse_hemesh(text, name), name).read();
}

}  // namespace gradmesh
