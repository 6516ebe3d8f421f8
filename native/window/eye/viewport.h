#pragma once

#include <glm/vec2.hpp>

#include "base/affine.h"
#include "geom/box.h"

namespace gradmesh {

/// From where a person looks at a page: which place of it is in the middle of a picture, and how
/// large.
class Viewport {
 public:
  /// How far a step of the wheel, or a key, zooms.
  static constexpr double zoom_step = 1.25;

  /// `subject` is what is looked at, in units of the page.
  explicit Viewport(const Box& subject = {});

  glm::dvec2 size() const { return size_; }
  /// Pixels for each unit of the page.
  double scale() const { return scale_; }
  /// Returns the map from the page to the pixels of the picture.
  Affine to_pixels() const;
  glm::dvec2 place_at(glm::dvec2 pixel) const;

  /// Gives the picture another size in pixels. Until somebody has looked closer, all of the subject
  /// is seen.
  void resize(glm::dvec2 size);
  /// Shows all of the subject.
  void fit();
  /// Enlarges so many times. The place at a pixel stays where it is.
  void zoom(double factor, glm::dvec2 pixel);
  /// The same, in the middle.
  void zoom(double factor) { zoom(factor, size_ / 2.0); }
  void zoom_to(double scale) { zoom(scale / scale_); }
  void pan(glm::dvec2 pixels);
  /// Brings a place into the middle, large enough for its surroundings to be seen alone.
  void look_at(glm::dvec2 place);

 private:
  /// Returns the length of the longer side of the subject, which is not 0.
  double subject_length() const;

  Box subject_;
  glm::dvec2 size_{1.0}, middle_{0.0};
  double scale_ = 1;
  bool is_fitted_ = true;
};

}  // namespace gradmesh
