#include "formats/pdf/page/private_data.h"

#include <charconv>
#include <map>
#include <string_view>

#include "base/limits.h"
#include "formats/pdf/objects/dictionary.h"
#include "formats/pdf/objects/stream_bytes.h"

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

/// Returns the data, unpacked where a marker tells how they are packed.
std::string unpacked(const std::string& data) {
  // The marker comes behind what the document says of itself.
  constexpr std::size_t within = 65536;
  // Of Illustrator CS2 to CC 2019, and of 2020 and later.
  constexpr std::string_view deflated = "%AI12_CompressedData", zstandard = "%AI24_ZStandard_Data";
  const std::string_view whole(data), beginning = whole.substr(0, within);
  if (const std::size_t at = beginning.find(deflated); at != data.npos)
    return inflated_bytes(whole.substr(at + deflated.size())).bytes;
  if (const std::size_t at = beginning.find(zstandard); at != data.npos)
    return zstandard_bytes(whole.substr(at + zstandard.size())).bytes;
  return data;
}

}  // namespace

std::string private_data(QPDFPageObjectHelper page) {
  const QPDFObjectHandle illustrator =
      value_of(page.getAttribute("/PieceInfo", false), "/Illustrator");
  std::string data;
  for (const auto& [number, stream] : numbered_streams(value_of(illustrator, "/Private"))) {
    data += stream_bytes(stream).bytes;
    if (data.size() > limits().document) return {};
  }
  return unpacked(data);
}

}  // namespace gradmesh
