#pragma once

#include <algorithm>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "formats/code/mesh_code.h"
#include "geom/patch.h"
#include "mesh/build.h"

/// Reads back the code that swift_code() and compose_code() write of one mesh, and paints what the
/// toolkits say that they paint.
namespace gradmesh::test {

/// Returns the numbers between each match of `opening` and the next closing bracket, in one list.
inline std::vector<double> numbers_behind(const std::string& code, const std::string& opening) {
  std::vector<double> numbers;
  const std::regex begin(opening), number("0x[0-9A-F]+|-?[0-9]+(\\.[0-9]+)?");
  for (std::sregex_iterator at(code.begin(), code.end(), begin), none; at != none; ++at) {
    const auto from = code.begin() + at->position() + at->length();
    const std::string list(
        from, std::find_if(from, code.end(), [](char c) { return c == ']' || c == ')'; }));
    for (std::sregex_iterator n(list.begin(), list.end(), number); n != none; ++n) {
      const std::string text = n->str();
      numbers.push_back(text.starts_with("0x") ? double(std::stoul(text, nullptr, 16))
                                               : std::stod(text));
    }
  }
  return numbers;
}

/// What differs between the two languages.
struct CodeDialect {
  bool is_kotlin = false;

  /// Returns what begins an array of this name.
  std::string array(const std::string& name) const {
    if (!is_kotlin) return "static let " + name + ": \\[\\w+\\] = \\[";
    std::string part = name;
    part.front() = char(part.front() - 'a' + 'A');
    const bool is_numbered = part.back() >= '0' && part.back() <= '9';
    return "object " + part + (is_numbered ? "Part" : "") +
           "\\d+ \\{\\s+val numbers = \\w+ArrayOf\\(";
  }
};

/// Returns rows and columns of patches and the first vertex of each grid.
inline std::vector<std::array<std::size_t, 3>> grid_sizes(const std::string& code,
                                                          const CodeDialect& dialect) {
  std::vector<std::array<std::size_t, 3>> sizes;
  if (dialect.is_kotlin) {
    std::vector<double> numbers = numbers_behind(code, dialect.array("grids"));
    if (numbers.empty()) numbers = numbers_behind(code, "Data\\.painter\\(");
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
      sizes.push_back(
          {std::size_t(numbers[i]), std::size_t(numbers[i + 1]), std::size_t(numbers[i + 2])});
    return sizes;
  }
  const std::regex size("\\(width: (\\d+), height: (\\d+), first: (\\d+)\\)");
  for (std::sregex_iterator at(code.begin(), code.end(), size), none; at != none; ++at)
    sizes.push_back({std::stoul((*at)[2]) - 1, std::stoul((*at)[1]) - 1, std::stoul((*at)[3])});
  return sizes;
}

inline std::vector<FilledOutline> read_clips(const std::string& code, const CodeDialect& dialect) {
  std::vector<FilledOutline> clips;
  for (int i = 1;; ++i) {
    const std::string number = std::to_string(i);
    const auto counts = numbers_behind(code, dialect.array("counts" + number));
    if (counts.empty()) return clips;
    const auto points = numbers_behind(code, dialect.array("outline" + number));
    const std::string evenodd = dialect.is_kotlin
                                    ? "counts" + number + ", PathFillType.EvenOdd"
                                    : "counts" + number + "), style: FillStyle(eoFill: true)";
    FilledOutline& clip = clips.emplace_back();
    clip.rule = code.find(evenodd) != std::string::npos ? FillRule::evenodd : FillRule::nonzero;
    std::size_t at = 0;
    for (const double count : counts) {
      clip.outline.emplace_back();
      for (int k = 0; k < int(count); ++k, at += 2)
        clip.outline.back().emplace_back(points.at(at), points.at(at + 1));
    }
  }
}

inline MeshCode read_code(const std::string& code) {
  const CodeDialect dialect{code.find("import SwiftUI") == std::string::npos};
  MeshCode mesh;
  const auto points = numbers_behind(code, dialect.array("points"));
  const auto colors = numbers_behind(code, dialect.array("colors"));
  if (points.size() != 10 * colors.size()) throw std::runtime_error("ten numbers a vertex");
  std::size_t next = 0;
  for (const auto& [rows, columns, first] : grid_sizes(code, dialect)) {
    CodeGrid& grid = mesh.grids.emplace_back(CodeGrid{int(rows), int(columns), {}});
    if (first != next) throw std::runtime_error("grids follow each other");
    next += (rows + 1) * (columns + 1);
    for (std::size_t i = first; i < next; ++i) {
      CodeVertex& vertex = grid.vertices.emplace_back();
      const auto at = [&](std::size_t k) {
        return glm::dvec2(points.at(10 * i + 2 * k), points.at(10 * i + 2 * k + 1));
      };
      vertex.position = at(0);
      for (std::size_t k = 0; k < 4; ++k)
        vertex.handles[k] = at(k + 1) + (dialect.is_kotlin ? vertex.position : glm::dvec2(0.0));
      const auto argb = std::uint32_t(colors[i]);
      for (int channel = 0; channel < 4; ++channel)
        vertex.color[channel] = ((argb >> (8 * ((6 - channel) % 4))) & 0xFF) / 255.0;
    }
  }
  if (next != colors.size()) throw std::runtime_error("every vertex is of a grid");
  mesh.smooth = code.find(dialect.is_kotlin ? "hasBicubicColor = true" : "smoothsColors: true") !=
                std::string::npos;
  mesh.clips = read_clips(code, dialect);
  std::smatch ratio;
  if (!std::regex_search(code, ratio, std::regex("aspect[rR]atio\\(([-+.e0-9]+)")))
    throw std::runtime_error("no aspect ratio");
  mesh.aspect_ratio = std::stod(ratio[1]);
  return mesh;
}

/// Gives a patch the colours of Catmull and Rom's curves through the vertices of its grid, of which
/// those at the edges count twice.
inline void set_catmull_rom(const CodeGrid& grid, int row, int column, Patch& patch) {
  const auto color = [&](int i, int j) {
    i = std::clamp(i, 0, grid.rows);
    j = std::clamp(j, 0, grid.columns);
    return grid.vertices[std::size_t(i * (grid.columns + 1) + j)].color;
  };
  for (const int a : {0, 1})
    for (const int b : {0, 1}) {
      const int i = row + a, j = column + b;
      patch.c[1 + a][3 * b].color = 0.5 * (color(i + 1, j) - color(i - 1, j));
      patch.c[3 * a][1 + b].color = 0.5 * (color(i, j + 1) - color(i, j - 1));
      patch.c[1 + a][1 + b].color = 0.25 * (color(i + 1, j + 1) - color(i + 1, j - 1) -
                                            color(i - 1, j + 1) + color(i - 1, j - 1));
    }
}

/// Returns the patches of a grid, with the insides of Coons patches.
inline PatchGrid patches_of(const CodeGrid& grid, bool smooth) {
  PatchGrid patches{grid.rows, grid.columns, {}};
  for (int i = 0; i < grid.rows; ++i)
    for (int j = 0; j < grid.columns; ++j) {
      const auto vertex = [&](int row, int column) {
        return grid.vertices[std::size_t(row * (grid.columns + 1) + column)];
      };
      const std::array<CodeVertex, 4> corners{vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1),
                                              vertex(i + 1, j)};
      // The handles at the start and at the end of each side, clockwise from the top.
      constexpr std::size_t left = 0, top = 1, right = 2, bottom = 3;
      constexpr std::array<std::size_t, 4> starts{right, bottom, left, top};
      constexpr std::array<std::size_t, 4> ends{left, top, right, bottom};
      std::array<Cubic<Value>, 4> sides;
      for (std::size_t k = 0; k < 4; ++k) {
        const CodeVertex &a = corners[k], &b = corners[(k + 1) % 4];
        sides[k] = Cubic<Value>::from_bezier({a.position, a.color}, {a.handles[starts[k]], a.color},
                                             {b.handles[ends[k]], b.color}, {b.position, b.color});
      }
      Patch patch = patch_from_sides(sides, {});
      make_coons(patch);
      make_color_bilinear(patch);
      if (smooth) set_catmull_rom(grid, i, j, patch);
      patches.patches.push_back(patch);
    }
  return patches;
}

/// Returns the mesh that the code paints, in the unit square.
inline Mesh painted_by(const MeshCode& code) {
  std::vector<PatchGrid> grids;
  for (const CodeGrid& grid : code.grids) grids.push_back(patches_of(grid, code.smooth));
  MeshParts parts = parts_of(grids);
  if (code.smooth) parts.color_model = ColorModel::bicubic;
  return build_mesh(parts);
}

}  // namespace gradmesh::test
