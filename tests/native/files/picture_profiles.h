#pragma once

#include <lcms2.h>

#include <string>

namespace gradmesh::test {

/// The bytes of a profile, which is closed.
inline std::string profile_bytes(cmsHPROFILE profile) {
  cmsUInt32Number size = 0;
  cmsSaveProfileToMem(profile, nullptr, &size);
  std::string bytes(size, '\0');
  cmsSaveProfileToMem(profile, bytes.data(), &size);
  cmsCloseProfile(profile);
  return bytes;
}

/// sRGB, but for red and green, which have changed places.
inline std::string swapped_profile() {
  const cmsFloat64Number srgb[] = {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045};
  cmsToneCurve* curve = cmsBuildParametricToneCurve(nullptr, 4, srgb);
  cmsToneCurve* curves[] = {curve, curve, curve};
  const cmsCIExyY white{0.3127, 0.3290, 1};
  const cmsCIExyYTRIPLE primaries{{0.30, 0.60, 1}, {0.64, 0.33, 1}, {0.15, 0.06, 1}};
  const std::string bytes = profile_bytes(cmsCreateRGBProfile(&white, &primaries, curves));
  cmsFreeToneCurve(curve);
  return bytes;
}

/// Grey that is light itself.
inline std::string linear_grey_profile() {
  cmsToneCurve* curve = cmsBuildGamma(nullptr, 1);
  const cmsCIExyY white{0.3127, 0.3290, 1};
  const std::string bytes = profile_bytes(cmsCreateGrayProfile(&white, curve));
  cmsFreeToneCurve(curve);
  return bytes;
}

/// CMYK in which black takes the lightness in proportion, and the other inks do nothing.
inline std::string black_ink_profile() {
  cmsHPROFILE profile = cmsCreateProfilePlaceholder(nullptr);
  cmsSetProfileVersion(profile, 2.1);
  cmsSetDeviceClass(profile, cmsSigOutputClass);
  cmsSetColorSpace(profile, cmsSigCmykData);
  cmsSetPCS(profile, cmsSigLabData);
  cmsPipeline* pipeline = cmsPipelineAlloc(nullptr, 4, 3);
  cmsStage* table = cmsStageAllocCLut16bit(nullptr, 2, 4, 3, nullptr);
  cmsStageSampleCLut16bit(
      table,
      [](const cmsUInt16Number in[], cmsUInt16Number out[], void*) {
        // As version 2 has them, 100 is 65280 and 0 of the others 32768.
        out[0] = cmsUInt16Number((65535 - in[3]) * 65280.0 / 65535);
        out[1] = out[2] = 32768;
        return cmsInt32Number(TRUE);
      },
      nullptr, 0);
  cmsPipelineInsertStage(pipeline, cmsAT_END, table);
  cmsWriteTag(profile, cmsSigAToB0Tag, pipeline);
  const std::string bytes = profile_bytes(profile);
  cmsPipelineFree(pipeline);
  return bytes;
}

}  // namespace gradmesh::test
