#pragma once

#include <cstddef>
#include <iterator>
#include <vector>

namespace gradmesh {

/// The indices of the records that are alive, in rising order: for (const Face f : mesh.faces()).
template <class Element, class Record>
class AliveRange {
 public:
  explicit AliveRange(const std::vector<Record>& records) : records_(&records) {}

  class iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = Element;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = Element;

    iterator() = default;
    iterator(const std::vector<Record>& records, std::size_t at) : records_(&records), at_(at) {
      skip();
    }

    Element operator*() const { return Element{int(at_)}; }
    iterator& operator++() {
      ++at_;
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
    void skip() {
      while (at_ < records_->size() && !(*records_)[at_].alive) ++at_;
    }

    const std::vector<Record>* records_ = nullptr;
    std::size_t at_ = 0;
  };

  iterator begin() const { return {*records_, 0}; }
  iterator end() const { return {*records_, records_->size()}; }

 private:
  const std::vector<Record>* records_;
};

}  // namespace gradmesh
