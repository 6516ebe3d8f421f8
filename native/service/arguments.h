#pragma once

#include <cstdint>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gradmesh {

/// What is said between a caller and the service: JSON, whose binary values are strings of bytes.
using Json = nlohmann::json;

/// Thrown where an argument is missing or of another type than the function takes.
class WrongType : public std::exception {
 public:
  explicit WrongType(std::string text) : text_(std::move(text)) {}
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::string text_;
};

/// A string of bytes that need be no text.
struct Bytes {
  std::string bytes;
};

/// The arguments of a call, by name, which must outlive this. An argument that is missing is null.
/// All members throw WrongType.
class Arguments {
 public:
  explicit Arguments(const Json& values);

  /// Returns an argument as a T: bool, int, std::uint64_t, double, std::string, Bytes, or a
  /// std::optional, which is empty for null, or a std::vector or std::pair of these.
  template <class T>
  T get(const std::string& name) const {
    T value{};
    read(name, at(name), value);
    return value;
  }

  /// Returns true if there is an argument of that name, and if it is not null.
  bool has(const std::string& name) const { return !at(name).is_null(); }

 private:
  static void read(const std::string& name, const Json& json, bool& value);
  static void read(const std::string& name, const Json& json, int& value);
  static void read(const std::string& name, const Json& json, std::uint64_t& value);
  static void read(const std::string& name, const Json& json, double& value);
  static void read(const std::string& name, const Json& json, std::string& value);
  static void read(const std::string& name, const Json& json, Bytes& value);
  template <class T>
  static void read(const std::string& name, const Json& json, std::optional<T>& value) {
    if (!json.is_null()) read(name, json, value.emplace());
  }
  template <class T>
  static void read(const std::string& name, const Json& json, std::vector<T>& value) {
    if (!json.is_array()) throw WrongType(name + " must be a list.");
    for (const Json& member : json) read("a member of " + name, member, value.emplace_back());
  }
  template <class A, class B>
  static void read(const std::string& name, const Json& json, std::pair<A, B>& value) {
    if (!json.is_array() || json.size() != 2) throw WrongType(name + " must be a pair.");
    read("the first of " + name, json[0], value.first);
    read("the second of " + name, json[1], value.second);
  }

  /// Returns the argument; null if there is none of that name.
  const Json& at(const std::string& name) const;

  const Json& values_;
};

}  // namespace gradmesh
