#include "files/picture_file.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>

#include "complaint.h"
#include "files/atomic_file.h"
#include "files/box_reducer.h"
#include "files/orientation.h"
#include "picture_bytes.h"
#include "picture_profiles.h"

namespace gradmesh {
namespace {

namespace fs = std::filesystem;

using test::complaint;
using test::exif_data;
using test::jpeg_file;
using test::JpegSource;
using test::png_file;
using test::PngSource;
using Bytes = test::Samples;

constexpr int whole = 10000;

Picture picture(const std::string& bytes, int longest = whole) {
  return picture_of_bytes(bytes, "a picture", longest);
}
/// The picture's samples, pixel by pixel.
Bytes samples(const std::string& bytes, int longest = whole) {
  return interleaved(picture(bytes, longest).image);
}
std::string refusal(const std::string& bytes) {
  return complaint([&] { picture(bytes); });
}

/// How far two lists of samples are apart at most.
int distance(const Bytes& a, const Bytes& b) {
  if (a.size() != b.size()) return 1000;
  int worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

/// What the pixel becomes in a PNG file of this kind.
Bytes pixel(int color_type, int bits, const Bytes& held,
            const std::function<void(png_structp, png_infop)>& before = {}) {
  return samples(
      png_file({.bits = bits, .color_type = color_type, .samples = held, .before = before}));
}

/// Pixels that all differ, in RGB.
Bytes colorful(int width, int height) {
  Bytes list;
  for (int i = 0; i < width * height; ++i)
    for (int c = 1; c <= 3; ++c) list.push_back(std::uint8_t(i * (7 * c + 4) + 40 * c));
  return list;
}

/// The same with opacities.
Bytes opaque(const Bytes& rgb) {
  Bytes list;
  for (std::size_t i = 0; i < rgb.size(); i += 3)
    list.insert(list.end(), {rgb[i], rgb[i + 1], rgb[i + 2], 255});
  return list;
}

/// A JPEG file of one colour.
JpegSource plain(const Bytes& color, int width = 8, int height = 8) {
  JpegSource source{.width = width, .height = height, .colors = int(color.size())};
  for (int i = 0; i < width * height; ++i)
    source.samples.insert(source.samples.end(), color.begin(), color.end());
  return source;
}

/// A JPEG file, the left half of which is dark and the right half light.
JpegSource halves(const std::string& exif = {}) {
  JpegSource source{.width = 32, .height = 16, .colors = 1, .exif = exif};
  for (int i = 0; i < 32 * 16; ++i) source.samples.push_back(i % 32 < 16 ? 20 : 220);
  return source;
}

/// The file with another size in its header.
std::string with_size(std::string png, std::uint32_t width, std::uint32_t height) {
  const auto put = [&](std::size_t at, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) png[at + std::size_t(i)] = char(value >> (24 - 8 * i) & 255);
  };
  put(16, width), put(20, height);
  put(29, std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(png.data() + 12), 17)));
  return png;
}

auto with_profile(const std::string& profile) {
  return [profile](png_structp png, png_infop info) {
    png_set_iCCP(png, info, "profile", 0, reinterpret_cast<png_const_bytep>(profile.data()),
                 png_uint_32(profile.size()));
  };
}

TEST(PictureFile, all_kinds_of_png_are_read) {
  EXPECT_EQ(pixel(PNG_COLOR_TYPE_RGB, 8, {1, 2, 3}), (Bytes{1, 2, 3, 255}));
  EXPECT_EQ(pixel(PNG_COLOR_TYPE_RGBA, 8, {1, 2, 3, 128}), (Bytes{1, 2, 3, 128}));
  EXPECT_EQ(pixel(PNG_COLOR_TYPE_GRAY, 8, {77}), (Bytes{77, 77, 77, 255}));
  EXPECT_EQ(pixel(PNG_COLOR_TYPE_GRAY, 2, {0x80}), (Bytes{170, 170, 170, 255}));
  EXPECT_EQ(pixel(PNG_COLOR_TYPE_GRAY_ALPHA, 8, {77, 9}), (Bytes{77, 77, 77, 9}));
  // 16 bits: 0x0181 is 385 / 257 = 1.498 and 0x0182 386 / 257 = 1.502
  EXPECT_EQ(pixel(PNG_COLOR_TYPE_RGB, 16, {1, 0x81, 1, 0x82, 255, 255}), (Bytes{1, 2, 255, 255}));
  EXPECT_EQ(pixel(PNG_COLOR_TYPE_GRAY_ALPHA, 16, {8, 8, 1, 0x82}), (Bytes{8, 8, 8, 2}));
}

