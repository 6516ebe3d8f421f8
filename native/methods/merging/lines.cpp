#include "methods/merging/lines.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "base/error.h"
#include "mesh/rectangle.h"
#include "methods/merging/merging.h"
#include "pricing/parallel_trials.h"

namespace gradmesh {
namespace {

/// A line inside the grid, by its number, from 1, in the mesh as it was at first.
struct Line {
  Along along;
  int number;

  bool operator==(const Line&) const = default;
};

/// The grid's first patch, and which of its sides is the top. Of two patches that are merged the
/// one nearer to the first patch stays, so that the first patch stays, and so does the order of
/// rows and columns.
struct Corner {
  Face face;
  int top;
};

Corner corner_of(const Mesh& mesh) {
  const std::optional<Rectangle> grid = find_grid(mesh);
  if (!grid)
    throw InputError(
        "it is not one rectangle of patches without T-junctions, so no whole lines can be taken "
        "out: make one mesh of it first (To One Mesh, gradmesh one-mesh).");
  const Face face = mesh.face(grid->tops.front());
  const std::array<Halfedge, 4> sides = mesh.sides(face);
  return {face, int(std::ranges::find(sides, grid->tops.front()) - sides.begin())};
}

/// Returns the edges along the line that is now the `at`-th inside, from one end to the other. Each
/// can be merged after the one before: if the merge before has made a T-junction, the next edge
/// ends there, and its merge takes the T-junction away again (paper, Fig. 4b). So the last merge
/// leaves none.
std::vector<Halfedge> edges_along(const Mesh& mesh, Corner corner, Along along, int at) {
  const Rectangle grid = grid_from(mesh, corner.face, corner.top).value();
  std::vector<Halfedge> edges;
  if (along == Along::rows) {
    for (int column = 0; column < grid.columns; ++column)
      edges.push_back(mesh.next(mesh.next(grid.top(at - 1, column))));
  } else {
    for (int row = 0; row < grid.rows; ++row) edges.push_back(mesh.next(grid.top(row, at - 1)));
  }
  return edges;
}

class LineSelection {
 public:
  LineSelection(MergeTrial& trial, StopWatch& watch)
      : trial_(trial), watch_(watch), corner_(corner_of(trial.mesh())) {
    const Rectangle grid = grid_from(trial.mesh(), corner_.face, corner_.top).value();
    for (int i = 1; i < grid.rows; ++i) lines_.push_back({Along::rows, i});
    for (int i = 1; i < grid.columns; ++i) lines_.push_back({Along::columns, i});
    total_ = lines_.size();
  }

  void run() {
    price_all();
    while (!candidates_.empty() && !should_stop()) {
      std::ranges::stable_sort(candidates_, {}, &Candidate::price);
      if (!try_cheapest()) candidates_.erase(candidates_.begin());
    }
  }

 private:
  /// A line that is still in the mesh and may be taken out.
  struct Candidate {
    Line line;
    /// By how much taking the line out raised the error when `lines_before` lines had been taken
    /// out.
    double price;
    int lines_before;
  };

  void price_all() {
    std::vector<std::optional<double>> errors(lines_.size());
    // As it is now: while lines are tried, another thread may have taken one out of this mesh.
    Progress progress{0, lines_.size(), trial_.mesh().face_count(), trial_.error()};
    const auto stop = [&](std::size_t done) {
      progress.done = done;
      return watch_.should_stop(progress);
    };
    ParallelTrials(trial_).for_each(lines_.size(), stop, [&](MergeTrial& own, std::size_t i) {
      const Line& line = lines_[i];
      errors[i] = own.error_with(edges_along(own.mesh(), corner_, line.along, line.number));
    });
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (errors[i]) candidates_.push_back({lines_[i], *errors[i] - trial_.error(), 0});
  }

  /// Returns the edges of a line in the mesh as it is now.
  std::vector<Halfedge> edges_of(const Line& line) const {
    const auto is_before = [&](const Line& other) {
      return other.along == line.along && other.number < line.number;
    };
    const int before = int(std::ranges::count_if(lines_, is_before));
    return edges_along(trial_.mesh(), corner_, line.along, before + 1);
  }

  /// Takes the first candidate out, or finds that it is not the cheapest and updates its price.
  /// Returns true if it remains a candidate, which is so only in the second case.
  bool try_cheapest() {
    Candidate& first = candidates_.front();
    const double before = trial_.error();
    double limit = trial_.epsilon();
    if (first.lines_before < taken_ && candidates_.size() > 1)
      limit = std::min(limit, before + candidates_[1].price);
    const double error = trial_.try_edges(edges_of(first.line), limit);
    if (error <= limit) {
      ++taken_;
      std::erase(lines_, first.line);
    } else if (error <= trial_.epsilon()) {
      first.price = error - before;
      first.lines_before = taken_;
      return true;
    }
    return false;
  }

  bool should_stop() {
    return watch_.should_stop(
        {total_ - candidates_.size(), total_, trial_.mesh().face_count(), trial_.error()});
  }

  MergeTrial& trial_;
  StopWatch& watch_;
  const Corner corner_;
  /// The lines that are in the mesh, and those that may still be taken out.
  std::vector<Line> lines_;
  std::vector<Candidate> candidates_;
  std::size_t total_ = 0;
  int taken_ = 0;
};

}  // namespace

Candidate take_out_lines(const Problem& problem, StopWatch& watch) {
  return merge_what_fits(problem, problem.trial()->trial,
                         [&](MergeTrial& trial, PriceTable&) { LineSelection(trial, watch).run(); },
                         {.keeps_rectangle = true});
}

}  // namespace gradmesh
