#include "formats/code/swift_code.h"

#include "formats/code/code_text.h"

namespace gradmesh {
namespace {

constexpr int swift_indent = 8;

/// What all views end in, with the arrays before it: control points are places.
constexpr const char* swift_gradient = R"(
    private static func gradient(width: Int, height: Int, first: Int) -> MeshGradient {
        let vertices = first..<(first + width * height)
        let places: [MeshGradient.BezierPoint] = vertices.map { vertex in
            func point(_ number: Int) -> SIMD2<Float> {
                SIMD2<Float>(points[10 * vertex + 2 * number], points[10 * vertex + 2 * number + 1])
            }
            return MeshGradient.BezierPoint(
                position: point(0),
                leadingControlPoint: point(1),
                topControlPoint: point(2),
                trailingControlPoint: point(3),
                bottomControlPoint: point(4))
        }
        let shades: [Color] = vertices.map { vertex in
            let argb = colors[vertex]
            func channel(_ shift: UInt32) -> Double { Double((argb >> shift) & 0xFF) / 255 }
            return Color(
                .sRGB, red: channel(16), green: channel(8), blue: channel(0), opacity: channel(24))
        }
        return MeshGradient(
            width: width, height: height, locations: .bezierPoints(places), colors: .colors(shades),
            smoothsColors: )";

constexpr const char* swift_outline = R"(
    private struct Outline: Shape {
        let points: [Float]
        let counts: [Int]

        func path(in rect: CGRect) -> Path {
            var path = Path()
            var first = 0
            for count in counts {
                let corners: [CGPoint] = (first..<(first + count)).map { corner in
                    CGPoint(
                        x: rect.minX + CGFloat(points[2 * corner]) * rect.width,
                        y: rect.minY + CGFloat(points[2 * corner + 1]) * rect.height)
                }
                path.addLines(corners)
                path.closeSubpath()
                first += count
            }
            return path
        }
    }
)";

std::string swift_array(const std::string& name, const char* type, const CodeLines& lines) {
  return "\n    private static let " + name + ": [" + type + "] = [\n" +
         code_lines(lines, swift_indent) + "    ]\n";
}

CodeLines swift_points(const MeshCode& mesh) {
  CodeLines lines;
  for (const CodeGrid& grid : mesh.grids)
    for (const CodeVertex& vertex : grid.vertices) {
      std::vector<std::string>& line = lines.emplace_back();
      const auto add = [&](glm::dvec2 p) {
        line.push_back(code_number(code_steps(p.x)));
        line.push_back(code_number(code_steps(p.y)));
      };
      add(vertex.position);
      for (const glm::dvec2 handle : vertex.handles) add(handle);
    }
  return lines;
}

/// Returns what is passed to gradient() for a grid.
std::string swift_arguments(const CodeGrid& grid, std::size_t first) {
  return "(width: " + std::to_string(grid.columns + 1) +
         ", height: " + std::to_string(grid.rows + 1) + ", first: " + std::to_string(first) + ")";
}

std::string swift_body(const MeshCode& mesh) {
  std::string text = "    var body: some View {\n";
  if (mesh.grids.size() == 1) {
    text += "        Self.gradient" + swift_arguments(mesh.grids[0], 0) + "\n";
  } else {
    text +=
        "        ZStack {\n"
        "            ForEach(0..<Self.grids.count, id: \\.self) { number in\n"
        "                let grid = Self.grids[number]\n"
        "                Self.gradient(width: grid.width, height: grid.height, first: "
        "grid.first)\n"
        "            }\n"
        "        }\n";
  }
  for (std::size_t i = 1; i <= mesh.clips.size(); ++i) {
    const std::string number = std::to_string(i);
    text += "            .clipShape(\n                Outline(points: Self.outline" + number +
            ", counts: Self.counts" + number + ")";
    if (mesh.clips[i - 1].rule == FillRule::evenodd) text += ", style: FillStyle(eoFill: true)";
    text += ")\n";
  }
  // Without a group of its own every part would become transparent by itself.
  if (mesh.opacity < 1)
    text += "            .compositingGroup()\n            .opacity(" +
            code_number(code_steps(mesh.opacity)) + ")\n";
  return text + "            .aspectRatio(" + code_ratio(mesh.aspect_ratio) +
         ", contentMode: .fit)\n    }\n";
}

std::string swift_grids(const MeshCode& mesh) {
  std::string text =
      "\n    private static let grids: [(width: Int, height: Int, first: Int)] = [\n";
  std::size_t first = 0;
  for (const CodeGrid& grid : mesh.grids) {
    text += "        " + swift_arguments(grid, first) + ",\n";
    first += grid.vertices.size();
  }
  return text + "    ]\n";
}

std::string swift_view(const MeshCode& mesh) {
  std::string text = "\n/// The mesh of " + comment_text(mesh.id) +
                     ".\n@available(iOS 18.0, macOS 15.0, tvOS 18.0, watchOS 11.0, visionOS 2.0, "
                     "*)\nstruct " +
                     mesh.name + ": View {\n" + swift_body(mesh);
  if (mesh.grids.size() > 1) text += swift_grids(mesh);
  text +=
      "\n    // A line for each vertex, row by row: its place, and its control points to the left, "
      "above,\n    // to the right and below.";
  text += swift_array("points", "Float", swift_points(mesh));
  text += "\n    // 0xAARRGGBB, row by row.";
  text += swift_array("colors", "UInt32", vertex_colors(mesh));
  for (std::size_t i = 1; i <= mesh.clips.size(); ++i) {
    const FilledOutline& clip = mesh.clips[i - 1];
    text += swift_array("outline" + std::to_string(i), "Float", outline_points(clip));
    text += swift_array("counts" + std::to_string(i), "Int", outline_counts(clip));
  }
  text += std::string(swift_gradient) + (mesh.smooth ? "true" : "false") + ")\n    }\n";
  if (!mesh.clips.empty()) text += swift_outline;
  return text + "}\n";
}

}  // namespace

std::string swift_code(const std::vector<MeshCode>& meshes, const std::string& origin) {
  std::string text = "// " + comment_text(origin) + "\n";
  if (!meshes.empty())
    text += "// In a view of SwiftUI: " + meshes.front().name + "().frame(width: 300)\n";
  text += "\nimport SwiftUI\n";
  for (const MeshCode& mesh : meshes) text += swift_view(mesh);
  return text;
}

}  // namespace gradmesh
