#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <span>
#include <string>

namespace gradmesh {

// What lives on a device. All of it is made, used and let go while a Device::Use lives, or let go
// without one where the device is lost.

/// A buffer that shaders read and write. Grows as needed, never shrinks.
class Buffer {
 public:
  Buffer() = default;
  ~Buffer();
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  /// Room for so many bytes, whose values may be anything. Throws DeviceError where the device has
  /// none.
  void reserve(std::size_t bytes);
  template <class T>
  void write(std::span<const T> values) {
    write(values.data(), values.size_bytes());
  }
  template <class T>
  void read(std::span<T> values) const {
    read(values.data(), values.size_bytes());
  }
  /// As the block with `binding` in the shaders.
  void bind(unsigned binding) const;

 private:
  void write(const void* data, std::size_t bytes);
  void read(void* data, std::size_t bytes) const;

  GLuint name_ = 0;
  std::size_t size_ = 0, used_ = 0;
};

/// A compute shader, which goes with its context.
class Program {
 public:
  /// Throws DeviceError, with what the driver says, where it cannot be built.
  explicit Program(const std::string& source);

  /// Sets uniforms of the program in use.
  void use() const { glUseProgram(name_); }
  void set(const char* uniform, int value) const;
  void set(const char* uniform, int x, int y) const;
  /// Runs so many groups, and lets those after it see what it wrote.
  void run(int groups) const;

 private:
  GLuint name_ = 0;
};

/// "const float NAME[n] = float[n](...);" to the last bit.
std::string constant(const char* name, std::span<const float> values);
std::string constant(const char* name, float value);
std::string constant(const char* name, int value);

/// A shader's source from its parts, in front of them the version and what the device's language
/// wants.
std::string shader_source(std::initializer_list<std::string> parts);

}  // namespace gradmesh
