#include "formats/pdf/page/lone_groups.h"

#include <map>
#include <set>

namespace gradmesh {
namespace {

bool is_mixed(const PageGroup& group) { return group.blend_mode != "normal" || group.opacity < 1; }

class Groups {
 public:
  explicit Groups(const std::vector<PaintedShading>& painted) {
    for (const PaintedShading& each : painted) {
      bool blends = each.blend_mode != "normal", mixes = blends || each.opacity < 1 || each.mask;
      for (const PageGroup* group = each.group.get(); group; group = group->around.get()) {
        ++members_[group];
        if (blends) blending_.insert(group);
        if (mixes) mixing_.insert(group);
        blends = (blends && !group->is_isolated) || group->blend_mode != "normal";
        mixes = mixes || is_mixed(*group);
      }
    }
  }

  /// Returns the group, and those around it, as they count: without those that change nothing.
  std::shared_ptr<const PageGroup> counting(const PageGroup* group) {
    if (!group) return nullptr;
    auto around = counting(group->around.get());
    if (changes_nothing(*group)) return around;
    std::shared_ptr<const PageGroup>& counts = counting_[group];
    if (!counts) {
      PageGroup own = *group;
      own.around = std::move(around);
      own.is_as_in_svg = is_as_in_svg(*group);
      counts = std::make_shared<const PageGroup>(std::move(own));
    }
    return counts;
  }
  bool is_alone_in(const PageGroup* group) const { return members_.at(group) == 1; }

 private:
  bool knocks_out(const PageGroup& group) const {
    return group.is_knockout && mixing_.contains(&group);
  }
  bool changes_nothing(const PageGroup& group) const {
    return !is_mixed(group) && !knocks_out(group) &&
           !(group.is_isolated && blending_.contains(&group));
  }
  /// One of SVG that changes anything is isolated.
  bool is_as_in_svg(const PageGroup& group) const {
    return !knocks_out(group) && (group.is_isolated || !blending_.contains(&group));
  }

  std::map<const PageGroup*, int> members_;
  /// Those in which something has a blend mode, and in which something lets others be seen through.
  std::set<const PageGroup*> blending_, mixing_;
  std::map<const PageGroup*, std::shared_ptr<const PageGroup>> counting_;
};

}  // namespace

void leave_lone_groups(std::vector<PaintedShading>& painted) {
  Groups groups(painted);
  // By whose addresses groups are known until all is done.
  std::vector<std::shared_ptr<const PageGroup>> before;
  for (PaintedShading& each : painted) {
    const PageGroup* group = before.emplace_back(each.group).get();
    for (; group && groups.is_alone_in(group); group = group->around.get()) {
      // An object has one mode: the second one stays with the group.
      if (!group->is_isolated && each.blend_mode != "normal" && group->blend_mode != "normal")
        break;
      each.opacity *= group->opacity;
      if (group->is_isolated || each.blend_mode == "normal") each.blend_mode = group->blend_mode;
    }
    each.group = groups.counting(group);
  }
}

}  // namespace gradmesh
