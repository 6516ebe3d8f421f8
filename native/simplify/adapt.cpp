#include "simplify/adapt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <queue>

#include "base/limits.h"
#include "fit/corner_colors.h"
#include "mesh/build.h"
#include "mesh/color_model.h"
#include "mesh/dependence.h"
#include "mesh/subdivide.h"
#include "ops/refresh.h"
#include "ops/split/split.h"
#include "trial/color_trial.h"
#include "trial/fit_trial.h"

namespace gradmesh {
namespace {

/// Returns the integral, over the area of the patch, of the visible difference between the patch's
/// colours and the bilinear mixture of its corner colours.
double stray(const Patch& patch) {
  constexpr int n = 5;
  std::array<glm::dvec4, 4> corners;
  for (int k = 0; k < 4; ++k) corners[std::size_t(k)] = glm::clamp(patch.corner(k).color, 0.0, 1.0);
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = (i + 0.5) / n, v = (j + 0.5) / n;
      const glm::dvec2 du = patch.derivative_u(u, v).position;
      const glm::dvec2 dv = patch.derivative_v(u, v).position;
      const glm::dvec4 off =
          glm::mix(glm::mix(corners[0], corners[1], v), glm::mix(corners[3], corners[2], v), u) -
          glm::clamp(patch.at(u, v).color, 0.0, 1.0);
      // The weight of one level of each channel in FLIP, relative to a level of green.
      constexpr std::array<double, 4> weights{0.6, 1, 0.3, 1};
      double seen = 0;
      for (int channel = 0; channel < 4; ++channel)
        seen += weights[std::size_t(channel)] * visible_difference(255 * off[channel]);
      sum += std::abs(du.x * dv.y - du.y * dv.x) * seen;
    }
  return sum / (n * n);
}

/// Returns the 2^times equal parts of a patch, in rows or in columns.
std::vector<Patch> split_patch(const Patch& patch, bool in_rows, int times) {
  if (times == 0) return {patch};
  std::vector<Patch> parts;
  for (const Patch& half : in_rows ? patch.split_u(0.5) : patch.split_v(0.5))
    for (const Patch& part : split_patch(half, in_rows, times - 1)) parts.push_back(part);
  return parts;
}

/// A patch of the mesh that is split, and the better of the two lines through its middle.
struct Piece {
  Patch patch;
  bool in_rows = false;
  /// The decrease of stray() per added patch, of one split or of two splits in turn, whichever is
  /// larger. If a colour turns one way and then the other, only the second split gains.
  double gain = 0;

  explicit Piece(const Patch& whole) : patch(whole) {
    const double before = stray(whole);
    for (const bool rows : {false, true})
      for (const int times : {1, 2}) {
        double after = 0;
        const std::vector<Patch> parts = split_patch(whole, rows, times);
        for (const Patch& part : parts) after += stray(part);
        const double gained = (before - after) / double(parts.size() - 1);
        if (gained <= gain) continue;
        gain = gained;
        in_rows = rows;
      }
  }
};

/// The order in which patches are split: the patch that gains the most comes first. The first part
/// keeps the number of the patch that was split. The second part gets the next free number.
class Splits {
 public:
  struct Split {
    int face;
    bool in_rows;
  };

  explicit Splits(const std::vector<Patch>& patches) {
    for (const Patch& patch : patches) add(patch);
  }

  const Split& operator[](std::size_t i) {
    while (splits_.size() <= i) split_next();
    return splits_[i];
  }

 private:
  void add(const Patch& patch) {
    pieces_.emplace_back(patch);
    queue_.push({pieces_.back().gain, -int(pieces_.size()) + 1});
  }

  void split_next() {
    const int face = -queue_.top().second;
    queue_.pop();
    const Piece split = pieces_[std::size_t(face)];
    splits_.push_back({face, split.in_rows});
    const std::vector<Patch> parts = split_patch(split.patch, split.in_rows, 1);
    pieces_[std::size_t(face)] = Piece(parts[0]);
    queue_.push({pieces_[std::size_t(face)].gain, -face});
    add(parts[1]);
  }

