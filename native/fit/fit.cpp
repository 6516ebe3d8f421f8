#include "fit/fit.h"

#include <glm/matrix.hpp>
#include <utility>

#include "base/parallel.h"
#include "fit/equations.h"

namespace gradmesh {
namespace {

Eigen::VectorXd by_column(const std::vector<double>& by_unknown, const Columns& columns) {
  Eigen::VectorXd result(columns.count);
  for (std::size_t i = 0; i < by_unknown.size(); ++i) {
    result.segment<2>(columns.place[i]).setConstant(by_unknown[i]);
    if (columns.color[i] >= 0) result.segment<3>(columns.color[i]).setConstant(by_unknown[i]);
  }
  return result;
}

/// Returns the unknowns of the faces that change no patch that must stay as it is.
std::vector<Unknown> free_unknowns(Journal& journal, const std::vector<Face>& faces,
                                   const Plainness& plain) {
  std::vector<Unknown> all = unknowns_of(journal.mesh(), faces, plain);
  if (!journal.mesh().has_fixed_faces()) return all;
  std::vector<bool> stays(all.size(), false);
  for (const InfluencedFace& f : influences(journal, all, plain))
    if (journal.mesh().is_fixed(f.face))
      for (const Influence& by : f.by) stays[std::size_t(by.unknown)] = true;
  std::vector<Unknown> free;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!stays[i]) free.push_back(all[i]);
  return free;
}

}  // namespace

Fit::Fit(Journal& journal, const Reference& target, const std::vector<Face>& faces, Plainness plain)
    : journal_(journal),
      target_(target),
      plain_(std::move(plain)),
      unknowns_(free_unknowns(journal, faces, plain_)),
      influenced_(influences(journal, unknowns_, plain_)) {}

std::vector<Value> Fit::step(const Damping& damping) {
  const Mesh& mesh = journal_.mesh();
  const Columns columns(unknowns_);
  std::vector<NormalEquations> equations(influenced_.size());
  parallel_for(influenced_.size(), [&](std::size_t i) {
    equations[i] = normal_equations(mesh, influenced_[i], columns, target_);
  });
  const Eigen::VectorXd solution = solver_.solve(equations, by_column(damping.values(), columns));

  std::vector<Value> step(unknowns_.size());
  if (!solution.allFinite()) return step;
  const glm::dmat2 to_mesh = glm::inverse(target_.frame().to_pixels.linear);
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    const int p = columns.place[i];
    step[i].position = to_mesh * glm::dvec2(solution(p), solution(p + 1));
    if (const int c = columns.color[i]; c >= 0)
      step[i].color = {solution(c), solution(c + 1), solution(c + 2), 0.0};
  }
  return step;
}

void Fit::apply(const std::vector<Value>& step, const std::vector<bool>& stays) {
  std::vector<Unknown> moved;
  std::vector<Value> by;
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    if (stays[i]) continue;
    moved.push_back(unknowns_[i]);
    by.push_back(step[i]);
  }
  journal_.begin();
  change(journal_, moved, by, plain_);
}

}  // namespace gradmesh
