#include "fit/elimination.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace gradmesh {
namespace {

using Lists = std::vector<std::vector<int>>;

/// Columns that are in the same parts, and so are eliminated together: those of one point.
struct Nodes {
  Lists columns;
  /// The nodes of each part, each once.
  Lists of_parts;

  std::size_t count() const { return columns.size(); }
  int size(int node) const {
    const std::vector<int>& of_node = columns[std::size_t(node)];
    return int(of_node.size());
  }
};

Nodes nodes_of(const Lists& parts, std::size_t columns) {
  // If two columns had the same number by chance their node would be larger than it has to be.
  std::vector<std::uint64_t> in_parts(columns, 0);
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const int column : parts[p]) {
      std::uint64_t& number = in_parts[std::size_t(column)];
      number = (number ^ (p + 1)) * 0x9e3779b97f4a7c15U;
      number ^= number >> 29;
    }
  Nodes nodes;
  std::vector<int> node_of(columns);
  std::map<std::uint64_t, int> known;
  for (std::size_t i = 0; i < columns; ++i) {
    const int next = int(nodes.columns.size());
    // A column that is in no part is a node alone.
    const int node = in_parts[i] == 0 ? next : known.try_emplace(in_parts[i], next).first->second;
    if (node == next) nodes.columns.emplace_back();
    nodes.columns[std::size_t(node)].push_back(int(i));
    node_of[i] = node;
  }
  for (const std::vector<int>& part : parts) {
    std::vector<int> of_part;
    for (const int column : part) of_part.push_back(node_of[std::size_t(column)]);
    std::ranges::sort(of_part);
    of_part.erase(std::unique(of_part.begin(), of_part.end()), of_part.end());
    nodes.of_parts.push_back(std::move(of_part));
  }
  return nodes;
}

/// Returns the nodes that are in a part with each node, without itself.
Lists neighbours_of(const Nodes& nodes) {
  Lists parts_of(nodes.count()), neighbours(nodes.count());
  for (std::size_t i = 0; i < nodes.of_parts.size(); ++i)
    for (const int node : nodes.of_parts[i]) parts_of[std::size_t(node)].push_back(int(i));
  std::vector<int> seen_by(nodes.count(), -1);
  for (std::size_t n = 0; n < nodes.count(); ++n) {
    seen_by[n] = int(n);
    for (const int p : parts_of[n])
      for (const int other : nodes.of_parts[std::size_t(p)])
        if (std::exchange(seen_by[std::size_t(other)], int(n)) != int(n))
          neighbours[n].push_back(other);
  }
  return neighbours;
}

/// Returns the nodes in an order in which little is filled in.
std::vector<int> elimination_order(const Lists& neighbours) {
  const auto count = Eigen::Index(neighbours.size());
  std::vector<Eigen::Triplet<float>> entries;
  for (std::size_t n = 0; n < neighbours.size(); ++n)
    for (const int other : neighbours[n]) entries.emplace_back(other, int(n), 1.0F);
  Eigen::SparseMatrix<float> pattern(count, count);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(pattern, order);
  return {order.indices().data(), order.indices().data() + count};
}

/// What follows from the order; nodes are named by their places in it.
class Tree {
 public:
  Tree(const Nodes& nodes, const Lists& neighbours, std::vector<int> order)
      : nodes_(nodes),
        order_(std::move(order)),
        place_(order_.size()),
        later_(order_.size()),
        children_(order_.size()) {
    for (std::size_t k = 0; k < order_.size(); ++k) place_[std::size_t(order_[k])] = int(k);
    find_dependent(neighbours);
    gather_members();
  }

  /// Returns the fronts, without parts.
  std::vector<Front> fronts() {
    std::vector<Front> fronts;
    front_of_.resize(order_.size());
    for (std::size_t k = 0; k < order_.size(); ++k) {
      if (members_[k].empty()) continue;
      Front front;
      for (const int place : members_[k]) {
        front_of_[std::size_t(place)] = int(fronts.size());
        append_columns(place, front.columns);
      }
      front.eliminated = int(front.columns.size());
      for (const int place : later_[k]) append_columns(place, front.columns);
      fronts.push_back(std::move(front));
    }
    for (std::size_t k = 0; k < order_.size(); ++k)
      if (!members_[k].empty() && !later_[k].empty()) {
        const int own = front_of_[k], parent = front_of_[std::size_t(later_[k].front())];
        fronts[std::size_t(own)].parent = parent;
        fronts[std::size_t(parent)].children.push_back(own);
      }
    return fronts;
  }

