#include "methods/merging/packing.h"

#include <glpk.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace gradmesh {
namespace {

/// Share of gamma that is left unused, and by which a set must be better to count: more than the
/// solver's tolerances.
constexpr double slack = 1e-6;

/// Most pivots of the relaxation, which takes a few hundred for the meshes of the paper. If it
/// takes more, its tree would take too long as well.
constexpr int most_pivots = 20000;

struct Totals {
  int saved = 0;
  double price = 0;

  bool is_better_than(const Totals& other) const {
    return std::pair(-saved, price) < std::pair(-other.saved, other.price);
  }
};

Totals totals_of(const std::vector<PackingItem>& items, const Packing& packing) {
  Totals totals;
  for (const int i : packing) {
    totals.saved += items[i].saved;
    totals.price += items[i].price;
  }
  return totals;
}

/// Returns the items that can be in a set at all, whatever items with negative prices are beside
/// them.
Packing affordable(const std::vector<PackingItem>& items, double gamma) {
  double most = gamma;
  for (const PackingItem& item : items) most -= std::min(item.price, 0.0);
  Packing found;
  for (int i = 0; i < int(items.size()); ++i)
    if (items[i].price <= most) found.push_back(i);
  return found;
}

/// The memory that GLPK holds for a thread, freed at the end.
struct SolverMemory {
  SolverMemory() { glp_term_out(GLP_OFF); }
  ~SolverMemory() { glp_free_env(); }
};

/// The integer program: a column for each affordable item, and rows for the two sums and the
/// patches.
class Program {
 public:
  Program(const std::vector<PackingItem>& items, double gamma, int most_nodes)
      : columns_(affordable(items, gamma)),
        // The solver's tolerances are for numbers of about 1.
        unit_(gamma > 0 ? gamma : 1),
        budget_(gamma / unit_ * (1 - slack)),
        most_nodes_(most_nodes),
        program_(glp_create_prob(), &glp_delete_prob) {
    if (columns_.empty()) return;
    glp_add_cols(program_.get(), int(columns_.size()));
    std::vector<int> all;
    for (const int i : columns_) {
      saved_.push_back(items[i].saved);
      prices_.push_back(items[i].price / unit_);
      all.push_back(int(saved_.size()));
      glp_set_col_kind(program_.get(), all.back(), GLP_BV);
    }
    glp_add_rows(program_.get(), 2);
    set_row(price_row, all, prices_);
    set_row(saved_row, all, saved_);
    add_patches(items);
  }

  /// Returns the set that saves the most patches, if that is more than `saved`. Returns nothing
  /// also if none was found within the limits of the search.
  std::optional<Packing> with_most_saved(int saved) {
    glp_set_obj_dir(program_.get(), GLP_MAX);
    return best_for(saved_, budget_, saved + 1);
  }

  /// Returns the set with the smallest sum of prices of those that save at least as many patches as
  /// `than`, if its sum is smaller.
  std::optional<Packing> with_least_price(const Totals& than) {
    glp_set_obj_dir(program_.get(), GLP_MIN);
    return best_for(prices_, std::min(than.price / unit_ - slack, budget_), than.saved);
  }

  /// Returns true if every search so far came to its end.
  bool proven() const { return proven_; }

 private:
  enum : int { price_row = 1, saved_row = 2 };

  struct NodeCount {
    int most, entered = 0;
  };

  /// Sets the coefficients of a row. `columns` are counted as in GLPK, from 1.
  void set_row(int row, std::vector<int> columns, std::vector<double> coefficients) {
    const int count = int(columns.size());
    columns.insert(columns.begin(), 0);
    coefficients.insert(coefficients.begin(), 0);
    glp_set_mat_row(program_.get(), row, count, columns.data(), coefficients.data());
  }

  /// Adds a row for each patch that several items take, as at most one item may take it: a clique
  /// of the paper's conflict graph (6.3).
  void add_patches(const std::vector<PackingItem>& items) {
    for (int f = 0; f < int(items.front().patches.face_slots()); ++f) {
      std::vector<int> takers;
      for (std::size_t c = 0; c < columns_.size(); ++c)
        if (items[columns_[c]].patches.contains(Face{f})) takers.push_back(int(c) + 1);
      if (takers.size() < 2) continue;
      const int row = glp_add_rows(program_.get(), 1);
      glp_set_row_bnds(program_.get(), row, GLP_UP, 0, 1);
      set_row(row, takers, std::vector<double>(takers.size(), 1));
    }
  }

  std::optional<Packing> best_for(const std::vector<double>& objective, double most_price,
                                  double least_saved) {
    if (columns_.empty()) return {};
    glp_prob* p = program_.get();
    for (std::size_t c = 0; c < columns_.size(); ++c) glp_set_obj_coef(p, int(c) + 1, objective[c]);
    glp_set_row_bnds(p, price_row, GLP_UP, 0, most_price);
    glp_set_row_bnds(p, saved_row, GLP_LO, least_saved, 0);
    // Always from the same basis: the result depends on nothing but the program.
    glp_std_basis(p);
    glp_smcp options;
    glp_init_smcp(&options);
    options.it_lim = most_pivots;
    if (glp_simplex(p, &options) != 0) {
      proven_ = false;
      return {};
    }
    if (glp_get_status(p) != GLP_OPT) return {};
    if (!search()) proven_ = false;
    if (glp_mip_status(p) != GLP_OPT && glp_mip_status(p) != GLP_FEAS) return {};
    Packing chosen;
    for (std::size_t c = 0; c < columns_.size(); ++c)
      if (glp_mip_col_val(p, int(c) + 1) > 0.5) chosen.push_back(columns_[c]);
    return chosen;
  }

  /// Branches from the solved relaxation. Returns true if the search came to its end.
  bool search() {
    NodeCount nodes{most_nodes_};
    glp_iocp options;
    glp_init_iocp(&options);
    options.cb_info = &nodes;
    options.cb_func = [](glp_tree* tree, void* info) {
      NodeCount& count = *static_cast<NodeCount*>(info);
      if (glp_ios_reason(tree) == GLP_ISELECT && ++count.entered > count.most)
        glp_ios_terminate(tree);
    };
    return glp_intopt(program_.get(), &options) == 0;
  }

  /// The item of each column.
  const Packing columns_;
  /// The price that counts as 1 in the program.
  const double unit_;
  const double budget_;
  const int most_nodes_;
  SolverMemory memory_;
  std::unique_ptr<glp_prob, decltype(&glp_delete_prob)> program_;
  std::vector<double> saved_, prices_;
  bool proven_ = true;
};

}  // namespace

BestPacking best_packing(const std::vector<PackingItem>& items, double gamma, const Packing& start,
                         int most_nodes) {
  Packing best = start;
  std::ranges::sort(best);
  Totals totals = totals_of(items, best);
  const auto take_if_better = [&](const std::optional<Packing>& found) {
    if (!found) return;
    const Totals other = totals_of(items, *found);
    if (other.price > gamma || !other.is_better_than(totals)) return;
    best = *found;
    totals = other;
  };
  Program program(items, gamma, most_nodes);
  take_if_better(program.with_most_saved(totals.saved));
  take_if_better(program.with_least_price(totals));
  return {best, program.proven()};
}

}  // namespace gradmesh
