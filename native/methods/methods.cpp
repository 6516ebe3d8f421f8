#include <algorithm>
#include <stdexcept>

#include "mesh/rectangle.h"
#include "methods/gqe.h"
#include "methods/grid.h"
#include "methods/lines.h"
#include "methods/manual.h"
#include "methods/method.h"
#include "methods/motorcycle.h"
#include "methods/random.h"

namespace gradmesh {
namespace {

/// Tries all edges in an order that follows the seed.
template <std::vector<Halfedge> order(const Mesh&, std::uint64_t)>
void in_order(const MethodRun& run) {
  const auto by_seed = [&](const Mesh& mesh) { return order(mesh, run.options.seed); };
  try_edges(run.trial, by_seed, run.watch);
}

void by_parts(const MethodRun& run) {
  select_motorcycle(run.trial, run.prices, {run.options.kappa, run.options.seed}, run.watch);
}

template <bool look_ahead>
void by_regions(const MethodRun& run) {
  merge_by_gqe(run.trial, run.prices, {run.options.omega, look_ahead}, run.watch);
}

void by_lines(const MethodRun& run) { take_out_lines(run.trial, run.watch); }

void by_name(const MethodRun& run) { merge_named_edges(run.trial, run.options.edges); }

}  // namespace

const std::vector<Method>& all_methods() {
  static const std::vector<Method> methods = {
      {.name = "random", .options = {"seed"}, .run = in_order<random_order>},
      {.name = "grid", .options = {"seed"}, .run = in_order<grid_order>},
      {.name = "dual-grid", .options = {"seed"}, .run = in_order<dual_grid_order>},
      {.name = "motorcycle", .options = {"seed", "kappa"}, .run = by_parts, .needs_prices = true},
      {.name = "gqe", .options = {"omega"}, .run = by_regions<false>, .needs_prices = true},
      {.name = "gqe1", .options = {"omega"}, .run = by_regions<true>, .needs_prices = true},
      {.name = best_method,
       .options = {"omega"},
       .run = by_regions<false>,
       .needs_prices = true,
       .fits = true},
      {.name = line_method, .options = {}, .run = by_lines, .keeps_rectangle = true},
      {.name = plain_method,
       .options = {},
       .run = {},
       .keeps_rectangle = true,
       .makes_plain = true},
      {.name = "manual", .options = {"edges"}, .run = by_name, .merges_named_edges = true},
  };
  return methods;
}

const Method& method_named(const std::string& wanted) {
  std::string known;
  for (const Method& method : all_methods()) {
    if (wanted == method.name || (wanted == simplest && method.name == best_method)) return method;
    known.append(known.empty() ? "" : ", ").append(method.name);
  }
  throw std::invalid_argument("the method '" + wanted + "' is not known; there are: " + known +
                              ".");
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const Method& method : all_methods()) names.push_back(method.name);
  return names;
}

std::vector<std::string> method_choices() {
  std::vector<std::string> choices = method_names();
  choices.insert(choices.begin(), simplest);
  return choices;
}

bool suits(const Method& method, const Mesh& mesh) {
  if (method.makes_plain && mesh.color_model() == ColorModel::bicubic) return false;
  return method.keeps_rectangle ? find_grid(mesh).has_value() : !mesh.is_smooth();
}

std::vector<std::string> methods_with(const std::string& option) {
  std::vector<std::string> names;
  for (const Method& method : all_methods())
    if (std::ranges::find(method.options, option) != method.options.end())
      names.push_back(method.name);
  return names;
}

}  // namespace gradmesh
