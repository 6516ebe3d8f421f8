#include "files/box_reducer.h"

#include <algorithm>
#include <cmath>

namespace gradmesh {
namespace {

/// The length of a side where the longer one becomes `longest`, rounded.
int reduced(int side, int longer, int longest) {
  if (longer <= longest) return side;
  return int(std::max<std::int64_t>(
      1, (2 * std::int64_t(side) * longest + longer) / (2 * std::int64_t(longer))));
}

std::uint8_t to_8_bits(double sample) { return std::uint8_t(std::lround(sample / 257)); }

}  // namespace

BoxReducer::BoxReducer(int width, int height, int longest)
    : width_(width),
      height_(height),
      image_(reduced(width, std::max(width, height), longest),
             reduced(height, std::max(width, height), longest)),
      row_(4 * std::size_t(image_.width)),
      total_(4 * std::size_t(image_.width)) {}

void BoxReducer::add_row(const std::uint16_t* rgba) {
  if (is_whole()) return;
  sum_up(rgba);
  // In units of which a row of the picture has as many as the result has rows, a row of the result
  // has as many as the picture has rows: so all shares are whole numbers. The same holds across.
  const std::int64_t top = std::int64_t(rows_) * image_.height, bottom = top + image_.height;
  const std::int64_t y = top / height_, edge = (y + 1) * height_;
  const auto above = double(std::min(bottom, edge) - top), below = double(bottom - edge);
  for (std::size_t i = 0; i < total_.size(); ++i) total_[i] += above * row_[i];
  ++rows_;
  if (below < 0) return;
  finish_row(int(y));
  for (std::size_t i = 0; i < total_.size(); ++i) total_[i] = below * row_[i];
}

/// Sets row_ to the sums of a row of the picture.
void BoxReducer::sum_up(const std::uint16_t* rgba) {
  std::fill(row_.begin(), row_.end(), 0.0);
  double* sum = row_.data();
  const auto add = [&](const std::uint16_t* pixel, std::int64_t share) {
    const double weight = double(share) * pixel[3];
    for (int c = 0; c < 3; ++c) sum[c] += weight * pixel[c];
    sum[3] += weight;
  };
  std::int64_t left = 0, edge = width_;
  for (int x = 0; x < width_; ++x, rgba += 4) {
    const std::int64_t right = left + image_.width;
    add(rgba, std::min(right, edge) - left);
    if (right >= edge && x + 1 < width_) {
      sum += 4;
      add(rgba, right - edge);
      edge += width_;
    }
    left = right;
  }
}

void BoxReducer::finish_row(int y) {
  const double area = double(width_) * height_;
  for (int x = 0; x < image_.width; ++x) {
    const double* sum = total_.data() + 4 * std::size_t(x);
    if (sum[3] == 0) continue;
    for (int c = 0; c < 3; ++c) *image_.at(x, y, c) = to_8_bits(sum[c] / sum[3]);
    *image_.at(x, y, 3) = to_8_bits(sum[3] / area);
  }
}

}  // namespace gradmesh
