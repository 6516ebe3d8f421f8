#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "pricing/price_table.h"
#include "trial/merge_trial.h"

namespace gradmesh {

/// What a person may set of a method; which method heeds what is in its entry.
struct MethodOptions {
  std::uint64_t seed = 0;
  /// Weight of a region's size against its error (Eq. 7), 0..1.
  double omega = 0.75;
  /// Edges that cost more than this share of epsilon bound the parts (6.2), 0 or more.
  double kappa = 0.05;
  /// The edges to merge, in this order, by either of their half-edges.
  std::vector<int> edges;
};

/// What a method works on: it merges in `trial` and may use and add to `prices`, which are of the
/// mesh as it is now. It ends early where `watch` says so.
struct MethodRun {
  MergeTrial& trial;
  PriceTable& prices;
  const MethodOptions& options;
  StopWatch& watch;
};

/// A way to choose what is merged (paper, section 6).
struct Method {
  /// As in options and reports: "dual-grid".
  std::string name;
  /// The members of MethodOptions that it heeds, by their names.
  std::vector<std::string> options;
  std::function<void(const MethodRun&)> run;
  /// Whether it uses prices of regions or edges, so that there are some to save.
  bool needs_prices = false;
  /// Whether it leaves a rectangle of patches one: then it may work on smooth meshes too, and the
  /// result is written as one mesh gradient.
  bool keeps_rectangle = false;
  /// Whether the caller names what is merged: all of that or nothing.
  bool merges_named_edges = false;
  /// Whether simplify() goes on and fits what was merged (best.h).
  bool fits = false;
};

/// All methods, in the order in which lists show them.
const std::vector<Method>& all_methods();

/// The method of that name. Throws std::invalid_argument with the names there are.
const Method& method_named(const std::string& name);

/// The names of all methods, in their order.
std::vector<std::string> method_names();

/// The names of all methods that heed an option, in their order.
std::vector<std::string> methods_with(const std::string& option);

/// The methods that the rest of the program has to name.
inline constexpr const char* default_method = "best";
/// Of smooth meshes, and where one mesh gradient shall be left.
inline constexpr const char* line_method = "lines";

}  // namespace gradmesh
