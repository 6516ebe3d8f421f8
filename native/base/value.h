#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace gradmesh {

/// One vector of a patch: position in mesh units, colour as (r, g, b, a) in sRGB, not
/// premultiplied, 0..1. Tangents and twists are Values too; their colour part is a derivative.
struct Value {
  glm::dvec2 position{0.0};
  glm::dvec4 color{0.0};

  Value& operator+=(const Value& o) {
    position += o.position;
    color += o.color;
    return *this;
  }
  Value& operator-=(const Value& o) {
    position -= o.position;
    color -= o.color;
    return *this;
  }
  Value& operator*=(double s) {
    position *= s;
    color *= s;
    return *this;
  }
  bool operator==(const Value&) const = default;
};

inline Value operator+(Value a, const Value& b) { return a += b; }
inline Value operator-(Value a, const Value& b) { return a -= b; }
inline Value operator-(const Value& a) { return Value{-a.position, -a.color}; }
inline Value operator*(Value a, double s) { return a *= s; }
inline Value operator*(double s, Value a) { return a *= s; }

}  // namespace gradmesh
