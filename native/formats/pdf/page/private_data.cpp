#include "formats/pdf/page/private_data.h"

#include <charconv>
#include <map>
#include <string_view>

#include "base/error.h"
#include "base/limits.h"
#include "formats/pdf/page/dictionary.h"
#include "formats/pdf/page/stream_bytes.h"

namespace gradmesh {
namespace {

/// Returns the streams whose names end in numbers, by these.
std::map<int, QPDFObjectHandle> numbered_streams(QPDFObjectHandle data) {
  std::map<int, QPDFObjectHandle> streams;
  if (!data.isDictionary()) return streams;
  for (const std::string& key : data.getKeys())
    for (const std::string_view name : {"/AIPrivateData", "/AIPDFPrivateData"}) {
      if (!key.starts_with(name)) continue;
      int number = 0;
      const auto read = std::from_chars(key.data() + name.size(), key.data() + key.size(), number);
      if (read.ec == std::errc() && read.ptr == key.data() + key.size())
        if (QPDFObjectHandle stream = data.getKey(key); stream.isStream())
          streams.emplace(number, stream);
    }
  return streams;
}

}  // namespace

std::string private_data(QPDFPageObjectHelper page) {
  const QPDFObjectHandle illustrator =
      value_of(page.getAttribute("/PieceInfo", false), "/Illustrator");
  std::string data;
  for (const auto& [number, stream] : numbered_streams(value_of(illustrator, "/Private"))) {
    data += stream_bytes(stream).bytes;
    const std::uint64_t most = limits().document;
    if (data.size() > most)
      throw InputError("Illustrator's data beside it have more than {0} bytes, {1}", most,
                       beyond_limit("document", most, data.size()));
  }
  constexpr std::string_view deflated = "%AI12_CompressedData";
  // The marker comes behind what the document says of itself.
  constexpr std::size_t within = 65536;
  const std::size_t at = std::string_view(data).substr(0, within).find(deflated);
  if (at == data.npos) return data;
  return inflated_bytes(std::string_view(data).substr(at + deflated.size())).bytes;
}

}  // namespace gradmesh
