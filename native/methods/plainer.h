#pragma once

#include <functional>
#include <vector>

#include "fit/plainness.h"
#include "trial/fit_trial.h"

namespace gradmesh {

/// Makes a mesh plainer step by step: curves become straight, and patches Coons patches. What costs
/// least for each handle comes first, many steps at once while they are cheap, and what lies near
/// is fitted after each.
class Plainer {
 public:
  /// `keeps` says whether a mesh keeps to the bounds as it will be written. `trial` must keep plain
  /// what is plain.
  Plainer(FitTrial& trial, const FitTarget& target, std::function<bool(const Mesh&)> keeps,
          std::function<bool()> should_stop)
      : trial_(trial),
        target_(target),
        keeps_(std::move(keeps)),
        should_stop_(std::move(should_stop)),
        at_first_(trial.mesh()) {}

  /// Makes steps whose error, once fitted, is at most `limit`. Returns false if there are none
  /// left.
  bool make_step(double limit);

 private:
  struct Way {
    PlainerStep step;
    /// How many handles it saves.
    int saves;
  };

  std::vector<Way> ways() const;
  /// True if a curve may become straight: neither may an outline go elsewhere nor a line that was
  /// smooth get a corner that is seen.
  bool may_be_straight(Halfedge curve, const Plainness& now) const;
  bool makes_corner(Halfedge curve, int end, const Plainness& now) const;
  std::vector<PlainerStep> cheapest_first() const;

  /// Of the steps that are possible, one in so many is made at once, and where these are too many,
  /// one in so many of them.
  static constexpr std::size_t share_at_once = 4;
  /// After so many single steps that were too much, one after the other, no more are tried.
  static constexpr int most_in_a_row = 12;

  FitTrial& trial_;
  const FitTarget& target_;
  const std::function<bool(const Mesh&)> keeps_;
  const std::function<bool()> should_stop_;
  const Plainness at_first_;
  /// The most steps that are made at once.
  std::size_t most_ = std::size_t(-1);
};

}  // namespace gradmesh
