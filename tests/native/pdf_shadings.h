#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "pdf_documents.h"
#include "shading_bits.h"

namespace gradmesh {

/// A shading of type 7 with one patch over the square from (0, 0) to (9, 9): red, green, blue and
/// white corners.
inline std::string square_shading(const std::string& space = "/DeviceRGB", int components = 3) {
  BitWriter data;
  data.add(0, 8);
  for (const std::uint32_t step : {0U, 3U, 6U, 9U}) data.add({0, step}, 8);
  for (const std::uint32_t step : {3U, 6U, 9U}) data.add({step, 9}, 8);
  for (const std::uint32_t step : {6U, 3U, 0U}) data.add({9, step}, 8);
  for (const std::uint32_t step : {6U, 3U}) data.add({step, 0}, 8);
  data.add({3, 3, 3, 6, 6, 6, 6, 3}, 8);
  for (int corner = 0; corner < 4; ++corner)
    for (int n = 0; n < components; ++n) data.add(corner == n || corner == 3 ? 255 : 0, 8);
  std::string decode = "/Decode [0 255 0 255";
  for (int n = 0; n < components; ++n) decode += " 0 1";
  return pdf_stream("/ShadingType 7 /ColorSpace " + space +
                        " /BitsPerCoordinate 8 /BitsPerComponent 8 /BitsPerFlag 8 " + decode + "]",
                    data.bytes());
}

/// Returns a file that may lie beside the project, in ../shared/pdf; nothing if it does not.
inline std::string shared_pdf(const std::string& name) {
  std::ifstream file(std::filesystem::path(GRADMESH_SHARED_DIR) / "pdf" / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace gradmesh
