#include "files/image_codec.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/limits.h"
#include "files/image_picture.h"

namespace gradmesh {
namespace {

std::string one_line(const std::string& message) { return message.substr(0, message.find('\n')); }

std::string read(const std::string& path, Image& image) {
  // OpenImageIO gives colour multiplied by alpha unless told otherwise.
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path, &config);
  if (!input) return one_line(OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  const int channels = spec.nchannels;
  const auto longer = std::uint64_t(std::max(spec.width, spec.height));
  if (const std::uint64_t most = limits().resolution; longer > most)
    return "it is " + std::to_string(longer) + " pixels long, " +
           beyond_limit("resolution", most, longer).english();
  image = Image(spec.width, spec.height);
  std::vector<std::uint8_t> samples(image.pixels() * std::size_t(channels));
  if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, samples.data()))
    return one_line(input->geterror());

  const bool is_grey = channels < 3;
  const int alpha_channel = is_grey ? (channels == 2 ? 1 : -1) : (channels > 3 ? 3 : -1);
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    const std::uint8_t* from = samples.data() + i * std::size_t(channels);
    const int alpha = alpha_channel < 0 ? 255 : from[alpha_channel];
    for (std::size_t k = 0; k < 3; ++k)
      image.samples[k * image.pixels() + i] = over_white(from[is_grey ? 0 : k], alpha);
  }
  return {};
}

}  // namespace
}  // namespace gradmesh

const gradmesh::ImageCodec gradmesh_image_codec{gradmesh::read, gradmesh::decode_with_openimageio};
