#pragma once

#include "base/image.h"
#include "session/session.h"

namespace gradmesh {

/// What of a session is painted, and where.
struct SessionView {
  int width = 0, height = 0;
  /// How many pixels lines and marks have for each that they have on an ordinary screen.
  double density = 1;
  /// The map from mesh units to pixels.
  Affine to_pixels = {};

  /// What lies below everything.
  enum class Ground {
    result,
    original,
    /// The original left of `split`, a share of the width, and the result right of it.
    halves,
    /// The error of the result.
    error,
  };
  Ground ground = Ground::result;
  double split = 0.5;

  /// What of the mesh is drawn over a pale ground, in the place of its lines, once it is found out.
  std::optional<AnalysisKind> analysis = std::nullopt;
  /// regions: the patch, and which of its regions is shown, the largest being 0.
  Face patch = {};
  int region = 0;

  bool lines = true, handles = false;
  /// Paints the edit that is proposed.
  bool proposal = true;
  /// Patches that are marked, and the line that is being drawn around others, in pixels. Protected
  /// patches are hatched in any case.
  std::vector<Face> marked = {};
  std::vector<glm::dvec2> lasso = {};

  bool operator==(const SessionView&) const = default;
};

/// Returns the ground of that name: "result", "original", "halves" or "error". Throws
/// std::invalid_argument with all names if there is none.
SessionView::Ground ground_named(const std::string& name);

/// Returns the colour, in 0..1, that is seen at a pixel of the picture without all that is drawn
/// over it: of the original, or of the result where its error is shown.
glm::dvec3 color_at(const Session& session, const SessionView& view, glm::dvec2 pixel);

/// Paints a part of what a session shows, at any scale. Throws InputError if the picture is beyond
/// the limits on memory.
Image paint(const Session& session, const SessionView& view);

}  // namespace gradmesh
