#include "trial/color_trial.h"

#include "fit/corner_colors.h"

namespace gradmesh {

void ColorTrial::improve() {
  for (const std::vector<Halfedge>& corner : free_corners(journal_.mesh()))
    for (int channel = 0; channel < 3; ++channel)
      if (!step(corner, channel, 1)) step(corner, channel, -1);
}

bool ColorTrial::step(const std::vector<Halfedge>& corner, int channel, int by) {
  const std::size_t depth = journal_.depth();
  journal_.begin();
  const double before = error_.error();
  if (change_corner(journal_, corner, channel, by) &&
      error_.after_edits(journal_, depth, before) < before) {
    error_.accept(journal_);
    journal_.forget();
    return true;
  }
  journal_.undo();
  return false;
}

}  // namespace gradmesh
