#include "formats/code/compose_code.h"

#include <set>

#include "formats/code/code_names.h"
#include "formats/code/code_text.h"

namespace gradmesh {
namespace {

constexpr std::size_t most_numbers_of_object = 4000;

/// Control points are offsets from the place of the vertex.
constexpr const char* compose_painter = R"(
    fun painter(rows: Int, columns: Int, first: Int) =
        MeshGradientPainter(rows, columns, hasBicubicColor = SMOOTH) {
            for (row in 0..rows) {
                for (column in 0..columns) {
                    val vertex = first + row * (columns + 1) + column
                    fun offset(number: Int) =
                        Offset(points[10 * vertex + 2 * number], points[10 * vertex + 2 * number + 1])
                    setVertex(
                        row = row,
                        column = column,
                        position = offset(0),
                        color = Color(colors[vertex]),
                        leftControlPoint = offset(1),
                        topControlPoint = offset(2),
                        rightControlPoint = offset(3),
                        bottomControlPoint = offset(4),
                    )
                }
            }
        }
)";

constexpr const char* compose_outline = R"(
    private fun outline(points: FloatArray, counts: IntArray, rule: PathFillType) =
        GenericShape { size, _ ->
            fillType = rule
            var at = 0
            for (count in counts) {
                for (corner in 0 until count) {
                    val x = points[at++] * size.width
                    val y = points[at++] * size.height
                    if (corner == 0) moveTo(x, y) else lineTo(x, y)
                }
                close()
            }
        }
)";

/// An array of Kotlin.
struct KotlinArray {
  /// Of the property, and what the objects with parts of it are called.
  std::string name, part;
  /// "float", "int" or "long".
  std::string type;
  CodeLines lines;
};

/// Returns the property that has all numbers of the array, and the objects that hold them.
std::string kotlin_array(const KotlinArray& array) {
  std::vector<CodeLines> parts;
  std::size_t numbers = most_numbers_of_object;
  for (const std::vector<std::string>& line : array.lines) {
    if (numbers + line.size() > most_numbers_of_object && (parts.empty() || numbers > 0)) {
      parts.emplace_back();
      numbers = 0;
    }
    parts.back().push_back(line);
    numbers += line.size();
  }
  if (parts.empty()) parts.emplace_back();
  std::string text = "\n    private val " + array.name + " =", objects;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string object = array.part + std::to_string(i + 1);
    // A sign at the end of a line, as one at its beginning would be an expression of its own.
    text += std::string(i == 0 ? "" : " +") + (i > 0 && i % 4 == 0 ? "\n        " : " ") + object +
            ".numbers";
    objects += "\n    private object " + object + " {\n        val numbers = " + array.type +
               "ArrayOf(\n" + code_lines(parts[i], 12, array.type == "float" ? "f" : "") +
               "        )\n    }\n";
  }
  return text + "\n" + objects;
}

CodeLines compose_points(const MeshCode& mesh) {
  CodeLines lines;
  for (const CodeGrid& grid : mesh.grids)
    for (const CodeVertex& vertex : grid.vertices) {
      std::vector<std::string>& line = lines.emplace_back();
      const std::int64_t x = code_steps(vertex.position.x), y = code_steps(vertex.position.y);
      line = {code_number(x), code_number(y)};
      // Differences of the rounded places, so that handles end where those of SwiftUI do.
      for (const glm::dvec2 handle : vertex.handles) {
        line.push_back(code_number(code_steps(handle.x) - x));
        line.push_back(code_number(code_steps(handle.y) - y));
      }
    }
  return lines;
}

std::string data_name(const MeshCode& mesh) {
  return mesh.name + std::string(CodeNames::data_suffix);
}

