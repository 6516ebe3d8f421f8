#include "window/eye/viewport.h"

#include <algorithm>

namespace gradmesh {

Viewport::Viewport(const Box& subject) : subject_(subject) { fit(); }

Affine Viewport::to_pixels() const {
  return Affine::translation(size_ / 2.0) * Affine::scaling(glm::dvec2(scale_)) *
         Affine::translation(-middle_);
}

glm::dvec2 Viewport::place_at(glm::dvec2 pixel) const {
  return middle_ + (pixel - size_ / 2.0) / scale_;
}

double Viewport::subject_length() const {
  return std::max({subject_.size().x, subject_.size().y, 1e-9});
}

void Viewport::resize(glm::dvec2 size) {
  size_ = glm::max(size, glm::dvec2(1.0));
  if (is_fitted_) fit();
}

void Viewport::fit() {
  constexpr double share = 0.94;
  const glm::dvec2 span = glm::max(subject_.size(), glm::dvec2(1e-9));
  scale_ = share * std::min(size_.x / span.x, size_.y / span.y);
  middle_ = (subject_.low() + subject_.high()) / 2.0;
  is_fitted_ = true;
}

void Viewport::zoom(double factor, glm::dvec2 pixel) {
  // From eight pixels for all of the subject to what no screen needs.
  const double least = 8 / subject_length();
  const glm::dvec2 before = place_at(pixel);
  scale_ = std::clamp(scale_ * factor, least, 1e5 * least);
  middle_ += before - place_at(pixel);
  is_fitted_ = false;
}

void Viewport::pan(glm::dvec2 pixels) {
  middle_ -= pixels / scale_;
  is_fitted_ = false;
}

void Viewport::look_at(glm::dvec2 place) {
  constexpr double large = 3;
  middle_ = place;
  scale_ = std::max(scale_, large * std::min(size_.x, size_.y) / subject_length());
  is_fitted_ = false;
}

}  // namespace gradmesh
