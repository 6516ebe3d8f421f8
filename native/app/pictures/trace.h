#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "app/document/weighted_shapes.h"
#include "app/pictures/picture_comparison.h"
#include "base/image.h"
#include "base/progress.h"
#include "files/picture_file.h"
#include "form/counts.h"
#include "simplify/options.h"
#include "simplify/state_curve.h"

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
  /// Ids of open paths in the document along which lines of its meshes are to run
  /// (trace/guided_grid.h).
  std::vector<std::string> guides = {};
  /// Where a mesh is to be closer to its picture: what shapes of the document cover counts so many
  /// times when lines are put in and fitted. Errors, and epsilon, know no weights.
  ShapeWeights weights = {};
  /// True if Tracing::curve is found.
  bool wants_curve = false;
  /// The number of threads, 0 for all cores, on which no result depends; and the seconds after
  /// which the best mesh so far is taken, 0 for no limit.
  int threads = 0;
  double time_budget = 0;
  ProgressCallback progress = {};
  /// Called with what the mesh so far looks like, over the picture it is made of, some times a
  /// second and from the thread that started the run. No result depends on it.
  std::function<void(const Image&)> show = {};
};

/// What became of a picture.
struct Tracing {
  /// The object that has the mesh.
  std::string id;
  /// The image of the document that it was traced from; empty for another picture.
  std::string image = {};
  MeshCounts counts;
  int rows = 0, columns = 0;
  PictureErrors errors;
  /// Against the picture without what is smaller than TraceOptions::detail.
  PictureErrors errors_without_detail;
  /// The mesh and what is left of it as one line after the other is taken out, if
  /// that was asked for.
  StateCurve curve;
  /// How many of the lines to follow no line of the mesh follows, as they lie elsewhere or as it
  /// cannot.
  std::size_t unused_guides = 0;
  /// True if the watch ended it early.
  bool was_stopped = false;
  double seconds = 0;
};

/// A document with the mesh of a picture.
struct TracedDocument {
  std::unique_ptr<Document> document;
  Tracing tracing;
};

/// What of an SVG document becomes meshes.
struct ToTrace {
  /// Shapes, each of which becomes a mesh of what it surrounds, and images, each of which gets a
  /// mesh of all that is seen of it above itself.
  std::vector<std::string> ids;
  /// The image that the shapes lie on; empty for the one below each (formats/svg/picture/
  /// document_image.h).
  std::string image = {};
};

/// Makes a mesh that looks like a picture, over a page of the size of its file; `name` stands in
/// messages. The errors are those of the document: where the picture was not reduced, of what
/// Inkscape paints of it. Throws std::invalid_argument if an option is out of range.
TracedDocument trace(const Picture& picture, const std::string& name, const TraceOptions& options);

/// Makes a mesh that looks like the picture of a file, which is reduced to `resolution` pixels
/// along the longer side; `name` is that of the document. Throws InputError where it cannot be read
/// (files/picture_file.h), std::invalid_argument also if the resolution is out of range.
TracedDocument trace_file(const std::filesystem::path& picture, int resolution,
                          const std::string& name, const TraceOptions& options);

/// Fills the shape with this id, in the SVG document of a file, by a mesh that looks like the
/// picture of another file there (SvgDocument::shape_on_picture), which is reduced so that the
/// shape is `resolution` pixels long. An empty path is that of the picture which the document
/// shows. Only what is in the shape counts in the errors. Throws as trace_file does, and InputError
/// if the document has no such shape or does not show the picture, and if none of the picture is in
/// the shape.
TracedDocument trace_file_in_shape(const std::filesystem::path& picture, int resolution,
                                   const std::filesystem::path& outline, const std::string& id,
                                   const TraceOptions& options);

/// Does so with the pictures that a document shows, in place. What was done before the watch ended
/// it is returned, which is the mesh at which that happened and those before. Throws as
/// trace_file_in_shape does; the document is unchanged then.
std::vector<Tracing> trace_in(Document& document, const ToTrace& what, int resolution,
                              const TraceOptions& options);

/// Returns what a person is told of a mesh that does not look like its picture, and what would
/// help; nothing if it does.
std::optional<Message> what_would_help(const Tracing& tracing);

}  // namespace gradmesh
