#pragma once

#include <cstddef>
#include <iterator>
#include <vector>

#include "mesh/elements.h"

namespace gradmesh {

/// Iterator over elements of a mesh. `Order` has the element after another one, as the records are
/// when the iteration gets there.
template <class Element, class Order>
class ElementIterator {
 public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = Element;
  using difference_type = std::ptrdiff_t;
  using pointer = void;
  using reference = Element;

  ElementIterator() = default;
  ElementIterator(Order order, Element at) : order_(order), at_(at) {}

  Element operator*() const { return at_; }
  ElementIterator& operator++() {
    at_ = order_.after(at_);
    return *this;
  }
  ElementIterator operator++(int) {
    const ElementIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const ElementIterator& other) const { return at_ == other.at_; }

 private:
  Order order_;
  Element at_;
};

/// The indices of the records that are alive, in rising order: for (const Face f : mesh.faces()).
template <class Record>
class AliveRange {
 public:
  explicit AliveRange(const std::vector<Record>& records) : order_{&records} {}

  auto begin() const { return ElementIterator(order_, order_.after({-1})); }
  auto end() const { return ElementIterator(order_, Index<Record>{int(order_.records->size())}); }

 private:
  struct Order {
    const std::vector<Record>* records = nullptr;

    Index<Record> after(Index<Record> element) const {
      const int size = int(records->size());
      do ++element.value;
      while (element.value < size && !(*records)[std::size_t(element.value)].alive);
      return element;
    }
  };

  Order order_;
};

/// The children of one half-edge in their order. Example: for (const Halfedge stem :
/// mesh.stems(side)).
class SiblingRange {
 public:
  enum Kind {
    children,
    bars,
    stems,
    /// The first half-edge alone, of whatever kind.
    alone,
  };

  SiblingRange(const std::vector<HalfedgeRecord>& records, Halfedge first, Kind kind)
      : order_{&records, kind}, first_(first) {}

  auto begin() const { return ElementIterator(order_, order_.from(first_)); }
  auto end() const { return ElementIterator(order_, Halfedge{}); }
  std::vector<Halfedge> list() const { return {begin(), end()}; }

 private:
  struct Order {
    const std::vector<HalfedgeRecord>* records = nullptr;
    Kind kind = children;

    const HalfedgeRecord& record(Halfedge h) const { return (*records)[std::size_t(h.value)]; }
    /// Returns the first half-edge of this kind from h on; h itself where any kind counts.
    Halfedge from(Halfedge h) const {
      const auto is_bar = [&] { return record(h).interval.first < record(h).interval.second; };
      if (kind == bars || kind == stems)
        while (h.valid() && is_bar() != (kind == bars)) h = record(h).next_sibling;
      return h;
    }
    Halfedge after(Halfedge h) const {
      return kind == alone ? Halfedge{} : from(record(h).next_sibling);
    }
  };

  Order order_;
  Halfedge first_;
};

}  // namespace gradmesh
