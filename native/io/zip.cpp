#include "io/zip.h"

#include <zlib.h>

#include <algorithm>
#include <stdexcept>

namespace gradmesh {
namespace {

const Bytef* input(std::string_view bytes) { return reinterpret_cast<const Bytef*>(bytes.data()); }
Bytef* output(std::string& bytes) { return reinterpret_cast<Bytef*>(bytes.data()); }

}  // namespace

std::string zip(std::string_view bytes) {
  uLongf size = compressBound(uLong(bytes.size()));
  std::string zipped(size, '\0');
  if (compress2(output(zipped), &size, input(bytes), uLong(bytes.size()), Z_BEST_COMPRESSION) !=
      Z_OK)
    throw std::runtime_error("zlib does not compress.");
  zipped.resize(size);
  return zipped;
}

std::optional<std::string> unzip(std::string_view zipped, std::size_t most) {
  // The size is not told beforehand: guessed, and doubled while it is too small.
  for (std::size_t room = 8 * zipped.size() + 64;; room *= 2) {
    std::string bytes(std::min(room, most), '\0');
    auto size = uLongf(bytes.size());
    const int status = uncompress(output(bytes), &size, input(zipped), uLong(zipped.size()));
    if (status == Z_BUF_ERROR && room < most) continue;
    if (status != Z_OK) return std::nullopt;
    bytes.resize(size);
    return bytes;
  }
}

}  // namespace gradmesh
