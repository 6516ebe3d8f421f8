#include "service/arguments.h"

#include <utility>

namespace gradmesh {

Arguments::Arguments(const Json& values) : values_(values) {
  if (!values_.is_object()) throw WrongType("the arguments of a call must have names.");
}

const Json& Arguments::at(const std::string& name) const {
  static const Json none;
  const auto found = values_.find(name);
  return found == values_.end() ? none : *found;
}

void Arguments::read(const std::string& name, const Json& json, bool& value) {
  if (!json.is_boolean()) throw WrongType(name + " must be true or false.");
  value = json.get<bool>();
}

void Arguments::read(const std::string& name, const Json& json, int& value) {
  if (!json.is_number_integer()) throw WrongType(name + " must be a whole number.");
  const bool fits = json.is_number_unsigned() ? std::in_range<int>(json.get<std::uint64_t>())
                                              : std::in_range<int>(json.get<std::int64_t>());
  if (!fits) throw WrongType(name + " must be below 2^31.");
  value = json.get<int>();
}

void Arguments::read(const std::string& name, const Json& json, std::uint64_t& value) {
  // What C++ has made of a signed number is held as one, also where it is not negative.
  const bool is_signed = json.is_number_integer() && !json.is_number_unsigned();
  if (!json.is_number_integer() || (is_signed && json.get<std::int64_t>() < 0))
    throw WrongType(name + " must be a whole number that is not negative.");
  value = json.get<std::uint64_t>();
}

void Arguments::read(const std::string& name, const Json& json, double& value) {
  if (!json.is_number()) throw WrongType(name + " must be a number.");
  value = json.get<double>();
}

void Arguments::read(const std::string& name, const Json& json, std::string& value) {
  if (!json.is_string()) throw WrongType(name + " must be a text.");
  value = json.get<std::string>();
}

void Arguments::read(const std::string& name, const Json& json, Bytes& value) {
  if (!json.is_binary()) throw WrongType(name + " must be bytes.");
  const auto& bytes = json.get_binary();
  value.bytes.assign(bytes.begin(), bytes.end());
}

}  // namespace gradmesh
