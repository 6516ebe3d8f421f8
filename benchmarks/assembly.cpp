#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "cases.h"
#include "fit/equations.h"
#include "fit/samples.h"

namespace gradmesh::bench {
namespace {

/// A patch of about 35 x 35 pixels, as most are, in a mesh of many; its corners and their colours
/// are unknown.
struct FitCase {
  FitCase(const MeshFile& file) : input(file) {
    const Frame frame = input.frame(700);
    reference.emplace(input.mesh, frame, MetricKind::flip);
    double nearest = 1e9;
    for (const Face face : input.mesh.faces()) {
      const Patch candidate = input.mesh.patch(face);
      const double length = glm::length(
          frame.to_pixels.vector(candidate.side(0).p1.position - candidate.side(0).p0.position));
      if (std::abs(length - 35) > nearest) continue;
      nearest = std::abs(length - 35);
      patch = candidate;
    }
    // So that there is something to fit.
    for (auto& row : patch.c) row[0].color.r *= 0.98;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      Influence by{int(corner), {}, {}};
      by.place[corner / 2 * 12 + corner % 2 * 3] = by.color[corner / 2 * 12 + corner % 2 * 3] = 1;
      influences.push_back(by);
      columns.color[corner] = columns.count;
      columns.count += 3;
    }
  }

  Input input;
  std::optional<Reference> reference;
  Patch patch;
  std::vector<Influence> influences;
  Columns columns{4};
};

/// The number of samples along a side, as of normal_equations().
int sample_count(const FitCase& c, int side) {
  double longest = 0;
  for (const int k : {side, side + 2}) {
    const Cubic<Value> curve = c.patch.side(k);
    longest = std::max(
        longest,
        glm::length(c.reference->frame().to_pixels.vector(curve.p1.position - curve.p0.position)));
  }
  return std::clamp(int(longest / 5), 5, most_samples);
}

/// The same equations as normal_equations() assembles of an opaque patch that lies within the
/// picture, straight from their definition: at each sample the surface with its derivatives, and
/// a row of the Jacobian for each channel.
NormalEquations sample_by_sample(const FitCase& c) {
  constexpr double anchor = 0.5 / 255, scale = 0.08;
  const glm::dmat2& linear = c.reference->frame().to_pixels.linear;
  NormalEquations result;
  result.columns = columns_of(c.influences, c.columns);
  const Eigen::Index n = Eigen::Index(c.influences.size()), size = 5 * n;
  result.matrix = Eigen::MatrixXd::Zero(size, size);
  result.rhs = Eigen::VectorXd::Zero(size);
  const int rows = sample_count(c, 1), columns = sample_count(c, 0);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double u = (i + 0.5) / rows, v = (j + 0.5) / columns;
      const Value at = c.patch.at(u, v), by_u = c.patch.derivative_u(u, v),
                  by_v = c.patch.derivative_v(u, v);
      const glm::dmat2 map(linear * by_u.position, linear * by_v.position);
      const double area = std::abs(glm::determinant(map)) / (rows * columns);
      const auto wanted = c.reference->color_at(c.reference->frame().to_pixels.point(at.position));
      if (!wanted) continue;
      const glm::dvec3 off = glm::dvec3(at.color) - *wanted;
      const double square = glm::dot(off, off), weight = area / (1 + square / (scale * scale));
      result.squares += weight * square;
      const glm::dmat2 back = glm::inverse(map);
      const std::array<double, 16> basis = basis_products(u, v);
      for (int k = 0; k < 3; ++k) {
        const glm::dvec2 slope = glm::dvec2(by_u.color[k], by_v.color[k]) * back;
        Eigen::VectorXd row = Eigen::VectorXd::Zero(size);
        for (Eigen::Index a = 0; a < n; ++a) {
          double place = 0, color = 0;
          for (std::size_t b = 0; b < 16; ++b) {
            place += basis[b] * c.influences[std::size_t(a)].place[b];
            color += basis[b] * c.influences[std::size_t(a)].color[b];
          }
          row(a) = -slope.x * place;
          row(n + a) = -slope.y * place;
          row((2 + k) * n + a) = color;
          if (k > 0) continue;
          for (Eigen::Index b = 0; b < n; ++b) {
            double other = 0;
            for (std::size_t m = 0; m < 16; ++m)
              other += basis[m] * c.influences[std::size_t(b)].place[m];
            for (const Eigen::Index first : {Eigen::Index(0), n})
              result.matrix(first + a, first + b) += anchor * anchor * area * place * other;
          }
        }
        result.matrix += weight * row * row.transpose();
        result.rhs -= weight * off[k] * row;
      }
    }
  return result;
}

NormalEquations as_fits_do(const FitCase& c) {
  return normal_equations(c.patch, c.influences, {}, c.columns, *c.reference);
}

void assemble(benchmark::State& state, const MeshFile& file,
              NormalEquations (*equations)(const FitCase&)) {
  const FitCase c(file);
  const NormalEquations found = as_fits_do(c), wanted = sample_by_sample(c);
  if (!found.matrix.isApprox(wanted.matrix, 1e-9) || !found.rhs.isApprox(wanted.rhs, 1e-9))
    return state.SkipWithError("the two ways to assemble a patch differ");
  for (auto _ : state) benchmark::DoNotOptimize(equations(c));
}

}  // namespace

void register_assembly() {
  const MeshFile photo = mesh_file("photo");
  add("assembly/patch", on(photo, [](auto& state, auto& f) { assemble(state, f, as_fits_do); }));
  add("assembly/sample-by-sample",
      on(photo, [](auto& state, auto& f) { assemble(state, f, sample_by_sample); }));
}

}  // namespace gradmesh::bench
