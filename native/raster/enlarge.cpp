#include "raster/enlarge.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/clamped_int.h"
#include "base/parallel.h"

namespace gradmesh {
namespace {

/// How the samples along one side of a picture come of those of a shorter one.
class Side {
 public:
  /// The sample `first` and the one after it, which has this share.
  struct Mix {
    std::size_t first;
    double share;
  };

  Side(int shorter, int longer)
      : sums_(std::size_t(shorter)), squares_(std::size_t(shorter)), next_(std::size_t(shorter)) {
    for (int i = 0; i < longer; ++i) {
      const double place = std::clamp((i + 0.5) * shorter / longer - 0.5, 0.0, double(shorter - 1));
      const int first = std::min(clamped_int(place, 0, shorter - 1), shorter - 2);
      add({std::size_t(first), place - first});
    }
  }

  std::size_t size() const { return sums_.size(); }
  const std::vector<Mix>& mixes() const { return mixes_; }
  /// Over all mixes: the sum of a sample's shares, that of their squares, and that of their
  /// products with those of the sample before or after, 0 beyond the ends.
  double sum(std::size_t i) const { return sums_[i]; }
  double square(std::size_t i) const { return squares_[i]; }
  double before(std::size_t i) const { return i > 0 ? next_[i - 1] : 0; }
  double after(std::size_t i) const { return next_[i]; }

 private:
  void add(Mix mix) {
    const double a = 1 - mix.share, b = mix.share;
    sums_[mix.first] += a;
    sums_[mix.first + 1] += b;
    squares_[mix.first] += a * a;
    squares_[mix.first + 1] += b * b;
    next_[mix.first] += a * b;
    mixes_.push_back(mix);
  }

  std::vector<double> sums_, squares_, next_;
  std::vector<Mix> mixes_;
};

double mixed(double a, double b, double share) { return a + (b - a) * share; }

/// Finds the samples of one channel, by coordinate descent.
class Fit {
 public:
  Fit(const Side& across, const Side& down)
      : across_(across), down_(down), line_(across.size() + 2) {
    target_.resize(line_ * (down.size() + 2));
  }

  /// Adds a row of the picture to be shown.
  void add(const double* samples, const Side::Mix& at) {
    double* const upper = target_.data() + place(0, at.first);
    double* const lower = upper + line_;
    for (const auto& [first, share] : across_.mixes()) {
      const double sample = *samples++;
      const double left = sample * (1 - share), right = sample * share;
      upper[first] += left * (1 - at.share);
      upper[first + 1] += right * (1 - at.share);
      lower[first] += left * at.share;
      lower[first + 1] += right * at.share;
    }
  }

  /// Returns the samples, row by row.
  void solve(std::uint8_t* samples) {
    values_ = target_;
    each([&](std::size_t x, std::size_t y) {
      values_[place(x, y)] /= across_.sum(x) * down_.sum(y);
    });
    for (int i = 0; i < 4; ++i)
      each([&](std::size_t x, std::size_t y) { values_[place(x, y)] = best(x, y); });
    // What rounding does to one is made good by those that follow.
    for (int i = 0; i < 3; ++i)
      each([&](std::size_t x, std::size_t y) {
        values_[place(x, y)] = std::clamp(std::ceil(best(x, y) - 0.5), 0.0, 255.0);
      });
    each([&](std::size_t x, std::size_t y) { *samples++ = std::uint8_t(values_[place(x, y)]); });
  }

 private:
  /// Around the samples lies a border of zeros.
  std::size_t place(std::size_t x, std::size_t y) const { return (y + 1) * line_ + x + 1; }

  template <class Body>
  void each(const Body& body) const {
    for (std::size_t y = 0; y < down_.size(); ++y)
      for (std::size_t x = 0; x < across_.size(); ++x) body(x, y);
  }

  /// Returns the best value of one sample, all others being as they are.
  double best(std::size_t x, std::size_t y) const {
    const double* const at = values_.data() + place(x, y);
    const auto row = [&](const double* v) {
      return across_.before(x) * v[-1] + across_.square(x) * v[0] + across_.after(x) * v[1];
    };
    const double square = across_.square(x) * down_.square(y);
    const double shown = down_.before(y) * row(at - line_) + down_.square(y) * row(at) +
                         down_.after(y) * row(at + line_);
    return *at + (target_[place(x, y)] - shown) / square;
  }

