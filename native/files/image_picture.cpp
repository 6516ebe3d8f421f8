#include "files/image_picture.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <vector>

namespace gradmesh {
namespace {

/// Rows that are read at once, where the file has no tiles.
constexpr int band = 16;

/// Which of the file's channels are a picture's.
struct Channels {
  int all, colors, alpha;

  explicit Channels(const OIIO::ImageSpec& spec) : all(spec.nchannels), alpha(spec.alpha_channel) {
    colors = (alpha < 0 ? all : all - 1) >= 3 ? 3 : 1;
    if (alpha < colors || alpha >= all) alpha = -1;
  }
};

/// OpenImageIO's message in one line without its full stop.
Message what_it_says(const std::string& message) {
  std::string line = message.substr(0, message.find('\n'));
  while (!line.empty() && (line.back() == '.' || line.back() == '\r')) line.pop_back();
  if (line.empty()) return Message("it cannot be read");
  return Message("{0}", line);
}

/// What OpenImageIO asks back where it knows no such format is no part of a sentence.
Message why_not_open(const std::string& message) {
  if (message.find("find a format reader") != message.npos)
    return Message("its format is none that can be read here");
  return what_it_says(message);
}

PictureForm form_of(const OIIO::ImageSpec& spec, const Channels& channels) {
  PictureForm form;
  form.width = spec.width;
  form.height = spec.height;
  form.colors = channels.colors;
  form.bits = spec.format == OIIO::TypeDesc::UINT8 ? 8 : 16;
  if (const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile"))
    form.profile = {static_cast<const char*>(profile->data()), std::size_t(profile->datasize())};
  // So are formats that hold light itself.
  if (OIIO::Strutil::iequals(spec.get_string_attribute("oiio:ColorSpace"), "linear"))
    form.encoding.gamma = 1;
  return form;
}

/// Gives a row to the sink. Some files hold colours that are multiplied by the opacity.
void give_row(const std::uint16_t* from, int width, const Channels& channels, bool is_multiplied,
              std::vector<std::uint16_t>& row, PictureSink& sink) {
  std::uint16_t* to = row.data();
  for (int x = 0; x < width; ++x, from += channels.all) {
    const std::uint32_t alpha = channels.alpha < 0 ? 65535 : from[channels.alpha];
    for (int c = 0; c < channels.colors; ++c)
      *to++ = is_multiplied && alpha > 0
                  ? std::uint16_t(std::min<std::uint32_t>(
                        65535, (std::uint32_t(from[c]) * 65535u + alpha / 2) / alpha))
                  : from[c];
    *to++ = std::uint16_t(alpha);
  }
  sink.row(row.data());
}

/// Reads the rows from `top` to `bottom` of the file's window.
bool read_rows(OIIO::ImageInput& input, int top, int bottom, std::vector<std::uint16_t>& samples) {
  const OIIO::ImageSpec& spec = input.spec();
  const int y0 = spec.y + top, y1 = spec.y + bottom;
  const auto type = OIIO::TypeDesc::UINT16;
  if (spec.tile_width == 0)
    return input.read_scanlines(0, 0, y0, y1, spec.z, 0, spec.nchannels, type, samples.data());
  return input.read_tiles(0, 0, spec.x, spec.x + spec.width, y0, y1, spec.z, spec.z + 1, 0,
                          spec.nchannels, type, samples.data());
}

std::optional<Message> decode(const std::string& path, PictureSink& sink) {
  // OpenImageIO gives colour multiplied by alpha unless told otherwise.
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path, &config);
  if (!input) return why_not_open(OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  const Channels channels(spec);
  const bool is_multiplied =
      channels.alpha >= 0 && !spec.get_int_attribute("oiio:UnassociatedAlpha");
  sink.turn(spec.get_int_attribute("Orientation", 1));
  if (!sink.begin(form_of(spec, channels))) return {};

  const int rows = spec.tile_width > 0 ? spec.tile_height : band;
  const std::size_t across = std::size_t(spec.width) * std::size_t(channels.all);
  std::vector<std::uint16_t> samples(across * std::size_t(std::min(rows, spec.height)));
  std::vector<std::uint16_t> row(std::size_t(spec.width) * std::size_t(channels.colors + 1));
  for (int top = 0; top < spec.height; top += rows) {
    const int bottom = std::min(top + rows, spec.height);
    if (!read_rows(*input, top, bottom, samples)) return what_it_says(input->geterror());
    for (int y = 0; y < bottom - top; ++y)
      give_row(samples.data() + std::size_t(y) * across, spec.width, channels, is_multiplied, row,
               sink);
  }
  return {};
}

}  // namespace

std::optional<Message> decode_with_openimageio(const std::string& path, PictureSink& sink) {
  try {
    return decode(path, sink);
  } catch (const std::exception& error) {
    return what_it_says(error.what());
  }
}

}  // namespace gradmesh