std::string compose_function(const MeshCode& mesh) {
  const std::string data = data_name(mesh);
  const bool is_one = mesh.grids.size() == 1;
  std::string text = "\n// The mesh of " + comment_text(mesh.id) + ".\n@Composable\nfun " +
                     mesh.name + "(modifier: Modifier = Modifier) {\n";
  if (is_one)
    text += "    val painter = remember { " + data +
            ".painter(rows = " + std::to_string(mesh.grids[0].rows) +
            ", columns = " + std::to_string(mesh.grids[0].columns) + ", first = 0) }\n";
  else
    text += "    val painters = remember { " + data + ".painters() }\n";
  text +=
      "    val frame = modifier\n        .aspectRatio(" + code_ratio(mesh.aspect_ratio) + "f)\n";
  if (mesh.opacity < 1) text += "        .alpha(" + code_number(code_steps(mesh.opacity)) + "f)\n";
  for (std::size_t i = 1; i <= mesh.clips.size(); ++i)
    text += "        .clip(" + data + ".shape" + std::to_string(i) + ")\n";
  return text + (is_one
                     ? "    Box(frame.paint(painter))\n}\n"
                     : "    Box(painters.fold(frame) { all, painter -> all.paint(painter) })\n}\n");
}

/// Returns three numbers for each grid: its rows, its columns and its first vertex.
CodeLines compose_grids(const MeshCode& mesh) {
  CodeLines lines;
  std::size_t first = 0;
  for (const CodeGrid& grid : mesh.grids) {
    lines.push_back(
        {std::to_string(grid.rows), std::to_string(grid.columns), std::to_string(first)});
    first += grid.vertices.size();
  }
  return lines;
}

std::string compose_data(const MeshCode& mesh) {
  std::string text = "\nprivate object " + data_name(mesh) + " {\n";
  text +=
      "    // A line for each vertex, row by row: its place, and where from there its control "
      "points are\n    // to the left, above, to the right and below.";
  text += kotlin_array({"points", "Points", "float", compose_points(mesh)});
  text += "\n    // 0xAARRGGBB, row by row.";
  text += kotlin_array({"colors", "Colors", "long", vertex_colors(mesh)});
  if (mesh.grids.size() > 1) {
    text += "\n    // Rows and columns of patches, and the first vertex.";
    text += kotlin_array({"grids", "Grids", "int", compose_grids(mesh)});
    text +=
        "\n    fun painters() =\n        List(grids.size / 3) { i -> painter(grids[3 * i], "
        "grids[3 * i + 1], grids[3 * i + 2]) }\n";
  }
  std::string painter = compose_painter;
  const std::string place = "SMOOTH";
  painter.replace(painter.find(place), place.size(), mesh.smooth ? "true" : "false");
  text += painter;
  for (std::size_t i = 1; i <= mesh.clips.size(); ++i) {
    const std::string number = std::to_string(i);
    const FilledOutline& clip = mesh.clips[i - 1];
    text += kotlin_array(
        {"outline" + number, "Outline" + number + "Part", "float", outline_points(clip)});
    text +=
        kotlin_array({"counts" + number, "Counts" + number + "Part", "int", outline_counts(clip)});
    text += "\n    val shape" + number + " = outline(outline" + number + ", counts" + number +
            ", PathFillType." + (clip.rule == FillRule::evenodd ? "EvenOdd" : "NonZero") + ")\n";
  }
  if (!mesh.clips.empty()) text += compose_outline;
  return text + "}\n";
}

/// Returns the imports that the meshes need, sorted.
std::string compose_imports(const std::vector<MeshCode>& meshes) {
  std::set<std::string> names{"foundation.layout.Box",
                              "foundation.layout.aspectRatio",
                              "runtime.Composable",
                              "runtime.remember",
                              "ui.Modifier",
                              "ui.draw.paint",
                              "ui.geometry.Offset",
                              "ui.graphics.Color",
                              "ui.graphics.MeshGradientPainter"};
  for (const MeshCode& mesh : meshes) {
    if (mesh.opacity < 1) names.insert("ui.draw.alpha");
    if (!mesh.clips.empty())
      names.insert({"foundation.shape.GenericShape", "ui.draw.clip", "ui.graphics.PathFillType"});
  }
  std::string text;
  for (const std::string& name : names) text += "import androidx.compose." + name + "\n";
  return text;
}

}  // namespace

std::string compose_code(const std::vector<MeshCode>& meshes, const std::string& origin) {
  std::string text = "// " + comment_text(origin) + "\n";
  if (!meshes.empty())
    text += "// In a composable: " + meshes.front().name + "(Modifier.width(300.dp))\n";
  text += "\n" + compose_imports(meshes);
  for (const MeshCode& mesh : meshes) text += compose_function(mesh) + compose_data(mesh);
  return text;
}

}  // namespace gradmesh