  const Side &across_, &down_;
  std::size_t line_;
  std::vector<double> target_, values_;
};

/// Restores the samples of a picture as they were before they were rounded down, in the mean.
template <int Channels>
class Restored {
 public:
  /// `across` and `down` are how far apart the samples are that will stand for these.
  Restored(const Raster<std::uint8_t, Channels>& picture, int across, int down)
      : picture_(picture), across_(8 * across), down_(8 * down) {}

  double sample(int x, int y, int channel) const {
    const double sample = *picture_.at(x, y, channel);
    if (Channels < 4 || channel == 3) return std::min(whole, sample + lost(x, y, channel));
    // Their product is rounded down.
    const double opacity = *picture_.at(x, y, 3);
    const double of_opacity = lost(x, y, 3), restored = std::min(whole, opacity + of_opacity);
    if (restored == 0) return sample;
    const double of_product = std::max(of_opacity, lost(x, y, channel));
    return std::min(whole, (sample * opacity + of_product * whole) / restored);
  }

 private:
  static constexpr double whole = 255;

  /// Returns how much of a level was lost: a little less than half, and nothing where the level
  /// goes on to all sides, so far that it is no step of a slow change.
  double lost(int x, int y, int channel) const {
    const int level = *picture_.at(x, y, channel);
    const auto is_level = [&](int at_x, int at_y) {
      return *picture_.at(std::clamp(at_x, 0, picture_.width - 1),
                          std::clamp(at_y, 0, picture_.height - 1), channel) == level;
    };
    const bool goes_on = is_level(x - across_, y) && is_level(x + across_, y) &&
                         is_level(x, y - down_) && is_level(x, y + down_);
    return goes_on ? 0 : 0.48;
  }

  const Raster<std::uint8_t, Channels>& picture_;
  int across_, down_;
};

}  // namespace

Image multiplied(Image picture) { return picture; }

RgbaImage multiplied(RgbaImage picture) {
  const std::size_t pixels = picture.pixels();
  const std::uint8_t* const opacity = picture.samples.data() + 3 * pixels;
  for (std::size_t i = 0; i < 3 * pixels; ++i)
    picture.samples[i] = std::uint8_t((picture.samples[i] * opacity[i % pixels] + 127) / 255);
  return picture;
}

template <int Channels>
Raster<std::uint8_t, Channels> enlarged(const Raster<std::uint8_t, Channels>& picture, int width,
                                        int height, Window rows) {
  const Side across(picture.width, width), down(picture.height, height);
  Raster<std::uint8_t, Channels> result(Window{0, rows.y0, width, rows.y1});
  std::vector<double> line(std::size_t(picture.width));
  for (int c = 0; c < Channels; ++c)
    for (int y = rows.y0; y < rows.y1; ++y) {
      const auto& [above, share] = down.mixes()[std::size_t(y)];
      const std::uint8_t* const upper = picture.at(0, int(above), c);
      for (std::size_t x = 0; x < line.size(); ++x)
        line[x] = mixed(upper[x], upper[x + line.size()], share);
      std::uint8_t* out = result.at(0, y, c);
      for (const Side::Mix& mix : across.mixes())
        *out++ = std::uint8_t(mixed(line[mix.first], line[mix.first + 1], mix.share));
    }
  return result;
}

template <int Channels>
Raster<std::uint8_t, Channels> reduced(const Raster<std::uint8_t, Channels>& picture, int width,
                                       int height) {
  const Side across(width, picture.width), down(height, picture.height);
  Raster<std::uint8_t, Channels> result(width, height);
  const Restored restored(picture, (picture.width + width - 1) / width,
                          (picture.height + height - 1) / height);
  parallel_for(Channels, [&](std::size_t channel) {
    Fit fit(across, down);
    std::vector<double> row(std::size_t(picture.width));
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x)
        row[std::size_t(x)] = restored.sample(x, y, int(channel));
      fit.add(row.data(), down.mixes()[std::size_t(y)]);
    }
    fit.solve(result.at(0, 0, int(channel)));
  });
  return result;
}

template Image enlarged(const Image&, int, int, Window);
template RgbaImage enlarged(const RgbaImage&, int, int, Window);
template Image reduced(const Image&, int, int);
template RgbaImage reduced(const RgbaImage&, int, int);

}  // namespace gradmesh
