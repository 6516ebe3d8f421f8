#pragma once

#include <cstdint>
#include <string_view>

#include "base/message.h"

namespace gradmesh {

/// How large a document, or the result that is asked of it, may be before it is refused with a
/// sentence, so that neither a mistake nor a stranger's file ends in an hour's wait or takes all
/// memory. The environment variable GRADMESH_LIMITS sets the limits for the whole program, for
/// example "patches=50000,memory=16G".
struct Limits {
  std::uint64_t document = std::uint64_t(512) << 20;  ///< bytes of a file that is read
  std::uint64_t patches = 20000;                      ///< patches of a mesh
  std::uint64_t nesting = 256;                        ///< elements inside one another, to 5000
  std::uint64_t links = 32;                           ///< gradients in a chain of references
  std::uint64_t resolution = 8192;                    ///< pixels along the longer side, to 16384
  std::uint64_t memory = std::uint64_t(8) << 30;      ///< bytes that measuring pictures takes

  bool operator==(const Limits&) const = default;
};

/// Returns the limits in force. Throws std::invalid_argument where GRADMESH_LIMITS cannot be
/// understood.
const Limits& limits();

/// Returns the limits that a text sets: names and numbers (with K, M or G: times 1024, 1024^2,
/// 1024^3), separated by commas. Throws std::invalid_argument, naming what is wrong.
Limits limits_from(std::string_view text);

/// Returns the clause that `needed` is beyond the limit: "more than the limit of 256, which
/// GRADMESH_LIMITS=nesting=300 raises". `name` is the limit's name in Limits.
Message beyond_limit(std::string_view name, std::uint64_t limit, std::uint64_t needed);

}  // namespace gradmesh
