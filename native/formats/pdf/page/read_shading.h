#pragma once

#include <cstddef>
#include <exception>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "formats/pdf/color/color_space.h"
#include "formats/pdf/page/graphics_state.h"
#include "formats/pdf/shading/packing.h"
#include "formats/pdf/shading/read_patches.h"

namespace gradmesh {

/// What the colours of a shading stand for: components of its colour space, or the parameter of a
/// function that gives them (ISO 32000-1, 8.7.4.5.5).
class ShadingColors {
 public:
  /// Throws InputError if the function does not have as many outputs as the space has components.
  ShadingColors(ColorSpace space, std::optional<Function> function);

  /// Returns false if nothing is seen of these colours.
  bool paints() const { return space_.paints(); }
  /// Returns how many numbers a colour has in the shading's data.
  std::size_t count() const { return function_ ? 1 : std::size_t(space_.components()); }
  /// Returns a colour in sRGB, 0..1.
  glm::dvec3 srgb(const Components& color) const;

 private:
  ColorSpace space_;
  std::optional<Function> function_;
};

/// The patches of a shading, where a page paints it or in its own coordinates.
struct PageShading {
  /// 4 to 7.
  int type = 0;
  ShadingColors colors;
  /// A triangle is a patch of which side 2 is one point, which is exact; of a lattice each cell is
  /// two of them, or one patch with straight sides where that is the same.
  std::vector<ShadingPatch> patches;
  /// Whether a part of it could not be read, as it is damaged, or lies beyond any page.
  bool is_damaged = false;
};

/// Thrown for a shading that has more patches than a mesh may have.
struct TooManyPatches : InputError {
  explicit TooManyPatches(std::size_t patches);
  std::size_t count;
};

/// Reads a shading of type 4 to 7, in its own coordinates. `spaces` may be null. Throws InputError,
/// whose message is a clause, where nothing of it can be read.
PageShading unplaced_shading(QPDFObjectHandle shading, const NamedSpaces* spaces);

/// Returns a shading with its patches on the page, without those that have no size there, or lie
/// beyond any page.
PageShading placed(PageShading shading, const Affine& to_page);

/// Reads a shading where a page paints it. Throws InputError as unplaced_shading() does.
PageShading read_shading(const PaintedShading& painted);

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
