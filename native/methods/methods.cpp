#include <algorithm>
#include <stdexcept>

#include "form/handles.h"
#include "form/written_patch.h"
#include "mesh/rectangle.h"
#include "methods/best/best.h"
#include "methods/merging/gqe.h"
#include "methods/merging/grid.h"
#include "methods/merging/lines.h"
#include "methods/merging/manual.h"
#include "methods/merging/merging.h"
#include "methods/merging/motorcycle.h"
#include "methods/merging/random.h"
#include "methods/method.h"
#include "methods/plain/plain.h"

namespace gradmesh {
namespace {

/// Tries all edges in an order that follows the seed.
template <std::vector<Halfedge> order(const Mesh&, std::uint64_t)>
Candidate in_order(const Problem& problem, StopWatch& watch) {
  const auto by_seed = [&](const Mesh& mesh) { return order(mesh, problem.options.seed); };
  return merge_what_fits(problem, problem.trial()->trial,
                         [&](MergeTrial& trial, PriceTable&) { try_edges(trial, by_seed, watch); });
}

Candidate by_parts(const Problem& problem, StopWatch& watch) {
  const MotorcycleOptions options{problem.options.kappa, problem.options.seed};
  return merge_what_fits(problem, problem.pricing_trial()->trial,
                         [&](MergeTrial& trial, PriceTable& prices) {
                           select_motorcycle(trial, prices, options, watch);
                         });
}

template <bool look_ahead>
Candidate by_regions(const Problem& problem, StopWatch& watch) {
  const GqeOptions options{problem.options.omega, look_ahead};
  return merge_what_fits(
      problem, problem.pricing_trial()->trial,
      [&](MergeTrial& trial, PriceTable& prices) { merge_by_gqe(trial, prices, options, watch); });
}

Candidate by_name(const Problem& problem, StopWatch&) {
  return merge_what_fits(
      problem, problem.trial()->trial,
      [&](MergeTrial& trial, PriceTable&) { merge_named_edges(trial, problem.options.edges); },
      {.merges_again = false});
}

/// The colours of a smooth patch follow those of its neighbours in rows and columns.
std::optional<Message> needs_own_colors(const Mesh& mesh) {
  if (!mesh.is_smooth()) return std::nullopt;
  return Message(
      "its colours follow those of the neighbours (type=\"bicubic\"), so that only whole lines "
      "can be taken out, by the method lines.");
}

std::optional<Message> needs_lines(const Mesh& mesh) {
  if (find_grid(mesh)) return std::nullopt;
  return Message(
      "it is not one rectangle of patches without T-junctions, so no whole lines can be taken "
      "out: make one mesh of it first (To One Mesh, gradmesh one-mesh).");
}

/// A grid of points and handles has one colour at each point and nothing between.
std::optional<Message> needs_plain_grid(const Mesh& mesh) {
  if (mesh.color_model() == ColorModel::bicubic)
    return Message("its colours are bicubic, which a plain mesh gradient cannot hold.");
  if (!find_grid(mesh)) return Message("it is not one rectangle of patches without T-junctions.");
  if (mesh.has_fixed_faces()) {
    const double exact = last_bits_of(mesh);
    for (const Face f : mesh.faces())
      if (mesh.is_fixed(f) && needs_tensor(mesh.patch(f), exact))
        return Message(
            "a protected patch has handles inside, which a plain mesh gradient cannot hold.");
  }
  return std::nullopt;
}

}  // namespace

const std::vector<Method>& all_methods() {
  static const std::vector<Method> methods = {
      {"random", {"seed"}, in_order<random_order>, needs_own_colors},
      {"grid", {"seed"}, in_order<grid_order>, needs_own_colors},
      {"dual-grid", {"seed"}, in_order<dual_grid_order>, needs_own_colors},
      {.name = "motorcycle",
       .options = {"seed", "kappa"},
       .run = by_parts,
       .why_not = needs_own_colors,
       .needs_prices = true},
      {.name = "gqe",
       .options = {"omega"},
       .run = by_regions<false>,
       .why_not = needs_own_colors,
       .needs_prices = true},
      {.name = "gqe1",
       .options = {"omega"},
       .run = by_regions<true>,
       .why_not = needs_own_colors,
       .needs_prices = true},
      {.name = best_method,
       .options = {"omega"},
       .run = merge_and_fit,
       .why_not = needs_own_colors,
       .needs_prices = true},
      {.name = line_method,
       .options = {},
       .run = take_out_lines,
       .why_not = needs_lines,
       .keeps_rectangle = true},
      {.name = plain_method,
       .options = {},
       .run = make_plain,
       .why_not = needs_plain_grid,
       .keeps_rectangle = true,
       .count = Count::handles,
       .meets_targets = true},
      {.name = "manual",
       .options = {"edges"},
       .run = by_name,
       .why_not = needs_own_colors,
       .merges_named_edges = true},
  };
  return methods;
}

const Method& method_named(std::string_view wanted) {
  std::string known;
  for (const Method& method : all_methods()) {
    if (wanted == method.name || (wanted == simplest && method.name == best_method)) return method;
    known.append(known.empty() ? "" : ", ").append(method.name);
  }
  throw std::invalid_argument("the method '" + std::string(wanted) +
                              "' is not known; there are: " + known + ".");
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

std::vector<std::string> methods_with(const std::string& option) {
  std::vector<std::string> names;
  for (const Method& method : all_methods())
    if (std::ranges::find(method.options, option) != method.options.end())
      names.push_back(method.name);
  return names;
}

}  // namespace gradmesh
