#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "base/progress.h"
#include "problem/problem.h"

namespace gradmesh {

/// A way to make a mesh simpler (paper, section 6).
struct Method {
  /// The name in options and reports, such as "dual-grid".
  std::string name;
  /// The members of MethodOptions that it heeds, by their names.
  std::vector<std::string> options;
  /// Returns what the method makes of the problem, or Problem::unchanged(). Ends early if the watch
  /// says so. Throws InputError if something that the problem names cannot be done.
  std::function<Candidate(const Problem&, StopWatch&)> run;
  /// Returns why the method cannot work on a mesh; nothing if it can.
  std::optional<Message> (*why_not)(const Mesh&);
  /// True if the method uses prices of regions or edges, so that there are some to save.
  bool needs_prices = false;
  /// True if a rectangle of patches stays a rectangle: then the method may work on smooth meshes
  /// too, and the result is written as one mesh gradient.
  bool keeps_rectangle = false;
  /// True if the caller names the edges to merge; it is an error if one of them cannot be merged.
  bool merges_named_edges = false;
  /// What the method makes few where nobody says what.
  Count count = Count::patches;
  /// True if the method heeds Bounds::target. Others reach a target by a search over epsilon.
  bool meets_targets = false;
};

/// Returns true if the method can work on the mesh.
inline bool suits(const Method& method, const Mesh& mesh) { return !method.why_not(mesh); }

/// Returns all methods, in the order in which lists show them.
const std::vector<Method>& all_methods();

/// Returns the method of that name; for `simplest` the best method. Throws std::invalid_argument
/// with the names of all methods if there is none.
const Method& method_named(std::string_view name);

/// Returns the names of all methods, in their order.
std::vector<std::string> method_names();

/// Returns what a person may ask for: `simplest`, and the names of all methods.
std::vector<std::string> method_choices();

/// Returns the names of all methods that heed an option, in their order.
std::vector<std::string> methods_with(const std::string& option);

/// What is done where nobody names a method: in a document `plain_method` where that leaves less to
/// handle, and else `best_method`, as everywhere else.
inline constexpr const char* simplest = "simplest";
/// The method that leaves the fewest patches.
inline constexpr const char* best_method = "best";
/// The method that leaves the fewest handles of one mesh gradient.
inline constexpr const char* plain_method = "plain";
/// The method for smooth meshes, and for results that are to stay one mesh gradient.
inline constexpr const char* line_method = "lines";

}  // namespace gradmesh
