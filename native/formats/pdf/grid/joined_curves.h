#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "geom/cubic.h"

namespace gradmesh {

/// The control points of a cubic curve, or of one row of a patch.
using ControlRow = std::array<glm::dvec2, 4>;

/// The part [from, to] of a curve.
struct CurvePart {
  ControlRow row;
  double from, to;
};

Cubic<glm::dvec2> cubic_of(const ControlRow& row);

/// Returns the parameter at which a curve comes nearest to a point.
double nearest_on(const ControlRow& row, glm::dvec2 place);

/// Returns about how long a curve is.
double length_of(const ControlRow& row);
/// Returns the same curve from its end to its start.
ControlRow reversed_row(const ControlRow& row);

/// Returns the part [from, to] of a curve.
ControlRow part_of(const ControlRow& row, double from, double to);

/// Returns the curve whose parts are the closest to these by least squares of control points. It
/// starts where the first does, at 0, and ends where the last of those at 1 does.
ControlRow closest_whole(std::span<const CurvePart> parts);

/// Returns the curve that lies the closest to these parts, wherever along it each point comes. It
/// has the same ends as closest_whole().
ControlRow closest_line(std::span<const CurvePart> parts);

/// Returns the largest distance of a control point from where it would be as a part of `whole`.
double deviation(const ControlRow& whole, std::span<const CurvePart> parts);

/// Returns curves that follow one another as the parts of one that runs on with the same speed
/// where they meet; by their lengths where one has no speed there.
std::vector<CurvePart> parts_by_speed(std::span<const ControlRow> rows);

/// Returns the largest distance of a curve's points from another.
double distance_of_line(const ControlRow& row, const ControlRow& other);

}  // namespace gradmesh
