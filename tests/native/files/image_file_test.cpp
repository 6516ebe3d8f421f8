#include "files/image_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <functional>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/base64.h"

namespace gradmesh {
namespace {

namespace fs = std::filesystem;

class ImageFile : public testing::Test {
 protected:
  ImageFile()
      : folder(fs::temp_directory_path() / ("gradmesh_image_" + std::to_string(::getpid()))) {
    fs::create_directories(folder);
  }
  ~ImageFile() override { fs::remove_all(folder); }

  /// A PNG of one row with these 8-bit samples.
  fs::path write_row(int channels, const std::vector<std::uint8_t>& samples) const {
    const fs::path path = folder / "row.png";
    const auto output = OIIO::ImageOutput::create(path.string());
    OIIO::ImageSpec spec(int(samples.size()) / channels, 1, channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    EXPECT_TRUE(output->open(path.string(), spec));
    EXPECT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, samples.data()));
    EXPECT_TRUE(output->close());
    return path;
  }

  fs::path folder;
};

using Samples = std::vector<std::uint8_t>;

std::string complaint(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST_F(ImageFile, round_trip) {
  Image image(5, 3);
  for (std::size_t i = 0; i < image.samples.size(); ++i) image.samples[i] = std::uint8_t(i * 37);
  write_png(image, folder / "a.png");
  EXPECT_EQ(read_image(folder / "a.png"), image);
}

TEST_F(ImageFile, opacities_do_not_change_colors) {
  RgbaImage image(2, 1);
  image.set_pixel(0, 0, {200, 100, 50, 0});
  image.set_pixel(1, 0, {10, 20, 30, 128});
  write_bytes(folder / "a.png", png_bytes(image));
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open((folder / "a.png").string(), &config);
  ASSERT_TRUE(input);
  ASSERT_EQ(input->spec().nchannels, 4);
  Samples samples(8);
  ASSERT_TRUE(input->read_image(0, 0, 0, 4, OIIO::TypeDesc::UINT8, samples.data()));
  EXPECT_EQ(samples, (Samples{200, 100, 50, 0, 10, 20, 30, 128}));
}

TEST_F(ImageFile, other_channels_become_rgb) {
  EXPECT_EQ(interleaved(read_image(write_row(3, {1, 2, 3}))), (Samples{1, 2, 3}));
  EXPECT_EQ(interleaved(read_image(write_row(1, {7, 200}))), (Samples{7, 7, 7, 200, 200, 200}));
  EXPECT_EQ(
      interleaved(read_image(write_row(4, {10, 20, 30, 255, 10, 20, 30, 0, 0, 100, 255, 51}))),
      (Samples{10, 20, 30, 255, 255, 255, 204, 224, 255}));
  EXPECT_EQ(interleaved(read_image(write_row(2, {0, 51, 90, 255}))),
            (Samples{204, 204, 204, 90, 90, 90}));
}

TEST_F(ImageFile, failures_name_the_file) {
  const fs::path bad = folder / "bad.png", missing = folder / "missing.png";
  write_bytes(bad, "no image");
  EXPECT_TRUE(
      complaint([&] { read_image(bad); }).starts_with(bad.string() + " is not a readable image: "));
  EXPECT_TRUE(complaint([&] {
                read_image(missing);
              }).starts_with(missing.string() + " is not a readable image: "));
  const fs::path nowhere = folder / "missing" / "a.png";
  EXPECT_EQ(complaint([&] { write_png(Image(1, 1), nowhere); }),
            nowhere.string() + " cannot be written: No such file or directory.");
  EXPECT_EQ(complaint([&] { write_png(Image(), bad); }),
            bad.string() + " cannot be written: the image is empty.");
  EXPECT_EQ(read_bytes(bad), "no image");
}

TEST(Base64, gives_the_examples_of_the_standard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xfb\xff\xfe"), "+//+");
  for (const std::string bytes : {"", "f", "fo", "foo", "foobar", "\xfb\xff\xfe"})
    EXPECT_EQ(base64_bytes(base64(bytes)), bytes);
  for (const char* text : {"Zg=", "Zg", "Z===", "Zg==Zg==", "Zm9%", "Zm 9v"})
    EXPECT_EQ(base64_bytes(text), std::nullopt) << text;
}

}  // namespace
}  // namespace gradmesh
