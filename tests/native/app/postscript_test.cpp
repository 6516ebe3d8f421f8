// PostScript, read as the PDF that Ghostscript makes of it. Most of it by another program in the
// place of Ghostscript, as that is not everywhere.
#include "app/pages/postscript.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "app/document/svg_document.h"
#include "app/document/write_file.h"
#include "app/export/info.h"
#include "app/pages/page_documents.h"
#include "app/pages/read_document.h"
#include "complaint.h"
#include "files/atomic_file.h"
#include "files/run_program.h"
#include "files/temporary_folder.h"
#include "mesh/rectangle.h"
#include "pdf_shadings.h"

using namespace gradmesh;
using test::complaint;

namespace {

namespace fs = std::filesystem;

constexpr const char* program_variable = "GRADMESH_GHOSTSCRIPT";
constexpr const char* text = "%!PS-Adobe-3.0 EPSF-3.0\nshowpage\n";

/// A variable of the environment that is another one for some time.
class Setting {
 public:
  Setting(const char* name, const std::string& value) : name_(name) {
    if (const char* const before = std::getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~Setting() {
    if (before_)
      setenv(name_, before_->c_str(), 1);
    else
      unsetenv(name_);
  }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

/// A program in the place of Ghostscript, and a folder for temporary files in which nothing else
/// is.
class PostScript : public testing::Test {
 protected:
  PostScript() { fs::create_directory(scratch()); }

  fs::path scratch() const { return folder_.path() / "scratch"; }
  fs::path at(const char* name) const { return folder_.path() / name; }

  /// `ending` is what the program does after it has noted its arguments and kept what it was to
  /// read.
  void let_program_be(const std::string& ending) {
    const fs::path program = at("program");
    std::ofstream(program) << "#!/bin/sh\ncd '" << folder_.path().string()
                           << "'\nprintf '%s\\n' \"$@\" > arguments\n"
                              "for a; do case $a in -sOutputFile=*) to=${a#*=};; esac; from=$a; "
                              "done\ncp \"$from\" given\ntouch \"$TMPDIR/unfinished\"\n"
                           << ending << "\n";
    fs::permissions(program, fs::perms::owner_all);
    program_.emplace(program_variable, program.string());
  }

  /// A program that makes this document of everything.
  void let_program_make(const std::string& pdf) {
    write_bytes(at("made.pdf"), pdf);
    let_program_be("cp made.pdf \"$to\"");
  }

  std::vector<std::string> arguments() const {
    std::istringstream lines(read_bytes(at("arguments")));
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) all.push_back(line);
    return all;
  }

  void expect_nothing_left() const { EXPECT_TRUE(fs::is_empty(scratch())); }

 private:
  const TemporaryFolder folder_;
  const Setting temporary_{"TMPDIR", scratch().string()};
  std::optional<Setting> program_;
};

std::string page_with_square() {
  return pdf_document("/MediaBox [0 0 150 75] /Resources << /Shading << /sh 5 0 R >> >>", "/sh sh",
                      {square_shading()});
}

TEST_F(PostScript, is_read_as_the_pdf_that_is_made_of_it) {
  let_program_make(page_with_square());
  const auto document = parse_document(text, "-odd name.eps");
  ASSERT_EQ(document->meshes().size(), 1U);
  EXPECT_EQ(document->meshes()[0].id, "page-1-mesh-1");
  EXPECT_EQ(document->format().name, "svg");
  EXPECT_EQ(info_json(*document).at("kind"), "postscript");
  EXPECT_EQ(info_json(*parse_document(page_with_square(), "a.pdf")).at("kind"), "pdf");
  expect_nothing_left();
}

TEST_F(PostScript, is_given_to_the_program_by_a_name_of_our_own) {
  let_program_make("made");
  EXPECT_EQ(pdf_of_postscript(text, "-odd name.eps"), "made");
  const auto given = arguments();
  ASSERT_EQ(given.size(), 8U);
  EXPECT_EQ(std::vector(given.begin(), given.end() - 2),
            (std::vector<std::string>{"-q", "-dSAFER", "-dBATCH", "-dNOPAUSE", "-sDEVICE=pdfwrite",
                                      "-dEPSCrop"}));
  EXPECT_TRUE(given[6].starts_with("-sOutputFile=" + scratch().string() + "/")) << given[6];
  EXPECT_TRUE(given[7].starts_with(scratch().string() + "/")) << given[7];
  EXPECT_TRUE(given[7].ends_with("/in.ps")) << given[7];
  EXPECT_EQ(read_bytes(at("given")), text);
  expect_nothing_left();
}

TEST_F(PostScript, is_found_in_the_header_of_dos) {
  let_program_make("made");
  std::string header(32, '-');
  header.replace(0, 12, std::string("\xC5\xD0\xD3\xC6\x20\0\0\0\x21\0\0\0", 12));
  const std::string program(text);
  ASSERT_EQ(program.size(), 0x21U);
  EXPECT_TRUE(is_postscript(header));
  EXPECT_EQ(pdf_of_postscript(header + program + "a preview", "a.eps"), "made");
  EXPECT_EQ(read_bytes(at("given")), program);
  // A file that was cut off gives what there is of it.
  for (const std::size_t size : {4U, 12U, 32U, 40U}) {
    pdf_of_postscript((header + program).substr(0, size), "a.eps");
    EXPECT_EQ(read_bytes(at("given")), program.substr(0, size < 32 ? 0 : size - 32));
  }
}

TEST_F(PostScript, is_known_by_its_content) {
  for (const char* other : {"", "%!P", "<svg/>", "%PDF-1.7", "\xC5\xD0\xD3"})
    EXPECT_FALSE(is_postscript(other)) << other;
  EXPECT_TRUE(is_postscript("%!PS"));
  // What is for printers, and what editors leave.
  for (const char* before : {"\n", "\r\n \n", "\xEF\xBB\xBF", "\x04", "\xEF\xBB\xBF\n",
                             "\x1B%-12345X@PJL JOB\n@PJL ENTER LANGUAGE = POSTSCRIPT\n\x04"})
    EXPECT_TRUE(is_postscript(before + std::string("%!PS-Adobe-3.0"))) << before;
  for (const char* other : {"\n", "a%!PS", "@PJL %!PS", "\x1B%!PS", "\n<svg>%!PS</svg>"})
    EXPECT_FALSE(is_postscript(other)) << other;
}

TEST_F(PostScript, that_cannot_be_read_is_told) {
  let_program_be("exit 3");
  EXPECT_EQ(complaint([] { parse_document(text, "a.ps"); }), "a.ps: Ghostscript cannot read it.");
  // A document of which there is a part only, and none.
  let_program_be("echo part > \"$to\"; kill -9 $$");
  EXPECT_EQ(complaint([] { parse_document(text, "a.ps"); }), "a.ps: Ghostscript cannot read it.");
  let_program_be("exit 0");
  EXPECT_EQ(complaint([] { parse_document(text, "a.ps"); }), "a.ps: Ghostscript cannot read it.");
  expect_nothing_left();
}

TEST_F(PostScript, that_does_not_end_is_told) {
  let_program_be("exec sleep 600");
  const auto before = std::chrono::steady_clock::now();
  EXPECT_EQ(complaint([] { pdf_of_postscript(text, "a.ps", std::chrono::milliseconds(300)); }),
            "a.ps: Ghostscript takes too long to read it.");
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(60));
  expect_nothing_left();
}

TEST_F(PostScript, needs_a_program) {
  const Setting none(program_variable, at("nothing").string());
  EXPECT_EQ(complaint([] { parse_document(text, "a.ps"); }),
            "a.ps: PostScript is read where Ghostscript is installed (the program gs).");
  expect_nothing_left();
}

TEST_F(PostScript, is_not_written) {
  let_program_make(page_with_square());
  const auto document = parse_document(text, "a.eps");
  for (const char* name : {"b.eps", "b.ps", "B.EPS"})
    EXPECT_EQ(complaint([&] { check_target(*document, name); }),
              std::string(name) +
                  ": such documents are only read; write an SVG document or a .hemesh file.");
}

/// Ghostscript itself, on drawings that Inkscape has exported both as EPS and as PDF.
class Ghostscript : public testing::TestWithParam<const char*> {};

TEST_P(Ghostscript, keeps_the_meshes) {
  const std::string name = std::string(GRADMESH_SHARED_DIR "/pdf/inkscape/") + GetParam();
  if (!fs::exists(name + ".eps")) GTEST_SKIP() << "the documents of ../shared/pdf are not here";
  const TemporaryFolder folder;
  if (run_program({"gs", "--version"}, folder.path(), std::chrono::seconds(20)) != ProgramEnd::done)
    GTEST_SKIP() << "Ghostscript is not installed";
  const Setting own(program_variable, "gs");
  const auto eps = read_document(name + ".eps"), pdf = read_document(name + ".pdf");
  ASSERT_EQ(eps->meshes().size(), pdf->meshes().size());
  for (std::size_t n = 0; n < pdf->meshes().size(); ++n) {
    const FoundMesh &a = eps->pages()->meshes.at(n), &b = pdf->pages()->meshes.at(n);
    EXPECT_EQ(std::pair(a.rows, a.columns), std::pair(b.rows, b.columns));
    const Mesh one = eps->mesh(eps->meshes()[n]), other = pdf->mesh(pdf->meshes()[n]);
    ASSERT_EQ(std::ranges::distance(one.points()), std::ranges::distance(other.points()));
    // EPS is cropped to whole points of its own.
    const Point first = *one.points().begin();
    const glm::dvec2 moved = one[first].position - other[first].position;
    // Ghostscript writes steps of 1/512 point, and pixels are 3/4 of a point.
    for (const Point p : one.points()) {
      const glm::dvec2 off = glm::abs(one[p].position - other[p].position - moved);
      EXPECT_LE(std::max(off.x, off.y), 1 / 384.0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Ghostscript, testing::Values("fruit", "tensor"));

}  // namespace