TEST(PictureFile, what_cannot_be_seen_has_no_color) {
  EXPECT_EQ(pixel(PNG_COLOR_TYPE_RGBA, 8, {1, 2, 3, 0}), (Bytes{0, 0, 0, 0}));
}

TEST(PictureFile, palettes_and_colors_that_stand_for_transparency_are_read) {
  const auto palette = [](png_structp png, png_infop info) {
    const png_color colors[] = {{10, 20, 30}, {40, 50, 60}, {70, 80, 90}};
    const png_byte opacities[] = {255, 100};
    png_set_PLTE(png, info, colors, 3);
    png_set_tRNS(png, info, opacities, 2, nullptr);
  };
  PngSource source{.width = 3,
                   .bits = 2,
                   .color_type = PNG_COLOR_TYPE_PALETTE,
                   .samples = {0b00011000},
                   .before = palette};
  EXPECT_EQ(samples(png_file(source)), (Bytes{10, 20, 30, 255, 40, 50, 60, 100, 70, 80, 90, 255}));
  const auto clear = [](png_structp png, png_infop info) {
    png_color_16 color{};
    color.gray = color.red = color.green = color.blue = 5;
    png_set_tRNS(png, info, nullptr, 0, &color);
  };
  PngSource grey{.width = 2, .color_type = PNG_COLOR_TYPE_GRAY, .samples = {5, 6}, .before = clear};
  EXPECT_EQ(samples(png_file(grey)), (Bytes{0, 0, 0, 0, 6, 6, 6, 255}));
  PngSource rgb{.width = 2, .samples = {5, 5, 5, 5, 5, 6}, .before = clear};
  EXPECT_EQ(samples(png_file(rgb)), (Bytes{0, 0, 0, 0, 5, 5, 6, 255}));
}

TEST(PictureFile, interlaced_png_is_read) {
  for (const bool is_interlaced : {false, true}) {
    const Bytes rgb = colorful(11, 9);
    const std::string file =
        png_file({.width = 11, .height = 9, .samples = rgb, .is_interlaced = is_interlaced});
    EXPECT_EQ(samples(file), opaque(rgb));
  }
}

TEST(PictureFile, jpeg_is_read) {
  for (const bool is_progressive : {false, true}) {
    JpegSource source = plain({200, 100, 50}, 19, 11);
    source.is_progressive = is_progressive;
    const Picture read = picture(jpeg_file(source));
    EXPECT_EQ(read.image.width, 19);
    EXPECT_EQ(read.image.height, 11);
    EXPECT_LE(distance(interleaved(read.image), opaque(source.samples)), 1);
  }
  EXPECT_EQ(samples(jpeg_file(plain({77})), 1), (Bytes{77, 77, 77, 255}));
}

TEST(PictureFile, a_profile_brings_colors_to_srgb) {
  const auto swapped = with_profile(test::swapped_profile());
  const Bytes expected{100, 200, 50, 255};
  EXPECT_LE(distance(pixel(PNG_COLOR_TYPE_RGB, 8, {200, 100, 50}, swapped), expected), 1);
  EXPECT_LE(
      distance(pixel(PNG_COLOR_TYPE_RGB, 16, {200, 200, 100, 100, 50, 50}, swapped), expected), 1);
  EXPECT_LE(
      distance(pixel(PNG_COLOR_TYPE_RGBA, 8, {200, 100, 50, 60}, swapped), {100, 200, 50, 60}), 1);
  // A fifth of the light is 124 in sRGB.
  const auto linear = with_profile(test::linear_grey_profile());
  EXPECT_LE(distance(pixel(PNG_COLOR_TYPE_GRAY, 8, {51}, linear), {124, 124, 124, 255}), 1);
  EXPECT_LE(
      distance(pixel(PNG_COLOR_TYPE_GRAY_ALPHA, 16, {51, 51, 7, 7}, linear), {124, 124, 124, 7}),
      1);
  JpegSource jpeg = plain({200, 100, 50});
  jpeg.profile = test::swapped_profile();
  ASSERT_GT(jpeg.profile.size(), 200u);
  EXPECT_LE(distance(samples(jpeg_file(jpeg), 1), expected), 2);
  JpegSource grey = plain({77});
  grey.profile = test::swapped_profile();
  EXPECT_LE(distance(samples(jpeg_file(grey), 1), {77, 77, 77, 255}), 1);
}

