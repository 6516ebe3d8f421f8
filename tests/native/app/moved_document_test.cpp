// Documents that are written into another folder show the pictures that they showed.
#include <gtest/gtest.h>

#include <filesystem>

#include "app/document/document.h"
#include "app/document/write_file.h"
#include "app/pages/read_document.h"
#include "files/atomic_file.h"
#include "files/temporary_folder.h"
#include "files/zip.h"

using namespace gradmesh;
namespace fs = std::filesystem;

namespace {

const std::string linked =
    "<svg xmlns='http://www.w3.org/2000/svg'  width='9' height='9'><image "
    "href='photo.png'/></svg>\n";

class MovedDocument : public testing::Test {
 protected:
  MovedDocument() {
    fs::create_directories(home());
    fs::create_directories(other());
    write_bytes(home() / "drawing.svg", linked);
  }

  fs::path home() const { return folder_.path() / "home"; }
  fs::path other() const { return folder_.path() / "other" / "place"; }
  std::unique_ptr<Document> document() const { return read_document(home() / "drawing.svg"); }

  static bool has(const fs::path& file, std::string_view text) {
    return read_bytes(file).find(text) != std::string::npos;
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace

TEST_F(MovedDocument, stays_as_it_is_in_its_folder) {
  write_file(*document(), home() / "copy.svg");
  EXPECT_EQ(read_bytes(home() / "copy.svg"), linked);
  write_file(*document(), home() / ".." / "home" / "copy.svg");
  EXPECT_EQ(read_bytes(home() / "copy.svg"), linked);
}

TEST_F(MovedDocument, is_right_in_each_folder_it_is_written_to) {
  const auto written = document();
  write_file(*written, other() / "copy.svg");
  write_file(*written, other().parent_path() / "copy.svg");
  write_file(*written, home() / "copy.svg");
  EXPECT_TRUE(has(other() / "copy.svg", "\"../../home/photo.png\""));
  EXPECT_TRUE(has(other().parent_path() / "copy.svg", "\"../home/photo.png\""));
  EXPECT_EQ(read_bytes(home() / "copy.svg"), linked);
  EXPECT_EQ(written->bytes(), linked);
}

TEST_F(MovedDocument, comes_back_to_the_same_picture) {
  write_file(*document(), other() / "copy.svg");
  write_file(*read_document(other() / "copy.svg"), home() / "back.svg");
  EXPECT_TRUE(has(home() / "back.svg", "\"photo.png\""));
}

TEST_F(MovedDocument, is_compressed_as_well) {
  write_bytes(home() / "packed.svgz", gzip(linked));
  write_file(*read_document(home() / "packed.svgz"), other() / "copy.svgz");
  const auto text = gunzip(read_bytes(other() / "copy.svgz"));
  ASSERT_TRUE(text);
  EXPECT_NE(text->find("../../home/photo.png"), text->npos);
}

TEST_F(MovedDocument, without_links_has_the_same_bytes) {
  const std::string bare =
      "<svg xmlns='http://www.w3.org/2000/svg'  width='9'><g fill='url(#a)'/></svg>\n";
  write_bytes(home() / "bare.svg", bare);
  write_file(*read_document(home() / "bare.svg"), other() / "bare.svg");
  EXPECT_EQ(read_bytes(other() / "bare.svg"), bare);
}

// Such as Inkscape's copies of a document, whose links begin in the folder of the document.
TEST_F(MovedDocument, whose_folder_is_not_known_stays_as_it_is) {
  write_file(*parse_document(linked, "drawing.svg"), other() / "copy.svg");
  EXPECT_EQ(read_bytes(other() / "copy.svg"), linked);
  const auto looking = document();
  looking->file().look_in({other()});
  write_file(*looking, other() / "looking.svg");
  EXPECT_EQ(read_bytes(other() / "looking.svg"), linked);
}

TEST_F(MovedDocument, comes_from_the_folder_that_a_link_stands_for) {
#ifdef _WIN32
  GTEST_SKIP() << "links to folders need rights there";
#else
  const fs::path link = other() / "link";
  fs::create_directory_symlink(home(), link);
  EXPECT_FALSE(folder_move(link / "drawing.svg", home() / "copy.svg"));
  write_file(*read_document(link / "drawing.svg"), other() / "copy.svg");
  EXPECT_TRUE(has(other() / "copy.svg", "\"../../home/photo.png\""));
#endif
}

#ifdef __linux__
TEST_F(MovedDocument, from_or_to_a_stream_has_no_folder) {
  for (const char* stream : {"/dev/stdin", "/dev/null", "/dev/fd/0", "/proc/self/exe"}) {
    EXPECT_FALSE(folder_move(stream, home() / "copy.svg")) << stream;
    EXPECT_FALSE(folder_move(home() / "drawing.svg", stream)) << stream;
  }
  EXPECT_TRUE(folder_move(home() / "drawing.svg", other() / "copy.svg"));
}
#endif
