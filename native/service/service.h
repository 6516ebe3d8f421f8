#pragma once

#include "service/call.h"

namespace gradmesh {

/// What Python may ask of the core, whether the core is a module that Python has loaded or a
/// program beside it: functions by name, with arguments and results in JSON
/// (docs/reference/helper.md).
class Service {
 public:
  /// The version of the functions. A caller of another version must not call any.
  static constexpr int version = 5;

  /// Returns {"result": R}, or {"error": "input", "message": [template, [arguments]]} for an
  /// InputError, or {"error": K, "text": T} where K is "value", "type", "memory", "given up" or
  /// "fault". A request is {"call": name, "arguments": {...}}, with the numbers of documents that
  /// are used no more in "release". Several threads may call, each on documents of its own; on the
  /// same documents one waits for the other.
  Json call(const Json& request, const Ask& ask);

 private:
  Documents documents_;
};

}  // namespace gradmesh
