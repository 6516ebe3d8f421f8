#pragma once

#include <cstddef>
#include <iterator>
#include <vector>

#include "mesh/elements.h"

namespace gradmesh {

/// The children of one half-edge in their order, as they are when the iteration reaches them.
/// Example: for (const Halfedge stem : mesh.stems(side)).
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
      : records_(&records), first_(first), kind_(kind) {}

  class iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = Halfedge;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = Halfedge;

    iterator() = default;
    iterator(const std::vector<HalfedgeRecord>& records, Halfedge at, Kind kind)
        : records_(&records), at_(at), kind_(kind) {
      skip();
    }

    Halfedge operator*() const { return at_; }
    iterator& operator++() {
      at_ = kind_ == alone ? Halfedge{} : record().next_sibling;
      skip();
      return *this;
    }
    iterator operator++(int) {
      const iterator before = *this;
      ++*this;
      return before;
    }
    bool operator==(const iterator& other) const { return at_ == other.at_; }

   private:
    const HalfedgeRecord& record() const { return (*records_)[std::size_t(at_.value)]; }
    void skip() {
      if (kind_ != bars && kind_ != stems) return;
      while (at_.valid() && (record().interval.first < record().interval.second) != (kind_ == bars))
        at_ = record().next_sibling;
    }

    const std::vector<HalfedgeRecord>* records_ = nullptr;
    Halfedge at_;
    Kind kind_ = children;
  };

  iterator begin() const { return {*records_, first_, kind_}; }
  iterator end() const { return {*records_, Halfedge{}, kind_}; }
  std::vector<Halfedge> list() const { return {begin(), end()}; }

 private:
  const std::vector<HalfedgeRecord>* records_;
  Halfedge first_;
  Kind kind_;
};

}  // namespace gradmesh