TEST(PictureFile, a_profile_that_cannot_be_used_is_ignored) {
  const std::string right = test::swapped_profile();
  for (const std::string& profile : {std::string("no profile"), right.substr(0, 150),
                                     std::string(right.size(), 'x'), test::linear_grey_profile()}) {
    JpegSource source = plain({200, 100, 50});
    source.profile = profile;
    EXPECT_LE(distance(samples(jpeg_file(source), 1), {200, 100, 50, 255}), 1) << profile.size();
  }
}

TEST(PictureFile, gamma_and_chromaticities_bring_colors_to_srgb) {
  const auto linear = [](png_structp png, png_infop info) { png_set_gAMA(png, info, 1); };
  EXPECT_LE(distance(pixel(PNG_COLOR_TYPE_GRAY, 8, {51}, linear), {124, 124, 124, 255}), 1);
  EXPECT_LE(
      distance(pixel(PNG_COLOR_TYPE_RGB, 16, {51, 51, 0, 0, 255, 255}, linear), {124, 0, 255, 255}),
      1);
  const auto swapped = [](png_structp png, png_infop info) {
    png_set_cHRM(png, info, 0.3127, 0.329, 0.30, 0.60, 0.64, 0.33, 0.15, 0.06);
  };
  EXPECT_LE(distance(pixel(PNG_COLOR_TYPE_RGB, 8, {200, 100, 50}, swapped), {100, 200, 50, 255}),
            1);
  // What nearly all files say is sRGB.
  const auto usual = [](png_structp png, png_infop info) {
    png_set_gAMA(png, info, 0.45455);
    png_set_cHRM(png, info, 0.3127, 0.329, 0.64, 0.33, 0.30, 0.60, 0.15, 0.06);
  };
  EXPECT_EQ(pixel(PNG_COLOR_TYPE_RGB, 8, {9, 10, 11}, usual), (Bytes{9, 10, 11, 255}));
  const auto srgb = [](png_structp png, png_infop info) {
    png_set_sRGB_gAMA_and_cHRM(png, info, 0);
  };
  EXPECT_EQ(pixel(PNG_COLOR_TYPE_RGB, 8, {9, 10, 11}, srgb), (Bytes{9, 10, 11, 255}));
}

TEST(PictureFile, cmyk_is_read_where_a_profile_says_what_it_is) {
  // Written with Adobe's marker, which libjpeg adds: the samples say how much ink is missing.
  JpegSource source = plain({255, 255, 255, 128});
  EXPECT_EQ(refusal(jpeg_file(source)),
            "a picture is not a readable picture: its colours are CMYK, and it has no colour "
            "profile that says which.");
  source.profile = test::black_ink_profile();
  // The lightness 50 is 119 in sRGB.
  EXPECT_LE(distance(samples(jpeg_file(source), 1), {119, 119, 119, 255}), 2);
  source = plain({255, 255, 255, 255});
  source.profile = test::black_ink_profile();
  EXPECT_LE(distance(samples(jpeg_file(source), 1), {255, 255, 255, 255}), 1);
}

TEST(PictureFile, all_orientations_are_brought_upright) {
  // What is to be seen is 1 2 3 above 4 5 6; the file holds it turned.
  RgbaImage seen(3, 2);
  for (int i = 0; i < 6; ++i) {
    const auto v = std::uint8_t(i + 1);
    seen.set_pixel(i % 3, i / 3, {v, v, v, 255});
  }
  const std::vector<Bytes> held = {{1, 2, 3, 4, 5, 6}, {3, 2, 1, 6, 5, 4}, {6, 5, 4, 3, 2, 1},
                                   {4, 5, 6, 1, 2, 3}, {1, 4, 2, 5, 3, 6}, {3, 6, 2, 5, 1, 4},
                                   {6, 3, 5, 2, 4, 1}, {4, 1, 5, 2, 6, 3}};
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const bool on_side = orientation >= 5;
    PngSource source{.width = on_side ? 2 : 3,
                     .height = on_side ? 3 : 2,
                     .color_type = PNG_COLOR_TYPE_GRAY,
                     .samples = held[std::size_t(orientation - 1)]};
    for (const bool is_little_endian : {false, true}) {
      source.before = [&](png_structp png, png_infop info) {
        std::string exif = exif_data(orientation, is_little_endian);
        png_set_eXIf_1(png, info, png_uint_32(exif.size()),
                       reinterpret_cast<png_bytep>(exif.data()));
      };
      const Picture read = picture(png_file(source));
      EXPECT_EQ(read.image, seen) << orientation;
      EXPECT_EQ(read.full_width, 3);
      EXPECT_EQ(read.full_height, 2);
    }
  }
}

