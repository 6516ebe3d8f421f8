#include "formats/pdf/objects/stream_bytes.h"

#include <zstd.h>

#include <array>
#include <exception>
#include <memory>
#include <qpdf/Pipeline.hh>
#include <qpdf/Pl_Flate.hh>
#include <stdexcept>

#include "base/error.h"
#include "base/limits.h"

namespace gradmesh {
namespace {

/// Keeps what is unpacked, up to the limit: a small stream may unpack to gigabytes.
class CollectedBytes : public Pipeline {
 public:
  CollectedBytes() : Pipeline("collected", nullptr) {}

  void write(const unsigned char* data, std::size_t size) override {
    is_too_much = is_too_much || bytes.size() + size > limits().document;
    // qpdf takes it for damage, and ends.
    if (is_too_much) throw std::runtime_error("too much");
    bytes.append(reinterpret_cast<const char*>(data), size);
  }
  void finish() override {}

  std::string bytes;
  bool is_too_much = false;
};

/// Throws where a stream unpacks to more than the limit.
void check(const CollectedBytes& collected) {
  const std::uint64_t most = limits().document;
  if (collected.is_too_much)
    throw InputError("a stream of it unpacks to more than {0} bytes, {1}", most,
                     beyond_limit("document", most, 2 * most));
}

/// Unpacks the first frame of Zstandard. Returns whether it is there to its end.
bool unpack_frame(std::string_view packed, Pipeline& unpacked) {
  const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(),
                                                                     ZSTD_freeDCtx);
  // A call that ends in an error keeps to itself what it had unpacked.
  std::array<unsigned char, 4096> part;
  ZSTD_inBuffer in{packed.data(), packed.size(), 0};
  bool is_end = false;
  while (!is_end) {
    ZSTD_outBuffer out{part.data(), part.size(), 0};
    const std::size_t left = ZSTD_decompressStream(context.get(), &out, &in);
    if (ZSTD_isError(left)) return false;
    unpacked.write(part.data(), out.pos);
    is_end = left == 0;
    // All that there was is taken, and nothing of it waits to be given.
    if (!is_end && in.pos == in.size && out.pos < out.size) return false;
  }
  return true;
}

}  // namespace

StreamBytes inflated_bytes(std::string_view packed) {
  CollectedBytes collected;
  bool is_whole = true;
  try {
    Pl_Flate inflate("packed", &collected, Pl_Flate::a_inflate);
    inflate.write(reinterpret_cast<const unsigned char*>(packed.data()), packed.size());
    inflate.finish();
  } catch (const std::exception&) {
    // What it gave before is there.
    is_whole = false;
  }
  check(collected);
  return {std::move(collected.bytes), !is_whole};
}

StreamBytes zstandard_bytes(std::string_view packed) {
  CollectedBytes collected;
  bool is_whole = false;
  try {
    is_whole = unpack_frame(packed, collected);
  } catch (const std::runtime_error&) {
    // What it gave before is there.
  }
  check(collected);
  return {std::move(collected.bytes), !is_whole};
}

StreamBytes stream_bytes(QPDFObjectHandle stream) {
  CollectedBytes collected;
  bool is_unpacked = false, is_whole = false;
  try {
    is_whole = stream.pipeStreamData(&collected, &is_unpacked, 0, qpdf_dl_specialized, true);
  } catch (const std::exception&) {
    // What it gave before is there.
  }
  check(collected);
  // What a filter that is not known has packed says nothing.
  if (!is_unpacked && stream.getDict().hasKey("/Filter")) return {{}, true};
  return {std::move(collected.bytes), !is_whole};
}

}  // namespace gradmesh
