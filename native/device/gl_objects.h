#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <span>
#include <string>

namespace gradmesh {

// Objects that live on a device. They are made, used and released while a Device::Use lives, or
// released without one where the device is lost.

/// A buffer that shaders read and write. Grows as needed, never shrinks.
class Buffer {
 public:
  Buffer() = default;
  ~Buffer();
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  /// Makes room for `bytes` bytes, whose values may be anything. Throws DeviceError if the device
  /// has none.
  void reserve(std::size_t bytes);
  template <class T>
  void write(std::span<const T> values) {
    write(values.data(), values.size_bytes());
  }
  template <class T>
  void read(std::span<T> values) const {
    read(values.data(), values.size_bytes());
  }
  /// Binds the buffer as the block with this `binding` in the shaders.
  void bind(unsigned binding) const;

 private:
  void write(const void* data, std::size_t bytes);
  void read(void* data, std::size_t bytes) const;

  GLuint name_ = 0;
  std::size_t size_ = 0, used_ = 0;
};

/// A compute shader, which is freed with its context.
class Program {
 public:
  /// Builds the shader. Throws DeviceError, with what the driver says, if it cannot be built.
  explicit Program(const std::string& source);

  /// Makes this the program in use, whose uniforms set() sets.
  void use() const { glUseProgram(name_); }
  void set(const char* uniform, int value) const;
  void set(const char* uniform, int x, int y) const;
  /// Runs `groups` groups, and lets later programs see what they wrote.
  void run(int groups) const;

 private:
  GLuint name_ = 0;
};

/// Returns the declaration of a constant, such as "const float NAME[n] = float[n](...);", exact to
/// the last bit.
std::string constant(const char* name, std::span<const float> values);
std::string constant(const char* name, float value);
std::string constant(const char* name, int value);

/// Returns a shader's source: the version and what the device's language wants, then the parts.
std::string shader_source(std::initializer_list<std::string> parts);

}  // namespace gradmesh
