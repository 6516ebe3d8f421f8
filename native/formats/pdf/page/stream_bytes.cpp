#include "formats/pdf/page/stream_bytes.h"

#include <exception>
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
