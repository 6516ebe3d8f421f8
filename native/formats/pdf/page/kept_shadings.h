#pragma once

#include <cstddef>
#include <exception>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "formats/pdf/page/read_shading.h"

namespace gradmesh {

/// Shadings of one document that have been read: a page may paint the same one, or paint through
/// the same mask, again and again.
class KeptShadings {
 public:
  /// Returns a shading in its own coordinates, as unplaced_shading() does. Throws InputError where
  /// that does, or did before.
  std::shared_ptr<const PageShading> read(const PaintedShading& painted);

 private:
  struct Kept {
    std::shared_ptr<const PageShading> shading;
    std::exception_ptr error;
  };
  static Kept read_now(const PaintedShading& painted);

  /// By the shading, and the colour spaces in whose names it may be painted.
  std::map<std::pair<QPDFObjGen, std::string>, Kept> kept_;
  std::size_t patches_ = 0;
};

}  // namespace gradmesh
