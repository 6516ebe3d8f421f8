#include "io/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "io/atomic_file.h"

namespace gradmesh {
namespace {

std::string one_line(const std::string& message) { return message.substr(0, message.find('\n')); }

/// Sample times alpha over white, rounded; both 0..255.
std::uint8_t over_white(int sample, int alpha) {
  return std::uint8_t((sample * alpha + 255 * (255 - alpha) + 127) / 255);
}

}  // namespace

Image read_image(const std::filesystem::path& path) {
  const std::string complaint = path.string() + " is not a readable image: ";
  // OpenImageIO gives colour multiplied by alpha unless told otherwise.
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path.string(), &config);
  if (!input) throw InputError(complaint + one_line(OIIO::geterror()) + ".");
  const OIIO::ImageSpec& spec = input->spec();
  const int channels = spec.nchannels;
  Image image(spec.width, spec.height);
  std::vector<std::uint8_t> samples(std::size_t(spec.width) * std::size_t(spec.height) *
                                    std::size_t(channels));
  if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, samples.data()))
    throw InputError(complaint + one_line(input->geterror()) + ".");

  const bool is_grey = channels < 3;
  const int alpha_channel = is_grey ? (channels == 2 ? 1 : -1) : (channels > 3 ? 3 : -1);
  const std::size_t pixels = std::size_t(spec.width) * std::size_t(spec.height);
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::uint8_t* from = samples.data() + i * std::size_t(channels);
    const int alpha = alpha_channel < 0 ? 255 : from[alpha_channel];
    for (std::size_t k = 0; k < 3; ++k)
      image.samples[k * pixels + i] = over_white(from[is_grey ? 0 : k], alpha);
  }
  return image;
}

std::string png_bytes(const Image& image) {
  if (image.width <= 0 || image.height <= 0) throw InputError("the image is empty.");
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create("png", &memory);
  if (!output) throw InputError(one_line(OIIO::geterror()) + ".");
  const OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
  if (!output->open("image.png", spec) ||
      !output->write_image(OIIO::TypeDesc::UINT8, interleaved(image).data()) || !output->close())
    throw InputError(one_line(output->geterror()) + ".");
  return {bytes.begin(), bytes.end()};
}

void write_png(const Image& image, const std::filesystem::path& path) {
  std::string bytes;
  try {
    bytes = png_bytes(image);
  } catch (const InputError& error) {
    throw InputError(path.string() + " cannot be written: " + error.what());
  }
  write_bytes(path, bytes);
}

}  // namespace gradmesh
