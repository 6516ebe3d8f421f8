#include "files/to_srgb.h"

#include <lcms2.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gradmesh {
namespace {

struct CloseProfile {
  void operator()(void* profile) const { cmsCloseProfile(profile); }
};
using Profile = std::unique_ptr<void, CloseProfile>;

struct FreeCurve {
  void operator()(cmsToneCurve* curve) const { cmsFreeToneCurve(curve); }
};

/// The exponent that programs write for sRGB, whose curve it comes close to.
constexpr double usual_gamma = 2.2;

bool is_usual(double gamma) { return gamma == 0 || std::abs(gamma - usual_gamma) < 0.01; }

cmsToneCurve* curve_of(double gamma) {
  if (!is_usual(gamma)) return cmsBuildGamma(nullptr, gamma);
  const double srgb[] = {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045};
  return cmsBuildParametricToneCurve(nullptr, 4, srgb);
}

Profile profile_of(const PictureEncoding& encoding, int colors) {
  PictureEncoding usual = encoding;
  if (is_usual(usual.gamma)) usual.gamma = 0;
  if (colors > 3 || usual == PictureEncoding()) return {};
  const std::unique_ptr<cmsToneCurve, FreeCurve> curve(curve_of(encoding.gamma));
  if (!curve) return {};
  const auto point = [](PictureEncoding::Chromaticity c) { return cmsCIExyY{c.x, c.y, 1}; };
  const cmsCIExyY white = point(encoding.white);
  const cmsCIExyYTRIPLE primaries{point(encoding.red), point(encoding.green), point(encoding.blue)};
  cmsToneCurve* curves[] = {curve.get(), curve.get(), curve.get()};
  return Profile(colors == 1 ? cmsCreateGrayProfile(&white, curve.get())
                             : cmsCreateRGBProfile(&white, &primaries, curves));
}

/// The picture's profile, or none where it is damaged.
Profile profile_of(const PictureForm& form) {
  if (form.profile.empty()) return profile_of(form.encoding, form.colors);
  if (form.profile.size() > std::numeric_limits<cmsUInt32Number>::max()) return {};
  return Profile(cmsOpenProfileFromMem(form.profile.data(), cmsUInt32Number(form.profile.size())));
}

/// How many colours the profile is for, or 0 where no picture here has such.
int colors_of(const Profile& profile) {
  switch (cmsGetColorSpace(profile.get())) {
    case cmsSigGrayData:
      return 1;
    case cmsSigRgbData:
      return 3;
    case cmsSigCmykData:
      return 4;
    default:
      return 0;
  }
}

/// lcms2's name for pixels with so many colours and an opacity.
cmsUInt32Number layout(int colors, int bits) {
  const cmsUInt32Number space = colors == 1 ? PT_GRAY : colors == 3 ? PT_RGB : PT_CMYK;
  return COLORSPACE_SH(space) | CHANNELS_SH(cmsUInt32Number(colors)) | EXTRA_SH(1) |
         BYTES_SH(cmsUInt32Number(bits / 8));
}

}  // namespace

void ToSrgb::Close::operator()(void* transform) const { cmsDeleteTransform(transform); }

ToSrgb::ToSrgb(const PictureForm& form)
    : width_(std::size_t(form.width)), colors_(form.colors), bits_(form.bits) {
  const Profile profile = profile_of(form);
  if (!profile) return;
  profile_colors_ = colors_of(profile);
  const bool fits = profile_colors_ == colors_ || (profile_colors_ == 3 && colors_ == 1);
  const Profile srgb(cmsCreate_sRGBProfile());
  if (!fits || !srgb) return;
  // With 16 bits lcms2's shortcut is a table with few places: it errs by up to 16 of 255 levels.
  const cmsUInt32Number exact = bits_ == 16 ? cmsFLAGS_NOOPTIMIZE : 0;
  transform_.reset(cmsCreateTransform(profile.get(), layout(profile_colors_, bits_), srgb.get(),
                                      layout(3, bits_), INTENT_PERCEPTUAL,
                                      exact | cmsFLAGS_COPY_ALPHA));
  if (!transform_ || bits_ != 8) return;
  narrow_.resize(width_ * std::size_t(profile_colors_ + 1));
  narrow_rgba_.resize(width_ * 4);
}

void ToSrgb::convert(const std::uint16_t* row, std::uint16_t* rgba) noexcept {
  if (transform_ && profile_colors_ == colors_) return transform(row, rgba);
  spread(row, rgba);
  if (transform_) transform(rgba, rgba);
}

/// Gives grey three colours.
void ToSrgb::spread(const std::uint16_t* row, std::uint16_t* rgba) const noexcept {
  if (colors_ == 3) {
    std::copy_n(row, 4 * width_, rgba);
    return;
  }
  for (std::size_t x = 0; x < width_; ++x) {
    std::fill_n(rgba + 4 * x, 3, row[2 * x]);
    rgba[4 * x + 3] = row[2 * x + 1];
  }
}

void ToSrgb::transform(const std::uint16_t* row, std::uint16_t* rgba) noexcept {
  const auto pixels = cmsUInt32Number(width_);
  if (bits_ != 8) return cmsDoTransform(transform_.get(), row, rgba, pixels);
  for (std::size_t i = 0; i < narrow_.size(); ++i) narrow_[i] = std::uint8_t(row[i] >> 8);
  cmsDoTransform(transform_.get(), narrow_.data(), narrow_rgba_.data(), pixels);
  for (std::size_t i = 0; i < narrow_rgba_.size(); ++i)
    rgba[i] = std::uint16_t(narrow_rgba_[i] * 257);
}

}  // namespace gradmesh
