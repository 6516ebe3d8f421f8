#pragma once

#include <functional>
#include <string>

#include "base/error.h"

namespace gradmesh::test {

/// Returns the sentence of the InputError that `action` throws.
inline std::string complaint(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace gradmesh::test
