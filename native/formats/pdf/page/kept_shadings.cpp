#include "formats/pdf/page/kept_shadings.h"

#include "base/error.h"
#include "base/limits.h"

namespace gradmesh {

std::shared_ptr<const PageShading> KeptShadings::read(const PaintedShading& painted) {
  const std::pair key(painted.shading.getObjGen(),
                      painted.spaces ? painted.spaces->text : std::string());
  auto found = kept_.find(key);
  // What is no object of its own has no number by which it could be known again.
  if (found == kept_.end() || !painted.shading.isIndirect()) {
    Kept now = read_now(painted);
    const std::size_t count = now.shading ? now.shading->patches.size() : 0;
    // A few of the largest shadings take no memory to speak of.
    if (patches_ + count > 4 * limits().patches) {
      kept_.clear();
      patches_ = 0;
    }
    patches_ += count;
    found = kept_.insert_or_assign(key, std::move(now)).first;
  }
  if (found->second.error) std::rethrow_exception(found->second.error);
  return found->second.shading;
}

KeptShadings::Kept KeptShadings::read_now(const PaintedShading& painted) {
  try {
    return {std::make_shared<const PageShading>(
                unplaced_shading(painted.shading, painted.spaces.get())),
            nullptr};
  } catch (const InputError&) {
    return {nullptr, std::current_exception()};
  }
}

}  // namespace gradmesh