  /// Returns the front, as numbered by fronts(), of the first of these nodes; -1 for none.
  int front_of_first(const std::vector<int>& nodes) const {
    int first = int(order_.size());
    for (const int node : nodes) first = std::min(first, place_[std::size_t(node)]);
    return nodes.empty() ? -1 : front_of_[std::size_t(first)];
  }

 private:
  /// Finds for each node those eliminated later that depend on it; the first of them is its parent.
  void find_dependent(const Lists& neighbours) {
    std::vector<int> seen_by(order_.size(), -1);
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const auto add = [&](int place) {
        if (place > int(k) && std::exchange(seen_by[std::size_t(place)], int(k)) != int(k))
          later_[k].push_back(place);
      };
      for (const int node : neighbours[std::size_t(order_[k])]) add(place_[std::size_t(node)]);
      for (const int child : children_[k])
        for (const int place : later_[std::size_t(child)]) add(place);
      std::ranges::sort(later_[k]);
      if (!later_[k].empty()) children_[std::size_t(later_[k].front())].push_back(int(k));
    }
  }

  /// Takes nodes into the front of their parent as long as few entries there are zero.
  void gather_members() {
    constexpr double share = 0.1;
    constexpr int few = 30;
    members_.resize(order_.size());
    std::vector<int> eliminated(order_.size()), later(order_.size()), zeros(order_.size(), 0);
    for (std::size_t k = 0; k < order_.size(); ++k) {
      members_[k] = {int(k)};
      eliminated[k] = nodes_.size(order_[k]);
      for (const int place : later_[k]) later[k] += nodes_.size(order_[std::size_t(place)]);
      for (const int child : children_[k]) {
        const auto c = std::size_t(child);
        const int both = eliminated[c] + eliminated[k];
        const int zero =
            zeros[c] + zeros[k] + eliminated[c] * (eliminated[k] + later[k] - later[c]);
        if (zero > few && zero > share * both * (both + later[k])) continue;
        zeros[k] = zero;
        eliminated[k] = both;
        members_[k].insert(members_[k].end(), members_[c].begin(), members_[c].end());
        members_[c].clear();
      }
      std::ranges::sort(members_[k]);
    }
  }

  void append_columns(int place, std::vector<int>& columns) const {
    const std::vector<int>& more = nodes_.columns[std::size_t(order_[std::size_t(place)])];
    columns.insert(columns.end(), more.begin(), more.end());
  }

  const Nodes& nodes_;
  const std::vector<int> order_;
  /// By node.
  std::vector<int> place_;
  /// By place: what depends on it, of which it is the first, and what is eliminated with it;
  /// nothing if it is eliminated with another.
  Lists later_, children_, members_;
  std::vector<int> front_of_;
};

}  // namespace

Elimination::Elimination(const Lists& parts, std::size_t columns) : places(parts.size()) {
  const Nodes nodes = nodes_of(parts, columns);
  const Lists neighbours = neighbours_of(nodes);
  Tree tree(nodes, neighbours, elimination_order(neighbours));
  fronts = tree.fronts();
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (const int front = tree.front_of_first(nodes.of_parts[i]); front >= 0)
      fronts[std::size_t(front)].parts.push_back(int(i));
  std::vector<int> place(columns);
  for (Front& front : fronts) {
    for (std::size_t i = 0; i < front.columns.size(); ++i)
      place[std::size_t(front.columns[i])] = int(i);
    for (const int p : front.parts)
      for (const int column : parts[std::size_t(p)])
        places[std::size_t(p)].push_back(place[std::size_t(column)]);
    for (const int c : front.children) {
      Front& child = fronts[std::size_t(c)];
      for (std::size_t i = std::size_t(child.eliminated); i < child.columns.size(); ++i)
        child.in_parent.push_back(place[std::size_t(child.columns[i])]);
    }
  }
}

}  // namespace gradmesh
