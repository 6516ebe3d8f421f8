#include <optional>
#include <string>

#include "files/base64.h"
#include "files/zip.h"
#include "formats/packed/patches.h"
#include "formats/svg/group/memory.h"
#include "mesh/build.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

void check_packing(const std::string& text) {
  require(base64_bytes(base64(text)) == text, "base64 gives the bytes back");
  require(base85_bytes(base85(text)) == text, "base85 gives the bytes back");
  if (const auto bytes = base85_bytes(text))
    require(base85(*bytes) == text, "bytes have one text in base85");
  if (auto mesh = unpack(text)) pack(std::move(*mesh), 22);
  require(unpack_zlib(pack_zlib(text), text.size()) == text, "zip gives the bytes back");
  // Also as they come from a stranger: packed by nobody.
  unpack_zlib(text, 1 << 16);
  require(gunzip(gzip(text)) == text, "gzip gives the bytes back");
  if (gunzipped_size(text) < 1 << 20) gunzip(text);
  if (const auto bytes = base64_bytes(text)) unpack_zlib(*bytes, 1 << 16);
}

/// The text as what a memory unpacks to.
void check_recall(const std::string& text) {
  recall_blocks(base64(pack_zlib(text)));
  const auto parts = recall(base64(pack_zlib(text)));
  if (!parts) return;
  const Mesh mesh = build_mesh(*parts);
  require_sound(mesh);
  const auto again = recall(remember(mesh));
  require(again.has_value(), "what is remembered can be recalled");
  const Mesh recalled = build_mesh(*again);
  require_sound(recalled);
  require(recalled.face_count() == mesh.face_count(), "no patch is lost");
}

}  // namespace

void check(std::string_view bytes) {
  check_packing(std::string(bytes));
  check_recall(std::string(bytes));
}

}  // namespace gradmesh::fuzz