TEST(PictureFile, the_orientation_of_jpeg_is_heeded) {
  const std::string exif = std::string("Exif\0\0", 6) + exif_data(6);
  // Turned to the right, what was left is above.
  const Picture read = picture(jpeg_file(halves(exif)), 8);
  EXPECT_EQ(read.full_width, 16);
  EXPECT_EQ(read.full_height, 32);
  EXPECT_EQ(read.image.width, 4);
  EXPECT_EQ(read.image.height, 8);
  EXPECT_EQ(read.image.pixel(0, 0)[0], 20);
  EXPECT_EQ(read.image.pixel(0, 7)[0], 220);
}

TEST(PictureFile, damaged_exif_says_nothing) {
  EXPECT_EQ(exif_orientation(exif_data(8)), 8);
  for (const int impossible : {0, 9, 65535}) EXPECT_EQ(exif_orientation(exif_data(impossible)), 1);
  const std::string exif = exif_data(8);
  for (std::size_t length = 0; length < exif.size(); ++length) {
    const int orientation = exif_orientation(exif.substr(0, length));
    EXPECT_TRUE(orientation == 1 || orientation == 8) << length;
  }
  std::string far = exif;
  far.replace(4, 4, "\xff\xff\xff\xff");
  EXPECT_EQ(exif_orientation(far), 1);
}

TEST(PictureFile, a_picture_is_reduced_by_area) {
  // A checkerboard of black and white becomes its mean, 127.5, rounded.
  Bytes board;
  for (int i = 0; i < 64; ++i) board.push_back((i % 8 + i / 8) % 2 ? 255 : 0);
  const Picture read = picture(
      png_file({.width = 8, .height = 8, .color_type = PNG_COLOR_TYPE_GRAY, .samples = board}), 4);
  EXPECT_EQ(read.full_width, 8);
  EXPECT_EQ(read.image, RgbaImage([] {
              RgbaImage image(4, 4, 128);
              fill(image, image.window(), std::uint8_t(128));
              for (int y = 0; y < 4; ++y) std::fill_n(image.at(0, y, 3), 4, std::uint8_t(255));
              return image;
            }()));
  // 3 to 2: a pixel and a half each
  EXPECT_EQ(
      samples(png_file({.width = 3, .color_type = PNG_COLOR_TYPE_GRAY, .samples = {0, 100, 255}}),
              2),
      (Bytes{33, 33, 33, 255, 203, 203, 203, 255}));
  EXPECT_EQ(
      samples(png_file({.height = 3, .color_type = PNG_COLOR_TYPE_GRAY, .samples = {0, 100, 255}}),
              2),
      (Bytes{33, 33, 33, 255, 203, 203, 203, 255}));
}

TEST(PictureFile, colors_count_by_their_opacity) {
  // (200 * 255 + 100 * 85) / 340 and (255 + 85) / 2
  EXPECT_EQ(samples(png_file({.width = 2,
                              .color_type = PNG_COLOR_TYPE_RGBA,
                              .samples = {200, 0, 0, 255, 100, 0, 0, 85}}),
                    1),
            (Bytes{175, 0, 0, 170}));
  EXPECT_EQ(samples(png_file({.width = 2,
                              .color_type = PNG_COLOR_TYPE_RGBA,
                              .samples = {9, 8, 7, 255, 255, 255, 255, 0}}),
                    1),
            (Bytes{9, 8, 7, 128}));
}

