#pragma once

#include <string>

#include "base/progress.h"

namespace gradmesh {

/// A line on the terminal that shows how far a run is; silent where stderr is no terminal. Ctrl+C
/// cancels the run, a second one the program.
class ProgressBar {
 public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();

  ProgressCallback callback();

 private:
  bool show(const Progress& progress);

  bool visible_;
  int last_percent_ = -1;
};

}  // namespace gradmesh
