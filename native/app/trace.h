#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/document.h"
#include "base/image.h"
#include "base/progress.h"
#include "form/counts.h"
#include "simplify/options.h"

namespace gradmesh {

struct TraceOptions {
  /// At most how many points, 4 or more.
  int handles = 1000;
  /// The FLIP against the picture at which a mesh is close enough, 0..1. One level everywhere is
  /// 0.03, and a picture fills its page.
  double epsilon = 0.03;
  /// Nothing smaller is followed, in pixels of the picture, 1 or more: noise and texture are no
  /// gradient.
  double detail = 1;
  /// The number of threads, 0 for all cores, on which no result depends; and the seconds after
  /// which the best mesh so far is taken, 0 for no limit.
  int threads = 0;
  double time_budget = 0;
  ProgressCallback progress = {};
};

/// How a painted mesh differs from a picture, both over white.
struct PictureErrors {
  /// The root of the mean square and the mean of the differences, in levels, 0..255.
  double rmse = 0, mean = 0;
  /// 0..1.
  double flip = 0;
};

/// What became of a picture.
struct Tracing {
  /// An SVG document of the size of the picture with one mesh gradient over all of it.
  std::unique_ptr<Document> document;
  MeshCounts counts;
  int rows = 0, columns = 0;
  PictureErrors errors;
  /// Against the picture without what is smaller than TraceOptions::detail.
  PictureErrors errors_without_detail;
  /// True if the watch ended it early.
  bool was_stopped = false;
  double seconds = 0;
};

/// Makes a mesh that looks like a picture. `size` is that of the page, in pixels, of which
/// `picture` may be a smaller image; `name` stands in messages. The errors are those of the
/// document: where the picture has the size of the page, of what Inkscape paints of it. Throws
/// std::invalid_argument if an option is out of range.
Tracing trace(const RgbaImage& picture, glm::dvec2 size, const std::string& name,
              const TraceOptions& options);

/// Makes a mesh that looks like the picture of a file, which is reduced to `resolution` pixels
/// along the longer side; `name` is that of the document. Throws InputError where it cannot be read
/// (files/picture_file.h), std::invalid_argument also if the resolution is out of range.
Tracing trace_file(const std::filesystem::path& picture, int resolution, const std::string& name,
                   const TraceOptions& options);

/// Returns all of it but the document, as --report and Python have it.
nlohmann::ordered_json tracing_json(const Tracing& tracing);

/// Returns what a person is told of a mesh that does not look like its picture, and what would
/// help; nothing if it does.
std::optional<Message> what_would_help(const Tracing& tracing);

}  // namespace gradmesh
