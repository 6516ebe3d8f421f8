#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "formats/code/mesh_code.h"

namespace gradmesh {

/// What the writers of code share.

/// Numbers of a list as lines of code have them, each line a whole thing such as a vertex.
using CodeLines = std::vector<std::vector<std::string>>;

/// Returns a coordinate in steps of 1e-5, of which coordinates in code are multiples: less than a
/// tenth of a pixel on the largest screens.
std::int64_t code_steps(double coordinate);
/// Returns such a number of steps as code has it, without zeros at its end: `0.25`, `-1`.
std::string code_number(std::int64_t steps);
/// Returns a number that is no coordinate, with six digits.
std::string code_ratio(double value);
/// Returns a colour as `0xAARRGGBB`.
std::string code_color(const glm::dvec4& color);
/// Returns any text as a comment of one line may hold it: control characters, what ends a line or
/// turns the direction of reading, and what is no UTF-8 become question marks; cut when long.
std::string comment_text(std::string_view text);
/// Returns the lines with commas between numbers and after the last, as both languages allow them,
/// with so many blanks before each line and `suffix` behind each number.
std::string code_lines(const CodeLines& lines, int indent, std::string_view suffix = "");

/// Returns the points of outlines, and below them how many each polygon has.
CodeLines outline_points(const FilledOutline& clip);
CodeLines outline_counts(const FilledOutline& clip);
/// Returns the colours of all vertices; each row of a grid begins a line.
CodeLines vertex_colors(const MeshCode& mesh);

}  // namespace gradmesh
