#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/document.h"
#include "app/picture_comparison.h"
#include "base/progress.h"
#include "files/picture_file.h"
#include "form/counts.h"
#include "simplify/curve.h"
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
  /// True if Tracing::curve is found.
  bool wants_curve = false;
  /// The number of threads, 0 for all cores, on which no result depends; and the seconds after
  /// which the best mesh so far is taken, 0 for no limit.
  int threads = 0;
  double time_budget = 0;
  ProgressCallback progress = {};
};

/// What became of a picture.
struct Tracing {
  /// An SVG document with one mesh gradient: over a page of the size of the picture, or on a shape
  /// in the document that the shape is in.
  std::unique_ptr<Document> document;
  /// The object that has the mesh.
  std::string id;
  MeshCounts counts;
  int rows = 0, columns = 0;
  PictureErrors errors;
  /// Against the picture without what is smaller than TraceOptions::detail.
  PictureErrors errors_without_detail;
  /// The mesh and what is left of it as one line after the other is taken out (traced_curve), if
  /// that was asked for.
  Curve curve;
  /// True if the watch ended it early.
  bool was_stopped = false;
  double seconds = 0;
};

/// Makes a mesh that looks like a picture, over a page of the size of its file; `name` stands in
/// messages. The errors are those of the document: where the picture was not reduced, of what
/// Inkscape paints of it. Throws std::invalid_argument if an option is out of range.
Tracing trace(const Picture& picture, const std::string& name, const TraceOptions& options);

/// Fills the shape with this id, in an SVG document that shows the picture (SvgMeshes::
/// shape_on_picture), by a mesh that looks like the picture there. Only what is in the shape counts
/// in the errors. Throws as trace does, and InputError if the document has no such shape or does
/// not show the picture, and if none of the picture is in the shape.
Tracing trace_shape(const Picture& picture, std::unique_ptr<Document> document,
                    const std::string& id, const TraceOptions& options);

/// Makes a mesh that looks like the picture of a file, which is reduced to `resolution` pixels
/// along the longer side; `name` is that of the document. Throws InputError where it cannot be read
/// (files/picture_file.h), std::invalid_argument also if the resolution is out of range.
Tracing trace_file(const std::filesystem::path& picture, int resolution, const std::string& name,
                   const TraceOptions& options);

/// Fills the shape with this id in the SVG document of a file, as trace_shape does, by a mesh of
/// the picture of another file, which is reduced so that the shape is `resolution` pixels long.
Tracing trace_file_in_shape(const std::filesystem::path& picture, int resolution,
                            const std::filesystem::path& outline, const std::string& id,
                            const TraceOptions& options);

/// Returns all of it but the document, as --report and Python have it.
nlohmann::ordered_json tracing_json(const Tracing& tracing);

/// Returns what a person is told of a mesh that does not look like its picture, and what would
/// help; nothing if it does.
std::optional<Message> what_would_help(const Tracing& tracing);

}  // namespace gradmesh
