#include "simplify/tries.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "form/handles.h"
#include "mesh/rectangle.h"
#include "methods/merging/edges.h"

namespace gradmesh {
namespace {

/// A method that is tried after others.
struct Try {
  const char* method;
  /// Returns true if the best result so far leaves something to be wished that the method may have.
  bool (*is_wanted)(const SimplifyResult& best, const Problem& problem, StopWatch& watch);
  /// Returns true if what this method has found is better.
  bool (*is_better)(const SimplifyResult& found, const SimplifyResult& best, Count count);
};

bool leaves_much(const SimplifyResult& best, const Problem&, StopWatch&) {
  return !best.changed || 2 * best.handles_after > best.handles_before;
}

bool leaves_less(const SimplifyResult& found, const SimplifyResult& best, Count) {
  return found.effort() < best.effort();
}

/// A group in the place of an object has to be worth it.
bool is_much_less(double effort, const SimplifyResult& best) {
  return 3 * effort < 2 * best.effort();
}

bool leaves_much_less(const SimplifyResult& found, const SimplifyResult& best, Count) {
  return is_much_less(found.effort(), best);
}

/// Returns about how few patches merging can leave, by the prices of single edges: a region costs
/// about as much as the edges inside it, or more. Fits lower prices, so more than epsilon may be
/// spent.
int fewest_patches(const Problem& problem, StopWatch& watch) {
  constexpr double share_of_epsilon = 2;
  const ThreadLimit limit = problem.thread_limit();
  std::vector<double> prices;
  for (const EdgePrice& edge : price_edges(problem.pricing_trial()->trial, problem.prices(), watch))
    prices.push_back(std::max(0.0, edge.error));
  std::ranges::sort(prices);
  double left = share_of_epsilon * problem.bounds.epsilon;
  int patches = problem.mesh().face_count();
  for (const double price : prices) {
    left -= price;
    if (left < 0 || patches == 1) break;
    --patches;
  }
  return patches;
}

/// Returns true if the best result leaves much, and blocks may leave much less. They have about as
/// many handles for each patch as one mesh gradient, or more, since blocks share no points; and no
/// fewer than the points of a square of so many patches. Of very many patches they are hundreds of
/// objects, which nobody edits, and take minutes.
bool blocks_may_leave_less(const SimplifyResult& best, const Problem& problem, StopWatch& watch) {
  constexpr int most_patches = 500;
  const int patches = problem.mesh().face_count();
  if (!leaves_much(best, problem, watch) || patches > most_patches) return false;
  const auto may_win = [&](int left) {
    const double points = std::pow(std::sqrt(double(left)) + 1, 2);
    const double handles = std::max(points, double(best.handles_after) * left / patches);
    return is_much_less(handles_of_an_object + handles, best);
  };
  return may_win(1) && may_win(fewest_patches(problem, watch));
}

bool is_nothing_or_masked(const SimplifyResult& best, const Problem&, StopWatch&) {
  return !best.changed || best.form.masks_opacity();
}

bool leaves_no_more(const SimplifyResult& found, const SimplifyResult& best, Count count) {
  return count == Count::handles ? found.effort() <= best.effort()
                                 : found.patches_after <= best.patches_after;
}

/// What is tried after `plain` where whatever is simplest is asked for.
constexpr Try after_plain[] = {{line_method, leaves_much, leaves_less},
                               {best_method, blocks_may_leave_less, leaves_much_less}};
/// What is tried of one mesh gradient after a method that makes a group of blocks of it.
constexpr Try after_merging[] = {{line_method, is_nothing_or_masked, leaves_no_more}};

/// Returns the method with which the list of a problem begins.
const Method& first_method(const std::string& asked, const Problem& problem) {
  const Method& plain = method_named(plain_method);
  const bool can_be_plain =
      problem.gradient_rules && problem.count == Count::handles && suits(plain, problem.mesh());
  if (asked == simplest && can_be_plain) return plain;
  const Method& wanted = method_named(asked);
  const bool is_meant = asked == plain_method || wanted.merges_named_edges;
  return problem.mesh().is_smooth() && !is_meant ? method_named(line_method) : wanted;
}

std::span<const Try> tries_after(const Method& method, const std::string& asked,
                                 const Problem& problem) {
  if (problem.bounds.target || !problem.gradient_rules) return {};
  if (method.name == plain_method && asked == simplest) return after_plain;
  const bool is_grid = find_grid(problem.mesh()).has_value();
  if (method.keeps_rectangle || method.merges_named_edges || !is_grid) return {};
  return after_merging;
}

bool is_over(Stopped stopped) {
  return stopped == Stopped::budget || stopped == Stopped::cancelled;
}

}  // namespace

SimplifyResult simplify_as_asked(const Problem& problem, const std::string& asked,
                                 StopWatch& watch) {
  const Method& first = first_method(asked, problem);
  SimplifyResult best = simplify(problem, first, watch);
  if (is_over(best.stopped)) return best;
  for (const Try& next : tries_after(first, asked, problem)) {
    const Method& method = method_named(next.method);
    if (!suits(method, problem.mesh()) || !next.is_wanted(best, problem, watch)) continue;
    if (watch.is_over()) {
      if (!best.changed) best.stopped = Stopped::budget;
      break;
    }
    SimplifyResult found = simplify(problem, method, watch);
    // What is left untried might have been simpler.
    const Stopped stopped = found.stopped;
    if (is_over(stopped) && !best.changed) best.stopped = stopped;
    if (found.changed && next.is_better(found, best, problem.count)) {
      best = std::move(found);
    } else {
      best.evaluations = found.evaluations;
      best.seconds = found.seconds;
    }
    if (is_over(stopped)) break;
  }
  return best;
}

}  // namespace gradmesh
