#pragma once

#include <vector>

#include "ops/journal.h"
#include "trial/edit_error.h"

namespace gradmesh {

/// Changes the corner colours of a mesh of the model `bilinear`, which have 8 bits when they are
/// written, by single levels, where that lowers the measured error.
class ColorTrial {
 public:
  /// `error` starts from `mesh`.
  ColorTrial(Mesh& mesh, EditError error) : journal_(mesh), error_(std::move(error)) {}

  /// Tries one level more and one less of each channel of each colour, and keeps what lowers the
  /// error.
  void improve();

  double error() const { return error_.error(); }

 private:
  bool step(const std::vector<Halfedge>& corner, int channel, int by);

  Journal journal_;
  EditError error_;
};

}  // namespace gradmesh
