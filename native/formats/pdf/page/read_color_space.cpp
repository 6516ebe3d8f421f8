#include "formats/pdf/page/read_color_space.h"

#include "base/clamped_int.h"
#include "base/error.h"
#include "formats/pdf/objects/dictionary.h"
#include "formats/pdf/page/read_function.h"

namespace gradmesh {
namespace {

/// Separations in one another have no sense.
constexpr int deepest_space = 4;

[[noreturn]] void throw_no_space() { throw InputError("its colour space is not known"); }

glm::dvec3 three_of(QPDFObjectHandle object, const glm::dvec3& otherwise) {
  const std::vector<double> n = numbers_of(object);
  return n.size() == 3 ? glm::dvec3(n[0], n[1], n[2]) : otherwise;
}

ColorSpace cal_rgb(QPDFObjectHandle dictionary) {
  CalRgbParameters parameters;
  parameters.white_point = three_of(value_of(dictionary, "/WhitePoint"), parameters.white_point);
  parameters.gamma = three_of(value_of(dictionary, "/Gamma"), parameters.gamma);
  const std::vector<double> m = numbers_of(value_of(dictionary, "/Matrix"));
  if (m.size() == 9) parameters.matrix = {m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]};
  return ColorSpace::cal_rgb(parameters);
}

ColorSpace lab(QPDFObjectHandle dictionary) {
  LabParameters parameters;
  parameters.white_point = three_of(value_of(dictionary, "/WhitePoint"), parameters.white_point);
  const std::vector<double> range = numbers_of(value_of(dictionary, "/Range"));
  if (range.size() == 4) {
    parameters.a_range = {range[0], range[1]};
    parameters.b_range = {range[2], range[3]};
  }
  return ColorSpace::lab(parameters);
}

class SpaceReader {
 public:
  explicit SpaceReader(QPDFObjectHandle named) : named_(std::move(named)) {}

  ColorSpace read(QPDFObjectHandle object, int depth = 0) {
    if (depth > deepest_space) throw_no_space();
    if (object.isName()) return read_name(object.getName(), depth);
    if (!object.isArray()) throw_no_space();
    const std::vector<QPDFObjectHandle> parts = object.getArrayAsVector();
    if (parts.empty() || !QPDFObjectHandle(parts[0]).isName()) throw_no_space();
    const std::string name = QPDFObjectHandle(parts[0]).getName();
    if (parts.size() < 2) return read_name(name, depth);
    if (name == "/ICCBased")
      return ColorSpace::icc_based(
          clamped_int(number_of(value_of(parts[1], "/N")).value_or(0), 0, max_function_values));
    if (name == "/CalGray")
      return ColorSpace::cal_gray(number_of(value_of(parts[1], "/Gamma")).value_or(1));
    if (name == "/CalRGB") return cal_rgb(parts[1]);
    if (name == "/Lab") return lab(parts[1]);
    if (name == "/Separation" || name == "/DeviceN") return separation(parts, depth);
    throw_no_space();
  }

 private:
  ColorSpace read_name(const std::string& name, int depth) {
    if (name == "/DeviceGray" || name == "/CalGray" || name == "/G")
      return of_device("/DefaultGray", ColorSpace::device_gray(), depth);
    if (name == "/DeviceRGB" || name == "/CalRGB" || name == "/RGB")
      return of_device("/DefaultRGB", ColorSpace::device_rgb(), depth);
    if (name == "/DeviceCMYK" || name == "/CMYK")
      return of_device("/DefaultCMYK", ColorSpace::device_cmyk(), depth);
    QPDFObjectHandle there = value_of(named_, name);
    if (there.isNull()) throw_no_space();
    return read(there, depth + 1);
  }

  /// Returns what the resources have in the place of a device's space, if they have one that fits.
  ColorSpace of_device(const char* default_name, ColorSpace device, int depth) {
    QPDFObjectHandle instead = value_of(named_, default_name);
    // One that says that it is the device's says nothing.
    if (!instead.isArray()) return device;
    ColorSpace space = read(instead, depth + 1);
    return space.components() == device.components() ? space : device;
  }

  ColorSpace separation(const std::vector<QPDFObjectHandle>& parts, int depth) {
    if (parts.size() < 4) throw_no_space();
    std::vector<std::string> names;
    QPDFObjectHandle list = parts[1];
    if (list.isName()) names.push_back(list.getName().substr(1));
    if (list.isArray())
      for (QPDFObjectHandle name : list.getArrayAsVector())
        names.push_back(name.isName() ? name.getName().substr(1) : std::string());
    return ColorSpace::separation(names, read(parts[2], depth + 1), read_function(parts[3]));
  }

  const QPDFObjectHandle named_;
};

}  // namespace

ColorSpace read_color_space(QPDFObjectHandle object, const QPDFObjectHandle& named) {
  return SpaceReader(named).read(std::move(object));
}

}  // namespace gradmesh
