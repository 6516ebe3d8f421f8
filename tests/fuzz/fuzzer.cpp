#include <cstddef>
#include <cstdint>

#include "target.h"

/// What libFuzzer calls.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gradmesh::fuzz::check({reinterpret_cast<const char*>(data), size});
  return 0;
}