TEST(PictureFile, a_picture_is_never_enlarged) {
  const Bytes rgb = colorful(5, 3);
  const std::string file = png_file({.width = 5, .height = 3, .samples = rgb});
  EXPECT_EQ(samples(file, 5), opaque(rgb));
  EXPECT_EQ(samples(file, 6), opaque(rgb));
  const Picture tiny = picture(file, 1);
  EXPECT_EQ(tiny.image.width, 1);
  EXPECT_EQ(tiny.image.height, 1);
  EXPECT_THROW(picture(file, 0), std::invalid_argument);
}

/// The average of a grey picture over a rectangle, pixel by pixel.
double average(const Bytes& grey, int width, int height, double x0, double y0, double x1,
               double y1) {
  double sum = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      sum += std::max(0.0, std::min(x1, x + 1.0) - std::max(x0, double(x))) *
             std::max(0.0, std::min(y1, y + 1.0) - std::max(y0, double(y))) *
             grey[std::size_t(y * width + x)];
  return sum / ((x1 - x0) * (y1 - y0));
}

TEST(PictureFile, every_ratio_averages_exactly) {
  std::mt19937 random(1);
  for (const auto& [width, height, longest] :
       {std::array{17, 11, 16}, {17, 11, 7}, {10, 30, 29}, {5, 31, 3}, {31, 2, 4}, {12, 12, 5}}) {
    Bytes grey;
    for (int i = 0; i < width * height; ++i) grey.push_back(std::uint8_t(random() % 256));
    const RgbaImage read = picture(png_file({.width = width,
                                             .height = height,
                                             .color_type = PNG_COLOR_TYPE_GRAY,
                                             .samples = grey}),
                                   longest)
                               .image;
    ASSERT_EQ(std::max(read.width, read.height), longest);
    const double across = double(width) / read.width, down = double(height) / read.height;
    for (int y = 0; y < read.height; ++y)
      for (int x = 0; x < read.width; ++x) {
        const double expected =
            average(grey, width, height, x * across, y * down, (x + 1) * across, (y + 1) * down);
        EXPECT_NEAR(read.pixel(x, y)[0], expected, 0.5 + 1e-9);
        EXPECT_EQ(read.pixel(x, y)[3], 255);
      }
  }
}

TEST(PictureFile, files_that_are_cut_off_are_refused_at_every_length) {
  JpegSource progressive = halves();
  progressive.is_progressive = true;
  JpegSource with_exif = halves(std::string("Exif\0\0", 6) + exif_data(3));
  with_exif.profile = test::linear_grey_profile();
  const Bytes rgb = colorful(6, 5);
  for (const std::string& file :
       {png_file({.width = 6, .height = 5, .samples = rgb}),
        png_file({.width = 6,
        .height = 5,
        .samples = rgb,
        .is_interlaced = true,
        .before = with_profile(test::swapped_profile())}),
        jpeg_file(halves()), jpeg_file(progressive), jpeg_file(with_exif)}) {
    picture(file);
    for (std::size_t length = 0; length < file.size(); ++length) {
      const std::string why = refusal(file.substr(0, length));
      EXPECT_TRUE(why.starts_with("a picture is not a readable picture: ") && why.ends_with("."))
          << length << " of " << file.size() << ": " << why;
    }
    EXPECT_EQ(refusal(file.substr(0, file.size() - 1)),
              "a picture is not a readable picture: it ends in the middle.");
  }
}

TEST(PictureFile, damaged_files_end_in_a_sentence) {
  const Bytes rgb = colorful(6, 5);
  JpegSource jpeg = halves(std::string("Exif\0\0", 6) + exif_data(3));
  for (const std::string& file :
       {png_file({.width = 6, .height = 5, .samples = rgb}), jpeg_file(jpeg)})
    for (std::size_t i = 0; i < file.size(); ++i)
      for (const int flip : {1, 128, 255}) {
        std::string damaged = file;
        damaged[i] = char(damaged[i] ^ flip);
        const std::string why = refusal(damaged);
        EXPECT_TRUE(why == "nothing was thrown" ||
                    why.starts_with("a picture is not a readable picture: "))
            << why;
      }
}

