#include "formats/pdf/page/read_color_space.h"

#include "base/clamped_int.h"
#include "base/error.h"
#include "formats/pdf/page/dictionary.h"
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

ColorSpace space_within(QPDFObjectHandle object, int depth);

ColorSpace separation(const std::vector<QPDFObjectHandle>& parts, int depth) {
  if (parts.size() < 4) throw_no_space();
  std::vector<std::string> names;
  QPDFObjectHandle list = parts[1];
  if (list.isName()) names.push_back(list.getName().substr(1));
  if (list.isArray())
    for (QPDFObjectHandle name : list.getArrayAsVector())
      names.push_back(name.isName() ? name.getName().substr(1) : std::string());
  return ColorSpace::separation(names, space_within(parts[2], depth + 1), read_function(parts[3]));
}

ColorSpace named_space(const std::string& name) {
  if (name == "/DeviceGray" || name == "/CalGray" || name == "/G") return ColorSpace::device_gray();
  if (name == "/DeviceRGB" || name == "/CalRGB" || name == "/RGB") return ColorSpace::device_rgb();
  if (name == "/DeviceCMYK" || name == "/CMYK") return ColorSpace::device_cmyk();
  throw_no_space();
}

ColorSpace space_within(QPDFObjectHandle object, int depth) {
  if (depth > deepest_space) throw_no_space();
  if (object.isName()) return named_space(object.getName());
  if (!object.isArray()) throw_no_space();
  const std::vector<QPDFObjectHandle> parts = object.getArrayAsVector();
  if (parts.empty() || !QPDFObjectHandle(parts[0]).isName()) throw_no_space();
  const std::string name = QPDFObjectHandle(parts[0]).getName();
  if (parts.size() < 2) return named_space(name);
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

}  // namespace

ColorSpace read_color_space(QPDFObjectHandle object) { return space_within(object, 0); }

}  // namespace gradmesh
