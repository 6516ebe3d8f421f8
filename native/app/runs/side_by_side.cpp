#include "app/runs/side_by_side.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"

namespace gradmesh {

void SideBySide::change(const std::function<void()>& what) {
  {
    const std::lock_guard lock(mutex_);
    what();
  }
  caller_.there_is_news();
}

ProgressCallback SideBySide::progress_of(std::size_t mesh) {
  return [this, mesh](const Progress& now) {
    change([&] {
      known_[mesh] = now;
      known_[mesh].mesh = mesh;
      known_[mesh].meshes = known_.size();
    });
    return !caller_.should_end();
  };
}

void SideBySide::end(std::size_t mesh) {
  change([&] { has_ended_[mesh] = true; });
}

void SideBySide::call_there(std::function<void()> what) {
  change([&] { calls_.push_back(std::move(what)); });
}

void SideBySide::run(std::size_t jobs, std::size_t at_once,
                     const std::function<void(std::size_t)>& work) {
  caller_.wait_for(
      [&] { parallel_in_turn(at_once, jobs, [&](std::size_t, std::size_t job) { work(job); }); },
      [&] { return tell_news(); });
}

bool SideBySide::tell_news() {
  std::vector<std::function<void()>> calls;
  // The last of each mesh that has ended, and what is known of the one after these.
  std::vector<Progress> news;
  {
    const std::lock_guard lock(mutex_);
    calls = std::exchange(calls_, {});
    for (; told_ < known_.size() && has_ended_[told_]; ++told_) news.push_back(known_[told_]);
    if (told_ < known_.size()) news.push_back(known_[told_]);
  }
  for (const auto& call : calls) call();
  return !tell_ || std::ranges::all_of(news, tell_);
}

}  // namespace gradmesh
