#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace gradmesh {

/// A search in the background of which only the latest counts. Earlier ones are told to end, and
/// nobody waits until they have. `Search` has end() and is_busy().
template <class Search>
class LatestSearch {
 public:
  Search* get() const { return latest_.get(); }
  /// Begins another search, or none.
  void replace(std::unique_ptr<Search> next) {
    std::erase_if(ending_, [](const auto& each) { return !each->is_busy(); });
    end();
    if (latest_) ending_.push_back(std::move(latest_));
    latest_ = std::move(next);
  }
  /// Tells the latest to end.
  void end() {
    if (latest_) latest_->end();
  }

 private:
  std::unique_ptr<Search> latest_;
  std::vector<std::unique_ptr<Search>> ending_;
};

}  // namespace gradmesh
