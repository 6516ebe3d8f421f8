#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "session/picture.h"
#include "window/toolkit/draw_lists.h"

namespace gradmesh {

/// The pixels of what is seen of a session, painted anew only where it has changed.
class SessionTexture {
 public:
  /// Returns the picture, which stays as it is until the next call. `revision` is another number
  /// whenever the session shows something else.
  const Texture& of(const Session& session, const SessionView& view, int revision);

 private:
  std::optional<SessionView> view_;
  const Session* session_ = nullptr;
  int revision_ = 0;
  std::vector<std::uint32_t> pixels_;
  Texture texture_;
};

}  // namespace gradmesh
