#include "session/curve_search.h"

#include <exception>

#include "base/error.h"

namespace gradmesh {

void CurveSearch::request(MeshKind kind) {
  {
    const std::lock_guard lock(mutex_);
    if (!curves_.try_emplace(kind).second) return;
  }
  worker_.add([this, kind](const std::atomic<bool>& must_end) { search(kind, must_end); });
}

std::optional<CurveSearch::Found> CurveSearch::found(MeshKind kind) const {
  const std::lock_guard lock(mutex_);
  const auto place = curves_.find(kind);
  if (place == curves_.end()) return std::nullopt;
  return place->second;
}

void CurveSearch::search(MeshKind kind, const std::atomic<bool>& must_end) {
  const std::optional<Message> failure = failure_of([&] {
    StopWatch watch(0, [&](const Progress&) { return !must_end; });
    find_curve(problem_, kind, watch, [&](const StateCurve& curve) {
      const std::lock_guard lock(mutex_);
      curves_[kind].curve = curve;
    });
  });
  const std::lock_guard lock(mutex_);
  curves_[kind].is_complete = true;
  curves_[kind].failure = failure;
}

std::optional<Message> failure_of(const std::function<void()>& search) {
  try {
    search();
  } catch (const InputError& error) {
    return error.message();
  } catch (const std::exception& error) {
    return Message("it could not be found out ({0}).", error.what());
  }
  return std::nullopt;
}

}  // namespace gradmesh
