#include "files/jpeg_picture.h"

#include <cstdio>  // of which libjpeg's header takes FILE

#include <jpeglib.h>

#include <jerror.h>

#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <string>
#include <vector>

#include "files/orientation.h"

namespace gradmesh {
namespace {

using namespace std::string_view_literals;

constexpr int exif_marker = JPEG_APP0 + 1, profile_marker = JPEG_APP0 + 2;
/// Programs write a dozen; each of them, however short, takes the time of the whole picture.
constexpr int most_scans = 100;

/// A JPEG file while it is read. What libjpeg's jumps would leave behind lies here, or in libjpeg.
struct JpegFile {
  PictureSink& sink;
  std::optional<Message> wrong = {};
  PictureForm form = {};
  std::vector<JSAMPLE> samples = {};
  std::vector<std::uint16_t> wide = {};
  JOCTET* profile = nullptr;
  jpeg_decompress_struct jpeg = {};
  jpeg_error_mgr errors = {};
  jpeg_progress_mgr progress = {};
  std::jmp_buf back = {};

  explicit JpegFile(PictureSink& to) : sink(to) {}
  JpegFile(const JpegFile&) = delete;
  JpegFile& operator=(const JpegFile&) = delete;
  ~JpegFile() {
    jpeg_destroy_decompress(&jpeg);
    std::free(profile);
  }
};

JpegFile& file_of(j_common_ptr jpeg) { return *static_cast<JpegFile*>(jpeg->client_data); }

void say_what_is_wrong(j_common_ptr jpeg) {
  char message[JMSG_LENGTH_MAX];
  jpeg->err->format_message(jpeg, message);
  file_of(jpeg).wrong = Message("{0}", std::string(message));
}

[[noreturn]] void fail_jpeg(j_common_ptr jpeg) {
  say_what_is_wrong(jpeg);
  std::longjmp(file_of(jpeg).back, 1);
}

/// libjpeg only warns where a part of the picture is lost, and paints something there.
void heed(j_common_ptr jpeg, int level) {
  if (level >= 0) return;
  switch (jpeg->err->msg_code) {
    case JWRN_JPEG_EOF:
      file_of(jpeg).wrong = Message("it ends in the middle");
      std::longjmp(file_of(jpeg).back, 1);
    case JWRN_ARITH_BAD_CODE:
    case JWRN_HIT_MARKER:
    case JWRN_HUFF_BAD_CODE:
    case JWRN_MUST_RESYNC:
    case JWRN_NOT_SEQUENTIAL:
      fail_jpeg(jpeg);
    default:
      break;
  }
}

void count_scans(j_common_ptr jpeg) {
  JpegFile& file = file_of(jpeg);
  if (file.jpeg.input_scan_number <= most_scans) return;
  file.wrong = Message("it has more than {0} scans", most_scans);
  std::longjmp(file.back, 1);
}

void tell_orientation(JpegFile& file) {
  for (jpeg_saved_marker_ptr m = file.jpeg.marker_list; m; m = m->next) {
    const std::string_view data(reinterpret_cast<const char*>(m->data), m->data_length);
    if (m->marker != exif_marker || !data.starts_with("Exif\0"sv)) continue;
    file.sink.turn(exif_orientation(data));
    return;
  }
}

void describe(JpegFile& file) {
  jpeg_decompress_struct& jpeg = file.jpeg;
  const bool is_cmyk = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
  const bool is_grey = jpeg.jpeg_color_space == JCS_GRAYSCALE;
  jpeg.out_color_space = is_cmyk ? JCS_CMYK : is_grey ? JCS_GRAYSCALE : JCS_RGB;
  file.form.width = int(jpeg.image_width);
  file.form.height = int(jpeg.image_height);
  file.form.colors = is_cmyk ? 4 : is_grey ? 1 : 3;
  unsigned int size = 0;
  if (jpeg_read_icc_profile(&jpeg, &file.profile, &size))
    file.form.profile = {reinterpret_cast<const char*>(file.profile), size};
}

/// Gives the row that was read to the sink. Adobe's programs write how much ink is missing.
void give_row(JpegFile& file) {
  const std::size_t colors = std::size_t(file.form.colors), width = file.jpeg.image_width;
  const int flip = colors == 4 && file.jpeg.saw_Adobe_marker ? 255 : 0;
  const JSAMPLE* from = file.samples.data();
  std::uint16_t* to = file.wide.data();
  for (std::size_t x = 0; x < width; ++x) {
    for (std::size_t c = 0; c < colors; ++c) *to++ = std::uint16_t((*from++ ^ flip) * 257);
    *to++ = 65535;
  }
  file.sink.row(file.wide.data());
}

/// Reads the file. Returns early after an error, to which libjpeg jumps: so nothing here has a
/// destructor.
void read_file(JpegFile& file, std::string_view bytes) {
  jpeg_decompress_struct& jpeg = file.jpeg;
  if (setjmp(file.back)) return;
  jpeg_create_decompress(&jpeg);
  jpeg.progress = &file.progress;
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()),
               static_cast<unsigned long>(bytes.size()));
  jpeg_save_markers(&jpeg, exif_marker, 0xffff);
  jpeg_save_markers(&jpeg, profile_marker, 0xffff);
  jpeg_read_header(&jpeg, TRUE);
  describe(file);
  tell_orientation(file);
  // Before libjpeg takes memory for the whole of a progressive picture.
  if (!file.sink.begin(file.form)) return;
  file.samples.resize(std::size_t(jpeg.image_width) * std::size_t(file.form.colors));
  file.wide.resize(file.samples.size() + jpeg.image_width);
  jpeg_start_decompress(&jpeg);
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW row = file.samples.data();
    jpeg_read_scanlines(&jpeg, &row, 1);
    give_row(file);
  }
  jpeg_finish_decompress(&jpeg);
}

}  // namespace

bool is_jpeg(std::string_view bytes) { return bytes.starts_with("\xff\xd8\xff"); }

std::optional<Message> decode_jpeg(std::string_view bytes, PictureSink& sink) {
  JpegFile file(sink);
  file.jpeg.err = jpeg_std_error(&file.errors);
  file.jpeg.client_data = &file;
  file.errors.error_exit = fail_jpeg;
  file.errors.emit_message = heed;
  file.progress.progress_monitor = count_scans;
  read_file(file, bytes);
  return file.wrong;
}

}  // namespace gradmesh
