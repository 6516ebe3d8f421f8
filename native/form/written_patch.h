#pragma once

#include <array>

#include "geom/patch.h"

namespace gradmesh {

/// Returns the patch as an SVG document can hold it, for the colour model `bilinear`. Corner
/// colours are rounded to 8 bits, opacities to those of mask_color where they are in a mask, and
/// colours between corners are bilinear. The interior control points are those of the Coons patch
/// where all four are within `tolerance` of these (in the unit of the positions), since then no
/// `tensor` is written.
Patch as_written(const Patch& patch, double tolerance, bool masked_opacity = false);

/// Returns true if the patch needs `tensor`.
bool needs_tensor(const Patch& patch, double tolerance);

/// Returns how far the inner control points of a side may be from the thirds of its chord for the
/// side to be written as a line.
double straight_tolerance(double coons_tolerance);

/// How exactly the coordinates of a mesh are written.
struct Precision {
  /// How far an interior control point may be from the Coons patch's without `tensor` being
  /// written, in the unit of the mesh's positions (raster/frame.h).
  double coons_tolerance = 0;
  /// The map from the mesh's coordinates to those that are written.
  Affine to_written = {};
  /// The decimal step of which the coordinates that are written are multiples (form/rounding.h); 0
  /// where significant digits are shorter.
  double step = 0;
  /// How far what must stay as it is (Mesh::is_fixed) may be from what is written, in the unit of
  /// the mesh's positions (form/handles.h); 0 where nothing must.
  double last_bits = 0;
};

/// Returns the precision with the largest step that moves no point of the mesh by more than `share`
/// of the tolerance.
Precision precision_for(double coons_tolerance, double share, const Affine& to_written = {});

/// How far a patch may be from what is written in its place, in the unit of the mesh's positions.
struct PatchTolerance {
  /// As Precision::coons_tolerance.
  double coons = 0;
  /// As straight_tolerance(), for each side.
  std::array<double, 4> straight = {};
};
/// Returns the tolerance of a patch of which nothing must stay as it is.
PatchTolerance patch_tolerance(const Precision& precision);

/// Returns the patch as a reader finds it where it is written as of as_written() and with this
/// precision: straight sides as lines, and `tensor` as offsets from corners.
Patch written_patch(const Patch& patch, const Precision& precision, const PatchTolerance& tolerance,
                    bool masked_opacity = false);
inline Patch written_patch(const Patch& patch, const Precision& precision,
                           bool masked_opacity = false) {
  return written_patch(patch, precision, patch_tolerance(precision), masked_opacity);
}

/// Returns the colour of 8 bits a channel whose luminance in a mask is nearest to an opacity, and
/// of those the nearest to grey. Steps of a single channel are finer than those of greys, so the
/// luminance is within a twentieth of a level.
glm::dvec3 mask_color(double opacity);
/// Returns the luminance of a colour in a mask.
double mask_opacity(const glm::dvec3& color);

}  // namespace gradmesh
