#include "window/eye/session_texture.h"

namespace gradmesh {

const Texture& SessionTexture::of(const Session& session, const SessionView& view, int revision) {
  if (session_ == &session && revision_ == revision && view_ == view) return texture_;
  const Image image = paint(session, view);
  pixels_.resize(image.pixels());
  const std::uint8_t* const red = image.at(0, 0, 0);
  const std::uint8_t* const green = image.at(0, 0, 1);
  const std::uint8_t* const blue = image.at(0, 0, 2);
  for (std::size_t i = 0; i < pixels_.size(); ++i)
    pixels_[i] = std::uint32_t(red[i] << 16 | green[i] << 8 | blue[i]);
  texture_ = {image.width, image.height, nullptr, pixels_.data()};
  session_ = &session;
  revision_ = revision;
  view_ = view;
  return texture_;
}

}  // namespace gradmesh
