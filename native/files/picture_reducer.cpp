#include "files/picture_reducer.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "base/limits.h"
#include "files/orientation.h"

namespace gradmesh {
namespace {

/// What a pixel takes while it is decoded, where a decoder has to hold them all: those of
/// interlaced and of progressive files.
constexpr std::uint64_t pixel_bytes = 8;

/// Why a picture of this size is refused, whatever the decoder: one that is read row by row takes
/// little memory, but the time of as many pixels.
std::optional<Message> too_large(const PictureForm& form) {
  const std::uint64_t most = limits().memory;
  const std::uint64_t pixels = std::uint64_t(form.width) * std::uint64_t(form.height);
  if (pixels <= most / pixel_bytes) return {};
  constexpr std::uint64_t countable = std::numeric_limits<std::uint64_t>::max() / pixel_bytes;
  const std::uint64_t bytes = std::min(pixels, countable) * pixel_bytes;
  return Message("it has {0} x {1} pixels, which take {2} bytes, {3}", form.width, form.height,
                 bytes, beyond_limit("memory", most, bytes));
}

}  // namespace

bool PictureReducer::begin(const PictureForm& form) noexcept {
  try {
    if (form.width < 1 || form.height < 1)
      refusal_ = Message("it has no pixels");
    else
      refusal_ = too_large(form);
    if (!refusal_) start(form);
  } catch (const std::exception&) {
    // There is no other reason to throw: bad_alloc, or length_error for what no memory holds.
    refusal_ = Message("there is not enough memory");
  }
  return !refusal_;
}

void PictureReducer::start(const PictureForm& form) {
  width_ = form.width, height_ = form.height;
  to_srgb_ = ToSrgb(form);
  if (!to_srgb_.is_possible())
    refusal_ = Message("its colours are CMYK, and it has no colour profile that says which");
  rgba_.resize(4 * std::size_t(width_));
  reducer_ = BoxReducer(width_, height_, longest_);
}

void PictureReducer::row(const std::uint16_t* samples) noexcept {
  to_srgb_.convert(samples, rgba_.data());
  reducer_.add_row(rgba_.data());
}

std::optional<Message> PictureReducer::wrong() const {
  if (refusal_) return refusal_;
  if (width_ == 0) return Message("it has no pixels");
  if (!reducer_.is_whole()) return Message("it ends in the middle");
  return {};
}

Picture PictureReducer::picture() const {
  const bool turns = lies_on_its_side(orientation_);
  Picture picture;
  picture.image = upright(reducer_.image(), orientation_);
  picture.full_width = turns ? height_ : width_;
  picture.full_height = turns ? width_ : height_;
  return picture;
}

}  // namespace gradmesh
