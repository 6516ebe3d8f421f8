#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace gradmesh {

/// An open line that a person drew, along which a line of a grid runs. A place on it is given by
/// the length of the way there from its start.
class Guide {
 public:
  /// Makes a guide along a line that has a length.
  explicit Guide(const std::vector<glm::dvec2>& line);

  bool operator==(const Guide&) const = default;

  double length() const { return ends_.back(); }
  /// Returns the place at a way, which is taken to be 0..length().
  glm::dvec2 at(double way) const;
  /// Returns the direction there, of length 1: the mean over about a pixel, as drawn lines tremble.
  glm::dvec2 direction(double way) const;
  /// Returns the way to the place of the guide that is nearest to a place.
  double nearest(glm::dvec2 place) const;
  /// Returns the piece from one way to another, which runs backwards if the second is less.
  Guide piece(double from, double to) const;
  /// Returns the ways on this guide and on another to where they cross, nearest to a place; nothing
  /// if they do not.
  std::optional<std::pair<double, double>> crossing(const Guide& other, glm::dvec2 near) const;

 private:
  std::vector<glm::dvec2> points_;
  /// The way to each of the points.
  std::vector<double> ends_;
};

}  // namespace gradmesh
