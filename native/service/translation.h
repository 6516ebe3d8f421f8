#pragma once

#include "base/message.h"
#include "service/call.h"

namespace gradmesh {

/// Returns the translation that the caller of the call on this thread gives, whichever call that
/// is; outside of calls it leaves texts as they are.
Translation callers_translation();

/// Lets `ask` be whom callers_translation() asks on this thread while it lives.
class Caller {
 public:
  explicit Caller(const Ask& ask);
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;
  ~Caller();

 private:
  const Ask* const before_;
};

}  // namespace gradmesh
