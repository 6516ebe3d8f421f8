#include "fit/corner_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "ops/refresh.h"

namespace gradmesh {

double visible_difference(double levels) { return std::pow(std::abs(levels), 0.7); }

namespace {

constexpr int samples_per_side = 6;
constexpr std::size_t samples_in_all = std::size_t(samples_per_side) * samples_per_side;

/// visible_difference from a table, linear between its entries.
class VisibleDifference {
 public:
  VisibleDifference() {
    for (std::size_t i = 0; i < values_.size(); ++i)
      values_[i] = visible_difference(double(i) / steps);
  }
  double operator()(double levels) const {
    const double at = std::min(std::abs(levels) * steps, double(values_.size() - 2));
    const auto i = std::size_t(at);
    return std::lerp(values_[i], values_[i + 1], at - double(i));
  }

 private:
  static constexpr int steps = 16;
  std::array<double, 256 * steps + 2> values_;
};

struct Sample {
  /// The part of the patch that the sample represents.
  double area;
  /// How much each of the four corners counts.
  std::array<double, 4> shares;
  /// The wanted colour, in levels.
  glm::dvec3 wanted;
};

std::array<Sample, samples_in_all> samples_of(const Patch& wanted) {
  std::array<Sample, samples_in_all> samples;
  for (int i = 0; i < samples_per_side; ++i)
    for (int j = 0; j < samples_per_side; ++j) {
      const double u = (i + 0.5) / samples_per_side, v = (j + 0.5) / samples_per_side;
      const glm::dvec2 du = wanted.derivative_u(u, v).position;
      const glm::dvec2 dv = wanted.derivative_v(u, v).position;
      const glm::dvec4 color = glm::clamp(wanted.at(u, v).color, 0.0, 1.0);
      samples[std::size_t(i * samples_per_side + j)] = {
          std::abs(du.x * dv.y - du.y * dv.x) / samples_in_all,
          {(1 - u) * (1 - v), (1 - u) * v, u * v, u * (1 - v)},
          255.0 * glm::dvec3(color)};
    }
  return samples;
}

/// Tries one level more and one less of each channel of each colour until none is better.
class CornerColors {
 public:
  CornerColors(Mesh& mesh, const std::vector<Patch>& wanted)
      : journal_(mesh),
        mesh_(mesh),
        samples_(wanted.size()),
        costs_(wanted.size()),
        colors_(free_corners(mesh)) {
    for (const Face f : mesh_.faces()) {
      samples_[slot(f)] = samples_of(wanted[slot(f)]);
      for (int channel = 0; channel < 3; ++channel)
        costs_[slot(f)][std::size_t(channel)] = cost(f, channel);
    }
  }

  void run() {
    constexpr int most_sweeps = 12;
    bool better = true;
    for (int sweep = 0; sweep < most_sweeps && better; ++sweep) {
      better = false;
      for (const std::vector<Halfedge>& leaves : colors_)
        for (int channel = 0; channel < 3; ++channel)
          better |= step(leaves, channel, 1) || step(leaves, channel, -1);
    }
  }

 private:
  static std::size_t slot(Face f) { return std::size_t(f.value); }

  double cost(Face f, int channel) const {
    std::array<double, 4> corners;
    const std::array<Halfedge, 4> sides = mesh_.sides(f);
    for (std::size_t k = 0; k < 4; ++k)
      corners[k] = std::round(255 * std::clamp(mesh_[sides[k]].color[channel], 0.0, 1.0));
    double sum = 0;
    for (const Sample& s : samples_[slot(f)]) {
      double level = -s.wanted[channel];
      for (std::size_t k = 0; k < 4; ++k) level += s.shares[k] * corners[k];
      sum += s.area * visible_(level);
    }
    return sum;
  }

  /// Changes a channel of a colour by `by` levels if that is better. Returns true if it was.
  bool step(const std::vector<Halfedge>& leaves, int channel, int by) {
    const std::size_t depth = journal_.depth();
    journal_.begin();
    if (!change_corner(journal_, leaves, channel, by)) {
      journal_.undo();
      return false;
    }
    const std::vector<Face> touched = journal_.touched_since(depth);
    double change = 0;
    after_.clear();
    for (const Face f : touched) {
      after_.push_back(cost(f, channel));
      change += after_.back() - costs_[slot(f)][std::size_t(channel)];
    }
    if (change >= -smallest_gain(touched, channel)) {
      journal_.undo();
      return false;
    }
    for (std::size_t i = 0; i < touched.size(); ++i)
      costs_[slot(touched[i])][std::size_t(channel)] = after_[i];
    journal_.forget();
    return true;
  }

  /// Returns the smallest gain that counts; less would be rounding.
  double smallest_gain(const std::vector<Face>& faces, int channel) const {
    double sum = 0;
    for (const Face f : faces) sum += costs_[slot(f)][std::size_t(channel)];
    return 1e-9 * sum;
  }

  const VisibleDifference visible_;
  Journal journal_;
  const Mesh& mesh_;
  std::vector<std::array<Sample, samples_in_all>> samples_;
  std::vector<std::array<double, 3>> costs_;
  const std::vector<std::vector<Halfedge>> colors_;
  std::vector<double> after_;
};

}  // namespace

std::vector<std::vector<Halfedge>> free_corners(const Mesh& mesh) {
  std::map<Point, std::vector<std::vector<Halfedge>>> at;
  for (const Halfedge h : mesh.halfedges()) {
    if (!mesh.is_leaf(h)) continue;
    if (mesh[mesh.origin(h)].is_junction() && !mesh[h].own_color) continue;
    std::vector<std::vector<Halfedge>>& here = at[mesh.origin(h)];
    const auto same = std::ranges::find_if(here, [&](const std::vector<Halfedge>& leaves) {
      return mesh[leaves.front()].color == mesh[h].color;
    });
    if (same == here.end())
      here.push_back({h});
    else
      same->push_back(h);
  }
  std::vector<std::vector<Halfedge>> corners;
  for (auto& [point, here] : at)
    for (std::vector<Halfedge>& leaves : here) corners.push_back(std::move(leaves));
  return corners;
}

bool change_corner(Journal& journal, const std::vector<Halfedge>& corner, int channel, int by) {
  const Mesh& mesh = journal.mesh();
  const double level = std::round(255 * mesh[corner.front()].color[channel]) + by;
  if (level < 0 || level > 255) return false;
  std::vector<Halfedge> curves;
  for (const Halfedge h : corner) {
    journal.edit(h).color[channel] = level / 255;
    curves.push_back(mesh.curve(h));
    curves.push_back(mesh.curve(mesh.prev(h)));
  }
  refresh(journal, curves);
  return true;
}

void fit_corner_colors(Mesh& mesh, const std::vector<Patch>& wanted) {
  CornerColors(mesh, wanted).run();
}

}  // namespace gradmesh