  std::vector<Piece> pieces_;
  /// The gains with the negated numbers of their patches, so that among equal gains the smaller
  /// number comes first.
  std::priority_queue<std::pair<double, int>> queue_;
  std::vector<Split> splits_;
};

std::vector<Patch> patches_of(const Mesh& mesh) {
  std::vector<Patch> patches;
  for (const Face f : mesh.faces()) patches.push_back(mesh.patch(f));
  return patches;
}

class Adapter {
 public:
  explicit Adapter(const Problem& problem)
      : problem_(problem), patches_(patches_of(problem.mesh())), splits_(patches_) {
    // From here on, faces have the numbers of the patches.
    start_ = build_mesh(as_bilinear(subdivided(problem.mesh(), 1)));
    let_junctions_follow(problem.mesh());
  }

  int patches() const { return int(patches_.size()); }

  /// Returns the mesh with `count` patches.
  const Candidate& with_patches(int count) {
    const auto known = known_.find(count);
    return known != known_.end() ? known->second : known_.emplace(count, made(count)).first->second;
  }

  /// Fits twists and tangents to the picture, patch by patch, and then the levels of the corner
  /// colours. Stops once the error no longer decreases.
  void polish(Candidate& adapted) const {
    constexpr int rounds = 2, steps = 3;
    for (int round = 0; round < rounds && !adapted.keeps; ++round) {
      Mesh mesh = adapted.mesh;
      FitTrial fit(mesh, EditError(problem_.reference(), mesh));
      for (const Face f : adapted.mesh.faces()) fit.improve({f}, steps);
      ColorTrial(mesh, EditError(problem_.reference(), mesh)).improve();
      Candidate polished = problem_.measure(std::move(mesh));
      if (polished.error >= adapted.error) return;
      adapted = std::move(polished);
    }
  }

 private:
  Candidate made(int count) {
    Mesh split_mesh = start_;
    std::vector<Patch> wanted = patches_;
    Journal journal(split_mesh);
    for (int i = patches(); i < count; ++i) {
      const auto [number, in_rows] = splits_[std::size_t(i - patches())];
      split(journal, split_mesh.sides(Face{number})[in_rows ? 1 : 0], 0.5);
      journal.forget();
      Patch& patch = wanted[std::size_t(number)];
      const auto [first, second] = in_rows ? patch.split_u(0.5) : patch.split_v(0.5);
      patch = first;
      wanted.push_back(second);
    }
    // Where both sides of a curve are split at the same place, subdivided() makes an ordinary
    // point, whose colour is free.
    Mesh mesh = build_mesh(subdivided(split_mesh, 1));
    take_corner_colors(mesh, wanted);
    fit_corner_colors(mesh, wanted);
    return problem_.measure(std::move(mesh));
  }

  /// Makes the colours of T-junctions follow the parent's curve in the model `bilinear` if they
  /// equal the colours of the parent's curve in `mesh` up to a level. Otherwise a step in colour
  /// would arise.
  void let_junctions_follow(const Mesh& mesh) {
    constexpr double as_good_as = 1.0 / 255;
    Journal journal(start_);
    journal.begin();
    int number = 0;
    for (const Face f : mesh.faces()) {
      for (const Halfedge h : mesh.sides(f)) {
        const Halfedge leaf{number++};
        const Halfedge stem = mesh[mesh.origin(h)].stem;
        if (!stem.valid() || !start_[start_.origin(leaf)].is_junction()) continue;
        const glm::dvec4 off = glm::abs(mesh[h].color - junction_value(mesh, stem).color);
        journal.edit(leaf).own_color = std::max({off.r, off.g, off.b, off.a}) > as_good_as;
      }
    }
    refresh(journal, start_.curves());
  }

