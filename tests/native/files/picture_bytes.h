#pragma once

#include <png.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <jpeglib.h>

namespace gradmesh::test {

using Samples = std::vector<std::uint8_t>;

/// A PNG file that is to be made.
struct PngSource {
  int width = 1, height = 1, bits = 8, color_type = PNG_COLOR_TYPE_RGB;
  Samples samples =
      {};  ///< row by row as the file holds them: of 16 bits the higher byte comes first
  bool is_interlaced = false;
  std::function<void(png_structp, png_infop)> before = {};  ///< what is set before it is written
};

inline std::string png_file(PngSource source) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp p, png_bytep data, std::size_t count) {
        static_cast<std::string*>(png_get_io_ptr(p))
            ->append(reinterpret_cast<const char*>(data), count);
      },
      nullptr);
  png_set_IHDR(png, info, png_uint_32(source.width), png_uint_32(source.height), source.bits,
               source.color_type, source.is_interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (source.before) source.before(png, info);
  png_write_info(png, info);
  const std::size_t row = source.samples.size() / std::size_t(source.height);
  std::vector<png_bytep> rows;
  for (std::size_t y = 0; y < std::size_t(source.height); ++y)
    rows.push_back(source.samples.data() + y * row);
  png_write_image(png, rows.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

/// A JPEG file that is to be made, of the best quality.
struct JpegSource {
  int width = 8, height = 8, colors = 3;
  Samples samples = {};  ///< pixel by pixel in rows
  bool is_progressive = false;
  std::string exif = {}, profile = {};
};

/// Writes the profile in many segments, though one would hold it.
inline void write_profile(jpeg_compress_struct& jpeg, const std::string& profile) {
  constexpr std::size_t part = 200;
  const std::size_t parts = (profile.size() + part - 1) / part;
  for (std::size_t i = 0; i < parts; ++i) {
    std::string data("ICC_PROFILE\0", 12);
    data += {char(i + 1), char(parts)};
    data += profile.substr(i * part, part);
    jpeg_write_marker(&jpeg, JPEG_APP0 + 2, reinterpret_cast<const JOCTET*>(data.data()),
                      unsigned(data.size()));
  }
}

inline std::string jpeg_file(JpegSource source) {
  jpeg_compress_struct jpeg;
  jpeg_error_mgr errors;
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* written = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &written, &size);
  jpeg.image_width = JDIMENSION(source.width);
  jpeg.image_height = JDIMENSION(source.height);
  jpeg.input_components = source.colors;
  jpeg.in_color_space = source.colors == 1   ? JCS_GRAYSCALE
                        : source.colors == 3 ? JCS_RGB
                                             : JCS_CMYK;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 100, TRUE);
  for (int i = 0; i < jpeg.num_components; ++i)
    jpeg.comp_info[i].h_samp_factor = jpeg.comp_info[i].v_samp_factor = 1;
  if (source.is_progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  if (!source.exif.empty())
    jpeg_write_marker(&jpeg, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(source.exif.data()),
                      unsigned(source.exif.size()));
  write_profile(jpeg, source.profile);
  const std::size_t row = std::size_t(source.width) * std::size_t(source.colors);
  for (std::size_t y = 0; y < std::size_t(source.height); ++y) {
    JSAMPROW samples = source.samples.data() + y * row;
    jpeg_write_scanlines(&jpeg, &samples, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::string bytes(reinterpret_cast<const char*>(written), size);
  jpeg_destroy_compress(&jpeg);
  std::free(written);
  return bytes;
}

/// A number of as many bytes, the lowest first.
inline std::string little_endian(std::uint32_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += char(value >> (8 * i) & 255);
  return text;
}

/// EXIF's data with one entry beside the orientation, as Intel's or as Motorola's processors have
/// numbers.
inline std::string exif_data(int orientation, bool is_little_endian = true) {
  const auto number = [&](std::uint32_t value, int bytes) {
    const std::string text = little_endian(value, bytes);
    return is_little_endian ? text : std::string(text.rbegin(), text.rend());
  };
  return (is_little_endian ? "II" : "MM") + number(42, 2) + number(8, 4) + number(2, 2) +
         number(0x100, 2) + number(3, 2) + number(1, 4) + number(7, 2) + number(0, 2) +
         number(0x112, 2) + number(3, 2) + number(1, 4) + number(std::uint32_t(orientation), 2) +
         number(0, 2) + number(0, 4);
}

/// A TIFF file of 3 x 1 pixels in RGBA of 16 bits, the colours multiplied by the opacity or not,
/// with an orientation and, unless it is empty, a profile.
inline std::string tiff_file(const std::vector<std::uint16_t>& samples, bool is_multiplied,
                             int orientation, const std::string& profile) {
  struct Entry {
    std::uint32_t tag, type, count, value;
  };
  const std::uint32_t bits_at = 8, samples_at = 16, profile_at = samples_at + 24;
  std::vector<Entry> entries = {{256, 3, 1, 3},
                                {257, 3, 1, 1},
                                {258, 3, 4, bits_at},
                                {259, 3, 1, 1},
                                {262, 3, 1, 2},
                                {273, 4, 1, samples_at},
                                {274, 3, 1, std::uint32_t(orientation)},
                                {277, 3, 1, 4},
                                {278, 3, 1, 1},
                                {279, 4, 1, 24},
                                {284, 3, 1, 1},
                                {338, 3, 1, is_multiplied ? 1u : 2u}};
  if (!profile.empty()) entries.push_back({34675, 7, std::uint32_t(profile.size()), profile_at});
  const std::string padded = profile + std::string(profile.size() % 2, '\0');
  std::string file =
      "II*" + std::string(1, '\0') + little_endian(profile_at + std::uint32_t(padded.size()), 4);
  for (int i = 0; i < 4; ++i) file += little_endian(16, 2);
  for (const std::uint16_t sample : samples) file += little_endian(sample, 2);
  file += padded + little_endian(std::uint32_t(entries.size()), 2);
  for (const Entry& e : entries)
    file += little_endian(e.tag, 2) + little_endian(e.type, 2) + little_endian(e.count, 4) +
            little_endian(e.value, 4);
  return file + little_endian(0, 4);
}

}  // namespace gradmesh::test
