#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "app/export/draw_document.h"
#include "app/export/mesh_picture.h"
#include "app/export/page_on_mesh.h"
#include "files/atomic_file.h"
#include "report/report.h"
#include "service/functions.h"
#include "service/options.h"

namespace gradmesh {
namespace {

/// Returns the picture whose bytes, three for each pixel, row by row, an argument holds. Throws
/// std::invalid_argument if they are not as many as its size asks for.
Image picture(const Call& call, const std::string& name, int width, int height) {
  const std::string bytes = call.get<Bytes>(name).bytes;
  if (width < 1 || height < 1 || bytes.size() != std::size_t(width) * std::size_t(height) * 3)
    throw std::invalid_argument("a picture is an array of height x width x 3 bytes.");
  Image image(width, height);
  auto byte = bytes.begin();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) *image.at(x, y, c) = std::uint8_t(*byte++);
  return image;
}

/// Returns the error of each pixel of the picture `test` against `reference`.
Plane error_map(const Call& call) {
  const int width = call.get<int>("width"), height = call.get<int>("height");
  const Image reference = picture(call, "reference", width, height);
  const Image test = picture(call, "test", width, height);
  return make_metric(measure_options(call).metric, reference)->map(test);
}

}  // namespace

Json render_mesh(const Call& call) {
  const Document& document = call.document();
  const Document* const framed_as = call.optional_document("framed_as");
  const int resolution = measure_options(call).resolution;
  const MeshEntry entry = one_mesh(document, call);
  const Image image =
      call.get("like_inkscape", false)
          ? render_like_inkscape(document, entry, resolution, framed_as)
          : render(document, entry, resolution, *make_software_rasterizer(), framed_as);
  return {{"width", image.width},
          {"height", image.height},
          {"bytes", Json::binary(interleaved(image))}};
}

Json compare_pictures(const Call& call) { return mean(error_map(call)); }

Json differences_of_pictures(const Call& call) {
  const Plane map = error_map(call);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(map.samples.size() * sizeof(float));
  for (const float error : map.samples) {
    const auto bits = std::bit_cast<std::uint32_t>(error);
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(std::uint8_t(bits >> shift));
  }
  return Json::binary(std::move(bytes));
}

Json draw_mesh(const Call& call) {
  const Document& document = call.document();
  DrawOptions options;
  options.show = show_named(call.get<std::string>("show"));
  options.picture = call.get("picture", options.picture);
  options.simplify = run_options(call);
  return draw(document, one_mesh(document, call), options, analysis_paths(call));
}

Json write_report(const Call& call) {
  Document& before = call.document();
  const Document& after = call.document("after");
  ReportPageOptions options;
  options.run = call.get<std::optional<std::string>>("run");
  options.pricing = run_options(call);
  check(options.pricing);
  take_renderer(options.pricing, call);
  for (const OptionEntry& option : all_options())
    if (call.has(option.name)) options.given.push_back(option.name);
  options.analyses = analysis_paths(call);
  const MeasuredAgainst measured(before, call);
  write_bytes(path_argument(call, "path"),
              page_html(page_on_mesh(before, one_mesh(before, call), after, one_mesh(after, call),
                                     options)));
  return nullptr;
}

}  // namespace gradmesh
