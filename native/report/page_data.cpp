#include "report/page_data.h"

#include <algorithm>
#include <cmath>
#include <ranges>

#include "base/clamped_int.h"
#include "base/power_of_ten.h"
#include "draw/heat_scale.h"
#include "files/base64.h"
#include "files/image_file.h"
#include "form/handles.h"
#include "formats/json/elements.h"
#include "methods/method.h"
#include "metric/local_mean.h"
#include "metric/worst_places.h"
#include "reference/reference.h"

namespace gradmesh {
namespace {

using Json = nlohmann::ordered_json;

std::string address(const Image& image) {
  return "data:image/png;base64," + base64(png_bytes(image));
}

/// Returns the number that is written with `decimals` decimals.
double rounded(double value, int decimals) {
  const double scale = power_of_ten(decimals);
  return std::round(value * scale) / scale + 0.0;
}

Json pixels(const Cubic<Value>& curve, const Affine& to_pixels) {
  Json numbers = Json::array();
  for (const Value& value : {curve.p0, curve.bezier1(), curve.bezier2(), curve.p1}) {
    const glm::dvec2 at = to_pixels.point(value.position);
    numbers.insert(numbers.end(), {rounded(at.x, 3), rounded(at.y, 3)});
  }
  return numbers;
}

Json hermite(const Patch& patch, int decimals) {
  Json matrix = Json::array();
  for (const auto& row : patch.c)
    for (const Value& v : row) {
      Json entry = Json::array();
      for (int i = 0; i < 2; ++i) entry.push_back(rounded(v.position[i], decimals));
      for (int i = 0; i < 4; ++i) entry.push_back(rounded(v.color[i], 4));
      matrix.push_back(std::move(entry));
    }
  return matrix;
}

/// Returns the prices of merging the edges, for each half-edge that is alive.
Json merging(const Mesh& mesh, const std::vector<EdgePrice>& prices) {
  std::vector<Json> known(mesh.halfedge_slots());
  for (const EdgePrice& p : prices)
    known[p.edge.value] = p.obstacle != MergeObstacle::none ? Json(describe(p.obstacle).english())
                          : std::isfinite(p.error)          ? Json(p.error)
                                                            : Json("it cannot be merged");
  Json list = Json::array();
  for (const Halfedge h : mesh.halfedges()) list.push_back(known[mesh.curve(h).value]);
  return list;
}

Json regions_json(const std::vector<RegionPrice>& regions, const std::vector<double>& fitted) {
  Json list = Json::array();
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const RegionPrice& r = regions[i];
    Json faces = Json::array();
    for (const Face patch : r.patches) faces.push_back(patch.value);
    list.push_back({{"rows", r.region.rows},
                    {"columns", r.region.columns},
                    {"error", r.error},
                    {"fitted", fitted.empty() ? Json(nullptr) : Json(fitted[i])},
                    {"faces", std::move(faces)}});
  }
  return list;
}

/// Returns for each option that only some methods heed the names of these methods.
Json heeded_by() {
  Json result;
  for (const char* option : {"seed", "omega", "kappa"}) result[option] = methods_with(option);
  return result;
}

Json mesh_json(const PageMesh& shown, const Image& picture) {
  const Mesh& mesh = shown.mesh;
  const Affine& to_pixels = shown.frame.to_pixels;
  // To a hundredth of a pixel, in mesh units.
  const int decimals =
      clamped_int(std::ceil(2 + 0.5 * std::log10(std::abs(to_pixels.determinant()))), 0, 400);
  const auto is_junction = [&](Point p) { return mesh[p].is_junction(); };
  Json curves = Json::array(), matrices = Json::array();
  for (const Halfedge h : mesh.halfedges())
    curves.push_back(pixels(mesh.is_leaf(h) ? mesh.side_of(h) : mesh.curve_of(h), to_pixels));
  for (const Face f : mesh.faces()) matrices.push_back(hermite(mesh.patch(f), decimals));
  return {{"file", shown.file},
          {"picture", address(picture)},
          {"color_model", mesh.color_model() == ColorModel::bicubic ? "bicubic" : "bilinear"},
          {"handles", count_handles(mesh)},
          {"patches", mesh.face_count()},
          {"objects", shown.objects},
          {"points", std::ranges::distance(mesh.points())},
          {"t_junctions", std::ranges::count_if(mesh.points(), is_junction)},
          {"elements", elements_json(mesh)},
          {"curves", std::move(curves)},
          {"hermite", std::move(matrices)},
          {"merging", Json::array()},
          {"regions", Json::array()}};
}

/// Returns the map as a picture in colours from no error to the largest error in it.
Json errors_json(const Plane& map) {
  constexpr int steps = 16;
  const float largest = *std::ranges::max_element(map.samples);
  Image picture(map.width, map.height);
  for (std::size_t i = 0; i < map.samples.size(); ++i) {
    const glm::dvec3 color = heat_color(largest > 0 ? map.samples[i] / largest : 0);
    for (int k = 0; k < 3; ++k)
      picture.samples[std::size_t(k) * picture.pixels() + i] =
          std::uint8_t(std::lround(255 * color[k]));
  }
  Json scale = Json::array();
  for (int i = 0; i <= steps; ++i) scale.push_back(hex_color(heat_color(double(i) / steps)));
  return {{"picture", address(picture)}, {"largest", largest}, {"scale", scale}};
}

Json worst_json(const std::vector<WorstPlace>& places) {
  Json list = Json::array();
  for (const WorstPlace& worst : places)
    list.push_back({{"x", worst.place.x}, {"y", worst.place.y}, {"error", worst.error}});
  return list;
}

}  // namespace

Json page_data(const Page& page) {
  constexpr int most_places = 5;
  const PageMesh &before = page.before, &after = page.after;
  const Reference reference(*page.original, before.frame, page.metric);
  const Image& first = reference.painting().image;
  const Image second = paint_whole(after.mesh, after.frame).image;
  const Plane map = reference.metric().map(second);
  Json before_json = mesh_json(before, first);
  before_json["merging"] = merging(before.mesh, page.edges);
  before_json["regions"] = regions_json(page.regions, page.fitted);
  return {{"id", page.id},
          {"width", first.width},
          {"height", first.height},
          {"metric", label(page.metric)},
          {"error", mean(map)},
          {"local_error", largest_local_mean(map)},
          {"epsilon", page.epsilon},
          {"errors", errors_json(map)},
          {"worst", worst_json(worst_places(map, reference.away_from_outline(), most_places))},
          {"run", page.run},
          {"heeded_by", heeded_by()},
          {"before", std::move(before_json)},
          {"after", mesh_json(after, second)}};
}

}  // namespace gradmesh
