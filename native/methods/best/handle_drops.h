#pragma once

#include <functional>
#include <vector>

#include "fit/plainness.h"
#include "trial/fit_trial.h"

namespace gradmesh {

/// Drops handles of a mesh step by step: curves become straight, and patches Coons patches. What
/// costs least for each handle comes first, many at once while they are cheap, and what lies near
/// is fitted after each.
class HandleDrops {
 public:
  /// `keeps` says whether a mesh keeps to the bounds as it will be written. `trial` must keep plain
  /// what is plain.
  HandleDrops(FitTrial& trial, std::function<bool(const Mesh&)> keeps,
              std::function<bool()> should_stop)
      : trial_(trial),
        keeps_(std::move(keeps)),
        should_stop_(std::move(should_stop)),
        at_first_(trial.mesh()) {}

  /// Drops handles so that the error, once fitted, is at most `limit`. Returns false if there are
  /// none left that can be dropped.
  bool drop_some(double limit);

 private:
  struct Way {
    HandleDrop step;
    /// How many handles it saves.
    int saves;
  };

  std::vector<Way> ways() const;
  /// True if a curve may become straight: neither may an outline go elsewhere nor a line that was
  /// smooth get a corner that is seen.
  bool is_beside_fixed(Halfedge curve) const;
  bool may_be_straight(Halfedge curve, const Plainness& now) const;
  bool makes_corner(Halfedge curve, int end, const Plainness& now) const;
  std::vector<HandleDrop> cheapest_first() const;

  /// After so many single steps that were too much, one after the other, no more are tried.
  static constexpr int most_in_a_row = 12;

  FitTrial& trial_;
  const std::function<bool(const Mesh&)> keeps_;
  const std::function<bool()> should_stop_;
  const Plainness at_first_;
  /// The most steps that are made at once.
  std::size_t most_ = std::size_t(-1);
};

}  // namespace gradmesh
