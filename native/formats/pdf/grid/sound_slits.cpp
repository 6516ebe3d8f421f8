#include "formats/pdf/grid/sound_slits.h"

#include <algorithm>
#include <map>

namespace gradmesh {
namespace {

class SlitChoice {
 public:
  SlitChoice(const LooseSides& sides, std::vector<bool> slits)
      : sides_(sides), is_kept_(std::move(slits)), slit_of_(std::size_t(sides.count()), -1) {
    for (std::size_t n = 0; n < is_kept_.size(); ++n)
      for (const auto* chain : {&slit(n).here, &slit(n).there})
        for (const int side : *chain) slit_of_[std::size_t(side)] = int(n);
  }

  std::vector<bool> run() {
    // What is left out takes others with it. Patches of any drawing do so in a few rounds.
    constexpr int most_rounds = 32;
    drop_second_junctions();
    for (int round = 0; round < most_rounds; ++round)
      if (!drop_without_stems() && !drop_of_cycle()) return is_kept_;
    for (std::size_t n = 0; n < is_kept_.size(); ++n)
      if (is_divided(n)) is_kept_[n] = false;
    return is_kept_;
  }

 private:
  const Slit& slit(std::size_t n) const { return sides_.slits()[n]; }
  bool is_divided(std::size_t n) const {
    return slit(n).here.size() > 1 || slit(n).there.size() > 1;
  }

  void drop_second_junctions() {
    for (std::size_t n = 0; n < is_kept_.size(); ++n) {
      if (!is_kept_[n]) continue;
      const std::vector<int> points = junctions(n);
      for (const int point : points)
        if (!owner_of_.emplace(point, int(n)).second) is_kept_[n] = false;
      if (is_kept_[n]) continue;
      for (const int point : points)
        if (const auto owner = owner_of_.find(point); owner->second == int(n))
          owner_of_.erase(owner);
    }
  }

  std::vector<int> junctions(std::size_t n) const {
    std::vector<int> points;
    for (const auto* chain : {&slit(n).here, &slit(n).there})
      for (std::size_t k = 1; k < chain->size(); ++k) points.push_back(sides_.from((*chain)[k]));
    return points;
  }

  bool drop_without_stems() {
    bool is_any = false;
    for (std::size_t n = 0; n < is_kept_.size(); ++n) {
      if (!is_kept_[n] || has_stems(n)) continue;
      is_kept_[n] = false;
      is_any = true;
    }
    return is_any;
  }

  /// Returns whether there is one curve from each T-junction.
  bool has_stems(std::size_t n) const {
    for (const auto* chain : {&slit(n).here, &slit(n).there})
      for (std::size_t k = 1; k < chain->size(); ++k)
        if (!is_stem(LooseSides::next((*chain)[k - 1]), LooseSides::previous((*chain)[k])))
          return false;
    return true;
  }

  /// Returns whether sides are the first and the last of two chains along one curve.
  bool is_stem(int away, int back) const {
    if (sides_.twin(away) >= 0) return sides_.twin(away) == back;
    const int n = slit_of_[std::size_t(away)];
    if (n < 0 || !is_kept_[std::size_t(n)]) return false;
    const auto &here = slit(std::size_t(n)).here, &there = slit(std::size_t(n)).there;
    return (here.front() == away && there.back() == back) ||
           (there.front() == away && here.back() == back);
  }

  /// Drops one of the slits that depend on each other, if there are such.
  bool drop_of_cycle() {
    enum class Visit { none, on_path, done };
    std::vector<Visit> visits(is_kept_.size(), Visit::none);
    for (std::size_t start = 0; start < is_kept_.size(); ++start) {
      if (visits[start] != Visit::none) continue;
      std::vector<std::size_t> path{start};
      while (!path.empty()) {
        const std::size_t n = path.back();
        visits[n] = Visit::on_path;
        int next = -1;
        for (const int support : supports_of(n)) {
          const Visit visit = visits[std::size_t(support)];
          if (visit == Visit::on_path) {
            is_kept_[n] = false;
            return true;
          }
          if (visit == Visit::none) next = support;
        }
        if (next >= 0) {
          path.push_back(std::size_t(next));
        } else {
          visits[n] = Visit::done;
          path.pop_back();
        }
      }
    }
    return false;
  }

  /// Returns the slits on which the ends of one are T-junctions.
  std::vector<int> supports_of(std::size_t n) const {
    std::vector<int> supports;
    if (!is_kept_[n]) return supports;
    for (const int end : {sides_.from(slit(n).here.front()), sides_.to(slit(n).here.back())})
      if (const auto owner = owner_of_.find(end); owner != owner_of_.end())
        if (is_kept_[std::size_t(owner->second)]) supports.push_back(owner->second);
    return supports;
  }

  const LooseSides& sides_;
  std::vector<bool> is_kept_;
  /// The slit of which a side is a part, and that of which a point is a T-junction; -1 for none.
  std::vector<int> slit_of_;
  std::map<int, int> owner_of_;
};

}  // namespace

std::vector<bool> sound_slits(const LooseSides& sides, std::vector<bool> slits) {
  return SlitChoice(sides, std::move(slits)).run();
}

}  // namespace gradmesh
