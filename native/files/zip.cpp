#include "files/zip.h"

#include <zlib.h>

#include <algorithm>
#include <new>
#include <stdexcept>
#include <utility>

namespace gradmesh {
namespace {

/// zlib's number for the format of gzip with the largest window.
constexpr int gzip_window = 16 + MAX_WBITS;
/// Value of the header's field OS (RFC 1952).
constexpr int unknown_system = 255;

const Bytef* input(std::string_view bytes) { return reinterpret_cast<const Bytef*>(bytes.data()); }
Bytef* output(std::string& bytes) { return reinterpret_cast<Bytef*>(bytes.data()); }

}  // namespace

std::string pack_zlib(std::string_view bytes) {
  uLongf size = compressBound(uLong(bytes.size()));
  std::string zipped(size, '\0');
  if (compress2(output(zipped), &size, input(bytes), uLong(bytes.size()), Z_BEST_COMPRESSION) !=
      Z_OK)
    throw std::runtime_error("zlib does not compress.");
  zipped.resize(size);
  return zipped;
}

std::optional<std::string> unpack_zlib(std::string_view zipped, std::size_t most) {
  // The size is not known beforehand: it is guessed, and doubled while it is too small.
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

std::string gzip(std::string_view bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, gzip_window, 8, Z_DEFAULT_STRATEGY) !=
      Z_OK)
    throw std::runtime_error("zlib does not compress.");
  // zlib's own header would name the system.
  gz_header header{};
  header.os = unknown_system;
  deflateSetHeader(&stream, &header);
  std::string zipped(deflateBound(&stream, uLong(bytes.size())), '\0');
  stream.next_in = const_cast<Bytef*>(input(bytes));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = output(zipped);
  stream.avail_out = uInt(zipped.size());
  const int status = deflate(&stream, Z_FINISH);
  zipped.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END) throw std::runtime_error("zlib does not compress.");
  return zipped;
}

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::uint64_t gunzipped_size(std::string_view bytes) {
  std::uint64_t size = 0;
  for (std::size_t i = 1; i <= std::min<std::size_t>(bytes.size(), 4); ++i)
    size = size << 8 | static_cast<unsigned char>(bytes[bytes.size() - i]);
  return size;
}

std::optional<std::string> gunzip(std::string_view bytes) {
  z_stream stream{};
  if (inflateInit2(&stream, gzip_window) != Z_OK) throw std::bad_alloc();
  stream.next_in = const_cast<Bytef*>(input(bytes));
  stream.avail_in = uInt(bytes.size());
  const std::size_t most = gunzipped_size(bytes);
  std::string text;
  int status = Z_OK;
  // The size that a damaged file states is not allocated before the bytes are there.
  do {
    text.resize(std::min(most, 2 * text.size() + 8 * bytes.size()));
    stream.next_out = output(text) + stream.total_out;
    stream.avail_out = uInt(text.size() - stream.total_out);
    status = inflate(&stream, Z_NO_FLUSH);
  } while (status == Z_OK && stream.avail_out == 0 && text.size() < most);
  const bool is_whole = status == Z_STREAM_END && stream.total_out == most;
  inflateEnd(&stream);
  return is_whole && stream.avail_in == 0 ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace gradmesh
