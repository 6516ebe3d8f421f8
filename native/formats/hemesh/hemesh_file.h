#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"

#include "mesh/elements.h"

namespace gradmesh {

/// The records of a .hemesh file, the text format of the authors of the paper. An index counts the
/// records of one kind from 0; -1 means none. Where a file repeats a value, one copy is kept.
///
/// The format does not say which way y points. It is taken to point down, as in SVG: so the
/// authors' apple, duck, tulips, raindrop and tree (save_1) stand upright, and their faces run
/// clockwise as those of Patch do. (L and U among the small meshes were made with y upwards.)
/// Little depends on it: faces may run either way, and twists, which are derivatives along the
/// sides of a face, are the same for both. That they are those of Patch::twist shows in meshes
/// that were made by exact splits, such as the authors' Perfect6: with the other sign their patches
/// are no parts of one patch (Eq. A.1 to A.4), and with derivatives along (u, v) the sign would
/// not change from one face to the next around a smooth point, as it does in all files.
struct HemeshFile {
  struct Point {
    glm::dvec2 position{0.0};
    int halfedge = -1;
  };
  struct Handle {
    int halfedge = -1;
    Value tangent;
  };
  struct Halfedge {
    Value twist;
    /// The colour, opaque, as the format has no opacity.
    glm::dvec4 color{0.0, 0.0, 0.0, 1.0};
    std::array<int, 2> handles{-1, -1};
    int twin = -1, prev = -1, next = -1, patch = -1;
    int first_child = -1;

    bool is_child = false;
    /// Of children only.
    int parent = -1;
    Interval interval;
    bool recolored = false;
    /// Of all other half-edges only.
    int origin = -1;

    bool is_bar() const { return is_child && handles[0] < 0 && handles[1] < 0; }
    bool is_stem() const { return is_child && !is_bar(); }
  };

  std::vector<Point> points;
  std::vector<Handle> handles;
  /// A half-edge of each patch; -1 if the patch was taken out.
  std::vector<int> patches;
  std::vector<Halfedge> halfedges;

  /// Returns the line of a record, counted from 1.
  int line_of_patch(int patch) const {
    return 3 + int(points.size()) + int(handles.size()) + patch;
  }
  int line_of_halfedge(int h) const { return line_of_patch(int(patches.size())) + h; }
};

/// The largest number that a file may hold.
inline constexpr double largest_hemesh_number = 1e9;

/// Reads the records of the text. Checks nothing but that numbers are finite and at most
/// largest_hemesh_number. Throws InputError naming `name` and the line.
HemeshFile parse_hemesh(std::string_view text, const std::string& name);

/// Returns the text of the records, with numbers in the shortest form that reads back as the very
/// same. The first child of each half-edge must be set correctly, as some programs read it.
std::string format_hemesh(const HemeshFile& file);

/// Throws InputError with the text `NAME, line LINE: REASON.`
[[noreturn]] void fail_at_line(const std::string& name, int line, const Message& reason);

}  // namespace gradmesh
