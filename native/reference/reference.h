#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <mutex>
#include <optional>

#include "mesh/mesh.h"
#include "metric/metric.h"
#include "raster/frame.h"
#include "raster/painting.h"
#include "reference/original.h"
#include "reference/outlines.h"

namespace gradmesh {

/// Returns the frame with a black ground.
Frame on_black(Frame frame);

/// The picture that meshes are measured against and fitted to, with what the metric needs of the
/// picture alone and with the outlines in it. Places are in pixels of the frame. All members may be
/// called concurrently.
class Reference {
 public:
  /// Paints `original`, without a mask of opacities.
  Reference(const Original& original, const Frame& frame, MetricKind metric);
  Reference(const Mesh& original, const Frame& frame, MetricKind metric);

  const Frame& frame() const { return frame_; }
  const Painting& painting() const { return painting_; }
  MetricKind metric_kind() const { return metric_kind_; }
  /// Returns the metric that measures against the picture, with the weights of the frame, which is
  /// made at the first call.
  const Metric& metric() const;
  /// Returns the metric that measures against the original on black, which is made at the first
  /// call; null where the original is opaque. What of a translucent mesh is hardly seen on white
  /// may be seen on what it lies on; of all greys the worst is white or black, as colours change
  /// with the ground by a constant share.
  const Metric* metric_on_black() const;
  /// Returns 1 for the pixels that are away from the outline, where anti-aliasing flickers, and
  /// which is bounded where it is known as a curve.
  const Raster<std::uint8_t, 1>& away_from_outline() const { return away_from_outline_; }

  /// Returns the picture's colour, 0..1, interpolated between the centres of pixels; nothing where
  /// the original does not cover the nearest of them.
  std::optional<glm::dvec3> color_at(glm::dvec2 place) const;
  /// Returns the closest point of an outline; nothing where there is none within a few pixels.
  std::optional<OutlinePoint> outline_near(glm::dvec2 place) const {
    return outlines_.closest(place);
  }
  /// Returns true if the pixel of this place is hidden.
  bool is_hidden(glm::dvec2 place) const;

 private:
  const Frame frame_;
  const Painting painting_;
  /// On black; without pixels where the original is opaque.
  const Image on_black_;
  /// Of each pixel the levels and whether the original covers it, in one number, since samples are
  /// many and four planes lie far apart in memory.
  const Raster<std::uint32_t, 1> texels_;
  const Raster<std::uint8_t, 1> away_from_outline_;
  const MetricKind metric_kind_;
  const OutlinePoints outlines_;
  mutable std::once_flag metric_is_made_, metric_on_black_is_made_;
  mutable std::unique_ptr<Metric> metric_, metric_on_black_;
};

}  // namespace gradmesh