TEST(PictureFile, pictures_beyond_the_limit_are_refused) {
  const std::string file = png_file({.samples = {1, 2, 3}});
  EXPECT_EQ(refusal(with_size(file, 60000, 50000)),
            "a picture is not a readable picture: it has 60000 x 50000 pixels, which take "
            "24000000000 bytes, more than the limit of 8589934592, which "
            "GRADMESH_LIMITS=memory=24000000000 raises.");
  for (const auto& [width, height] : {std::pair{0u, 1u}, {1u, 0u}, {2000000u, 1u}})
    EXPECT_TRUE(refusal(with_size(file, width, height))
                    .starts_with("a picture is not a readable picture: "));
}

/// A folder of its own for each test, removed afterwards.
class PictureFolder : public testing::Test {
 protected:
  PictureFolder()
      : folder(fs::temp_directory_path() / ("gradmesh_pictures_" + std::to_string(::getpid()))) {
    fs::create_directories(folder);
  }
  ~PictureFolder() override { fs::remove_all(folder); }

  fs::path file(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder / name, std::ios::binary) << bytes;
    return folder / name;
  }
  static std::string why_not(const fs::path& path) {
    return complaint([&] { read_picture(path, whole); });
  }

  fs::path folder;
};

TEST_F(PictureFolder, what_a_file_is_counts_and_not_its_name) {
  const Bytes rgb = colorful(2, 2);
  const fs::path png = file("a.jpg", png_file({.width = 2, .height = 2, .samples = rgb}));
  EXPECT_EQ(interleaved(read_picture(png, whole).image), opaque(rgb));
  const fs::path jpeg = file("a.png", jpeg_file(plain({77})));
  EXPECT_EQ(interleaved(read_picture(jpeg, 1).image), (Bytes{77, 77, 77, 255}));
}

TEST_F(PictureFolder, failures_name_the_file) {
  const fs::path empty = file("empty.png", ""), text = file("text.png", "no picture"),
                 cut = file("cut.jpg", jpeg_file(plain({77})).substr(0, 200));
  EXPECT_EQ(why_not(empty), empty.string() + " is not a readable picture: it is empty.");
  EXPECT_TRUE(why_not(text).starts_with(text.string() + " is not a readable picture: "));
  EXPECT_EQ(why_not(cut), cut.string() + " is not a readable picture: it ends in the middle.");
  // Why is in the system's words.
  EXPECT_TRUE(why_not(folder).starts_with(folder.string() + " cannot be read: "));
  EXPECT_EQ(why_not(folder / "missing.png"),
            (folder / "missing.png").string() + " cannot be read: No such file or directory.");
}

TEST_F(PictureFolder, other_formats_are_read_where_openimageio_is) {
  const std::vector<std::uint16_t> held = {51400, 25700, 12850, 65535, 25700, 0,
                                           0,     32896, 0,     0,     0,     0};
  const fs::path upright_file = file("a.tif", test::tiff_file(held, false, 1, ""));
  if (why_not(upright_file).ends_with("neither PNG nor JPEG, which are all that can be read here."))
    GTEST_SKIP() << "A portable program reads PNG and JPEG alone.";
  EXPECT_EQ(interleaved(read_picture(upright_file, whole).image),
            (Bytes{200, 100, 50, 255, 100, 0, 0, 128, 0, 0, 0, 0}));
  const fs::path multiplied = file("b.tif", test::tiff_file(held, true, 3, ""));
  EXPECT_EQ(interleaved(read_picture(multiplied, whole).image),
            (Bytes{0, 0, 0, 0, 199, 0, 0, 128, 200, 100, 50, 255}));
  const fs::path swapped = file("c.tif", test::tiff_file(held, false, 6, test::swapped_profile()));
  const Picture read = read_picture(swapped, whole);
  EXPECT_EQ(read.full_width, 1);
  EXPECT_EQ(read.full_height, 3);
  EXPECT_LE(distance(interleaved(read.image), {100, 200, 50, 255, 0, 100, 0, 128, 0, 0, 0, 0}), 1);
  // The last four bytes would say where the next picture lies.
  const std::string whole_file = read_bytes(upright_file);
  for (std::size_t length = 1; length + 4 < whole_file.size(); length += 5) {
    const fs::path cut = file("cut.tif", whole_file.substr(0, length));
    const std::string why = why_not(cut);
    EXPECT_TRUE(why.starts_with(cut.string() + " is not a readable picture: ")) << length << why;
  }
}

}  // namespace
}  // namespace gradmesh
