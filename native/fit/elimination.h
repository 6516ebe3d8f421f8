#pragma once

#include <cstddef>
#include <vector>

namespace gradmesh {

/// Columns of a sum of dense equations that are eliminated together (Elimination).
struct Front {
  /// The columns that are eliminated, and behind them those that are eliminated later and depend on
  /// them, in the order of elimination.
  std::vector<int> columns;
  int eliminated = 0;
  /// The part equations that are added here, by their numbers.
  std::vector<int> parts;
  /// The fronts of which something is left over for this one, and the one for which something of
  /// this one is; -1 if there is none.
  std::vector<int> children;
  int parent = -1;
  /// Where the columns that are left over are among those of the parent.
  std::vector<int> in_parent;
};

/// In which order the columns of equations are eliminated, which are the sum of dense equations
/// over a few columns each: so that little is filled in, and on dense fronts (I. S. Duff, J. K.
/// Reid: The multifrontal solution of indefinite sparse symmetric linear equations, 1983).
struct Elimination {
  /// Each after its children.
  std::vector<Front> fronts;
  /// By part: where its columns are among those of its front.
  std::vector<std::vector<int>> places;

  /// Takes the columns of each part, all below `columns`.
  Elimination(const std::vector<std::vector<int>>& parts, std::size_t columns);
};

}  // namespace gradmesh
