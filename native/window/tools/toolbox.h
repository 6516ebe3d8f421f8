#pragma once

#include <memory>
#include <vector>

#include "window/tools/tool.h"

namespace gradmesh {

/// All tools, of which one is in the hand.
class Toolbox {
 public:
  Toolbox();

  const std::vector<std::unique_ptr<Tool>>& tools() const { return tools_; }
  Tool& in_hand() { return *tools_[chosen_]; }
  const Tool& in_hand() const { return *tools_[chosen_]; }
  /// Takes a tool; what the one before has begun is forgotten.
  void take(std::size_t which, Eye& eye);
  /// Takes the tool of a key. Returns false if there is none.
  bool take(const std::string& key, Eye& eye);
  /// Takes the tool that is in the hand at first. Returns false if it is.
  bool take_first(Eye& eye);

 private:
  std::vector<std::unique_ptr<Tool>> tools_;
  /// The line that a click takes out is what a person looks for first.
  static constexpr std::size_t first = 1;
  std::size_t chosen_ = first;
};

}  // namespace gradmesh
