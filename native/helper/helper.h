#pragma once

#include <iosfwd>

namespace gradmesh {

/// Does what a caller asks for (service/service.h) in the messages of docs/reference/helper.md,
/// until `in` ends. While a call is at work, `{"alive": true}` is written each second, so that the
/// caller can tell work from a helper that hangs. Returns the exit status: 0, or 1 after something
/// that is no message, which is told in a last one. Where `in` ends while a call is at work, nobody
/// waits for the result, and the whole process ends at once.
int run_helper(std::istream& in, std::ostream& out);

}  // namespace gradmesh
