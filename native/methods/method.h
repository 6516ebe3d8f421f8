#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "pricing/price_table.h"
#include "trial/merge_trial.h"

namespace gradmesh {

/// The options of the methods. Method::options names those that a method heeds.
struct MethodOptions {
  std::uint64_t seed = 0;
  /// Weight of a region's size against its error (Eq. 7), 0..1.
  double omega = 0.75;
  /// Share of epsilon, 0 or more, above which edges bound the parts (6.2).
  double kappa = 0.05;
  /// The edges to merge, in this order, by either of their half-edges.
  std::vector<int> edges;
};

/// The input of a method: the method merges in `trial` and may use and add to `prices`, which are
/// of the mesh as it is now. It ends early if `watch` says so.
struct MethodRun {
  MergeTrial& trial;
  PriceTable& prices;
  const MethodOptions& options;
  StopWatch& watch;
};

/// A way to choose what is merged (paper, section 6).
struct Method {
  /// The name in options and reports, such as "dual-grid".
  std::string name;
  /// The members of MethodOptions that it heeds, by their names.
  std::vector<std::string> options;
  /// Merges; none if the method makes a plain mesh.
  std::function<void(const MethodRun&)> run;
  /// True if the method uses prices of regions or edges, so that there are some to save.
  bool needs_prices = false;
  /// True if a rectangle of patches stays a rectangle: then the method may work on smooth meshes
  /// too, and the result is written as one mesh gradient.
  bool keeps_rectangle = false;
  /// True if the caller names the edges to merge; it is an error if one of them cannot be merged.
  bool merges_named_edges = false;
  /// True if simplify() goes on and fits what was merged (best.h).
  bool fits = false;
  /// True if nothing is merged: the points of a rectangle of patches become fewer and its sides
  /// straight (plain/fewer_handles.h), and it is written as one mesh gradient.
  bool makes_plain = false;
};

/// Returns all methods, in the order in which lists show them.
const std::vector<Method>& all_methods();

/// Returns the method of that name; for `simplest` the best method. Throws std::invalid_argument
/// with the names of all methods if there is none.
const Method& method_named(const std::string& name);

/// Returns the names of all methods, in their order.
std::vector<std::string> method_names();

/// Returns what a person may ask for: `simplest`, and the names of all methods.
std::vector<std::string> method_choices();

/// Returns true if the method can simplify the mesh: a smooth mesh only where a rectangle stays
/// one, and a rectangle only where the mesh is one.
bool suits(const Method& method, const Mesh& mesh);

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