  /// Gives the corners the colours of the wanted patches, except corners whose colours follow
  /// others. Corners at the same point get the same colour if their colours differ only by
  /// rounding.
  static void take_corner_colors(Mesh& mesh, const std::vector<Patch>& wanted) {
    constexpr double rounding = 0.1 / 255;
    std::map<Point, std::vector<glm::dvec4>> known;
    Journal journal(mesh);
    journal.begin();
    for (const Face f : mesh.faces()) {
      const std::array<Halfedge, 4> sides = mesh.sides(f);
      for (int k = 0; k < 4; ++k) {
        const Halfedge h = sides[std::size_t(k)];
        glm::dvec4 color = glm::clamp(wanted[std::size_t(f.value)].corner(k).color, 0.0, 1.0);
        std::vector<glm::dvec4>& here = known[mesh.origin(h)];
        const auto same = std::ranges::find_if(
            here, [&](const glm::dvec4& c) { return glm::distance(c, color) < rounding; });
        if (same == here.end())
          here.push_back(color);
        else
          color = *same;
        journal.edit(h).color = glm::round(255.0 * color) / 255.0;
      }
    }
    refresh(journal, mesh.curves());
  }

  const Problem& problem_;
  const std::vector<Patch> patches_;
  Splits splits_;
  Mesh start_;
  /// The meshes that were made, by their numbers of patches.
  std::map<int, Candidate> known_;
};

/// Returns the mesh with the fewest patches whose error is at most `error`. Returns the mesh with
/// the least error that was found if there is none.
Candidate fewest_patches(Adapter& adapter, double error) {
  // The search ends when the numbers of patches that are enough and too few have this ratio.
  constexpr double precise = 1.04;
  // More patches do not reduce the error of rounding to 8 bits: the search ends when twice as many
  // patches have more than this share of the error.
  constexpr double helps = 0.97;
  const int most = std::max(adapter.patches(), int(limits().patches));
  int too_few = adapter.patches();
  Candidate best = adapter.with_patches(too_few);
  while (best.error > error && too_few < most) {
    const int count = std::min(2 * too_few, most);
    const Candidate& next = adapter.with_patches(count);
    if (next.error > error) {
      too_few = count;
      if (next.error > helps * best.error) return best;
    }
    best = next;
  }
  while (best.error <= error && best.mesh.face_count() > precise * too_few) {
    const int between = int(std::sqrt(double(best.mesh.face_count()) * too_few));
    if (between <= too_few) break;
    const Candidate& next = adapter.with_patches(between);
    if (next.error <= error)
      best = next;
    else
      too_few = between;
  }
  return best;
}

/// Returns true if `mesh` is a better result than `than`. A mesh that keeps to epsilon is better
/// than a mesh that does not. Of two meshes that keep to epsilon, the one with fewer patches is
/// better; of two that do not, the one with the smaller error.
bool is_better(const Candidate& mesh, const Candidate& than, double epsilon) {
  const bool keeps = mesh.error <= epsilon;
  if (keeps != (than.error <= epsilon)) return keeps;
  return keeps ? mesh.mesh.face_count() < than.mesh.face_count() : mesh.error < than.error;
}

}  // namespace

Candidate adapted(const Problem& problem) {
  // The share of the error that polish() leaves differs from mesh to mesh. A try with a first guess
  // of the share shows the real one.
  constexpr double first_guess = 0.75, near = 0.05;
  constexpr int tries = 3;
  const double epsilon = problem.bounds.epsilon;
  Adapter adapter(problem);
  Candidate best = adapter.with_patches(adapter.patches());
  if (best.error <= epsilon) return best;
  double left = first_guess;
  for (int i = 0; i < tries; ++i) {
    Candidate next = fewest_patches(adapter, epsilon / left);
    const double before = next.error;
    adapter.polish(next);
    const double found = next.error / before;
    if (is_better(next, best, epsilon)) best = std::move(next);
    if (before <= epsilon || std::abs(found - left) < near * left) break;
    left = found;
  }
  return best;
}

}  // namespace gradmesh
