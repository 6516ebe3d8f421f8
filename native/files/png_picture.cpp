#include "files/png_picture.h"

#include <png.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "files/orientation.h"

namespace gradmesh {
namespace {

/// More than the longest rows and the largest profiles take.
constexpr std::size_t enough_memory = std::size_t(64) << 20;

/// A PNG file while it is read. What libpng's jumps would leave behind lies here, or in libpng.
struct PngFile {
  std::string_view rest;
  PictureSink& sink;
  std::optional<Message> wrong = {};
  PictureForm form = {};
  std::vector<std::uint16_t> samples = {};
  png_structp png = nullptr;
  png_infop info = nullptr;
  const std::size_t most_memory;

  PngFile(std::string_view bytes, PictureSink& to)
      : rest(bytes), sink(to), most_memory(std::max(bytes.size(), enough_memory)) {}
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;
  ~PngFile() { png_destroy_read_struct(&png, &info, nullptr); }
};

void fail_png(png_structp png, const char* message) {
  auto& file = *static_cast<PngFile*>(png_get_error_ptr(png));
  if (!file.wrong) file.wrong = Message("{0}", std::string(message));
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, const char*) {}

/// Memory for libpng, which asks for as many bytes as a chunk says that it has, before they are
/// there. Without memory it leaves the chunk out.
png_voidp allocate(png_structp png, png_alloc_size_t size) {
  const auto& file = *static_cast<const PngFile*>(png_get_mem_ptr(png));
  return size <= file.most_memory ? std::malloc(size) : nullptr;
}

void free_memory(png_structp, png_voidp memory) { std::free(memory); }

void give_bytes(png_structp png, png_bytep to, std::size_t count) {
  auto& file = *static_cast<PngFile*>(png_get_io_ptr(png));
  if (count > file.rest.size()) {
    file.wrong = Message("it ends in the middle");
    png_error(png, "");
  }
  std::copy_n(file.rest.data(), count, to);
  file.rest.remove_prefix(count);
}

/// Tells how samples become colours, where the file says so without a profile. What claims to be
/// sRGB is that.
void describe_encoding(png_structp png, png_infop info, PictureEncoding& encoding) {
  int intent;
  if (png_get_sRGB(png, info, &intent)) return;
  double gamma;
  if (png_get_gAMA(png, info, &gamma) && gamma > 0) encoding.gamma = 1 / gamma;
  auto& [ignored, white, red, green, blue] = encoding;
  png_get_cHRM(png, info, &white.x, &white.y, &red.x, &red.y, &green.x, &green.y, &blue.x, &blue.y);
}

void describe(png_structp png, png_infop info, PictureForm& form) {
  form.width = int(png_get_image_width(png, info));
  form.height = int(png_get_image_height(png, info));
  form.colors = png_get_color_type(png, info) & PNG_COLOR_MASK_COLOR ? 3 : 1;
  form.bits = png_get_bit_depth(png, info) == 16 ? 16 : 8;
  png_charp name;
  int compression;
  png_bytep profile;
  png_uint_32 size;
  if (png_get_iCCP(png, info, &name, &compression, &profile, &size))
    form.profile = {reinterpret_cast<const char*>(profile), size};
  else
    describe_encoding(png, info, form.encoding);
}

/// The file may say how it is turned before the samples or after them.
void tell_orientation(png_structp png, png_infop info, PictureSink& sink) {
  png_uint_32 size;
  png_bytep exif;
  if (png_get_eXIf_1(png, info, &size, &exif))
    sink.turn(exif_orientation({reinterpret_cast<const char*>(exif), size}));
}

/// Asks for grey or RGB with an opacity, in 16 bits of this machine's order.
void ask_for_16_bits(png_structp png) {
  png_set_expand(png);
  png_set_expand_16(png);
  png_set_add_alpha(png, 0xffff, PNG_FILLER_AFTER);
  if constexpr (std::endian::native == std::endian::little) png_set_swap(png);
}

/// Reads the file. Returns early after an error, to which libpng jumps: so nothing here has a
/// destructor.
void read_file(PngFile& file) {
  png_structp png = file.png;
  png_infop info = file.info;
  if (setjmp(png_jmpbuf(png))) return;
  png_read_info(png, info);
  describe(png, info, file.form);
  if (!file.sink.begin(file.form)) return;
  ask_for_16_bits(png);
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  // An interlaced picture is complete after its last pass only.
  const std::size_t row = png_get_rowbytes(png, info) / sizeof(std::uint16_t);
  const std::size_t step = passes > 1 ? row : 0, height = std::size_t(file.form.height);
  file.samples.resize(row + step * (height - 1));
  for (int pass = 1; pass <= passes; ++pass)
    for (std::size_t y = 0; y < height; ++y) {
      std::uint16_t* const samples = file.samples.data() + y * step;
      png_read_row(png, reinterpret_cast<png_bytep>(samples), nullptr);
      if (pass == passes) file.sink.row(samples);
    }
  png_read_end(png, info);
  tell_orientation(png, info, file.sink);
}

}  // namespace

bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n\x1a\n"); }

std::optional<Message> decode_png(std::string_view bytes, PictureSink& sink) {
  PngFile file(bytes, sink);
  file.png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &file, fail_png, ignore_warning, &file,
                                      allocate, free_memory);
  if (!file.png) throw std::bad_alloc();
  file.info = png_create_info_struct(file.png);
  if (!file.info) throw std::bad_alloc();
  png_set_read_fn(file.png, &file, give_bytes);
  read_file(file);
  return file.wrong;
}

}  // namespace gradmesh
