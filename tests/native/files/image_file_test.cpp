#include "files/image_file.h"

#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <filesystem>
#include <iterator>

#include "complaint.h"
#include "files/atomic_file.h"
#include "files/base64.h"

namespace gradmesh {
namespace {

namespace fs = std::filesystem;

using test::complaint;
using Samples = std::vector<std::uint8_t>;

/// A folder of its own for each test, removed afterwards.
class Folder : public testing::Test {
 protected:
  Folder() : folder(fs::temp_directory_path() / ("gradmesh_files_" + std::to_string(::getpid()))) {
    fs::create_directories(folder);
  }
  ~Folder() override { fs::remove_all(folder); }

  std::ptrdiff_t entries() const {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  }
  /// The samples of a PNG file of one row, in base64 without the beginning, which all have.
  Samples read(const std::string& png) const {
    write_bytes(folder / "row.png", *base64_bytes("iVBORw0KGgoAAAANSUhEUgAAAA" + png));
    return interleaved(read_image(folder / "row.png"));
  }

  fs::path folder;
};
class ImageFile : public Folder {};
class AtomicFile : public Folder {};

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
  const std::string bytes = png_bytes(image);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()));
  ASSERT_EQ(png.format, png_uint_32(PNG_FORMAT_RGBA));
  Samples samples(8);
  ASSERT_TRUE(png_image_finish_read(&png, nullptr, samples.data(), 0, nullptr));
  EXPECT_EQ(samples, (Samples{200, 100, 50, 0, 10, 20, 30, 128}));
}

TEST_F(ImageFile, other_channels_become_rgb) {
  // 1, 2, 3 in red, green and blue
  EXPECT_EQ(read("EAAAABCAIAAACQd1PeAAAADElEQVR42mNgZGIGAAAOAAfpkjfUAAAAAElFTkSuQmCC"),
            (Samples{1, 2, 3}));
  // 7 and 200 in grey
  EXPECT_EQ(read("IAAAABCAAAAADRSSBWAAAAC0lEQVR42mNgPwEAANkA0EQCVdsAAAAASUVORK5CYII="),
            (Samples{7, 7, 7, 200, 200, 200}));
  // 10, 20, 30, opaque and transparent; 0, 100, 255 with an alpha of 51
  EXPECT_EQ(read("MAAAABCAYAAAAb4BS0AAAAE0lEQVR42mPgEpH7D8QMDCn/jQEQcQMOQqTKsAAAAABJRU5ErkJggg=="),
            (Samples{10, 20, 30, 255, 255, 255, 204, 224, 255}));
  // 0 in grey with an alpha of 51, opaque 90
  EXPECT_EQ(read("IAAAABCAQAAABeK7cBAAAADUlEQVR42mNgMI76DwACUQGNGOcKfwAAAABJRU5ErkJggg=="),
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

TEST_F(AtomicFile, is_written_as_a_whole_or_not_at_all) {
  const fs::path path = folder / "drawing.svg", nowhere = folder / "missing" / "drawing.svg";
  for (const std::string bytes : {"before", "after"}) {
    write_bytes(path, bytes);
    EXPECT_EQ(read_bytes(path), bytes);
    EXPECT_EQ(entries(), 1);
  }
  EXPECT_EQ(complaint([&] { write_bytes(nowhere, "a"); }),
            nowhere.string() + " cannot be written: No such file or directory.");
  EXPECT_EQ(complaint([&] { write_bytes(folder, "a"); }),
            folder.string() + " cannot be written: it is not a regular file.");
  EXPECT_EQ(complaint([&] { read_bytes(nowhere); }),
            nowhere.string() + " cannot be read: No such file or directory.");
  // Why is in the system's words.
  EXPECT_TRUE(
      complaint([&] { read_bytes(folder); }).starts_with(folder.string() + " cannot be read: "));
  EXPECT_EQ(entries(), 1);
}

TEST_F(AtomicFile, keeps_permissions_and_links) {
#ifdef _WIN32
  GTEST_SKIP() << "There are no such permissions, and not everybody may make links.";
#endif
  const fs::path path = folder / "drawing.svg", link = folder / "link.svg";
  write_bytes(path, "before");
  constexpr fs::perms some = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read;
  fs::permissions(path, some);
  fs::create_symlink(path, link);
  write_bytes(link, "after");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(read_bytes(path), "after");
  EXPECT_EQ(fs::status(path).permissions(), some);
  EXPECT_EQ(entries(), 2);
}

}  // namespace
}  // namespace gradmesh
