#pragma once

#include <stdexcept>
#include <string>

namespace gradmesh {

/// Bad input or a file that cannot be read or written. `what()` is one plain sentence for the
/// person, which names the file and the element where there is one.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace gradmesh
