#pragma once

#include <optional>
#include <vector>

#include "base/message.h"
#include "files/box_reducer.h"
#include "files/picture_file.h"
#include "files/picture_sink.h"
#include "files/to_srgb.h"

namespace gradmesh {

/// Makes a picture of what a decoder gives: in sRGB, reduced, upright.
class PictureReducer : public PictureSink {
 public:
  explicit PictureReducer(int longest) : longest_(longest) {}

  bool begin(const PictureForm& form) noexcept override;
  void row(const std::uint16_t* samples) noexcept override;
  void turn(int orientation) noexcept override { orientation_ = orientation; }

  /// Why the picture was refused, or is not whole, though the decoder knew of no error.
  std::optional<Message> wrong() const;
  /// Returns the picture, where nothing is wrong.
  Picture picture() const;

 private:
  void start(const PictureForm& form);

  int longest_, orientation_ = 1;
  std::optional<Message> refusal_;
  int width_ = 0, height_ = 0;
  ToSrgb to_srgb_;
  std::vector<std::uint16_t> rgba_;
  BoxReducer reducer_;
};

}  // namespace gradmesh
