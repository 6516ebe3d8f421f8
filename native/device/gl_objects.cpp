#include "device/gl_objects.h"

#include <epoxy/egl.h>

#include <algorithm>
#include <cstdio>

#include "device/device.h"

namespace gradmesh {
namespace {

/// As in tiles.glsl.
constexpr int row_of_groups = 32768;

std::string literal(float value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", double(value));
  const std::string digits = text;
  return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

}  // namespace

Buffer::~Buffer() {
  if (eglGetCurrentContext() != EGL_NO_CONTEXT) glDeleteBuffers(1, &name_);
}

void Buffer::reserve(std::size_t bytes) {
  used_ = std::max<std::size_t>(bytes, 4);
  if (name_ && used_ <= size_) return;
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  if (used_ > std::size_t(most)) throw DeviceError(Message("the device has not enough memory"));
  if (!name_) glGenBuffers(1, &name_);
  // With some room to grow.
  size_ = std::min(std::size_t(most), used_ + used_ / 2);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, name_);
  glBufferData(GL_SHADER_STORAGE_BUFFER, GLsizeiptr(size_), nullptr, GL_DYNAMIC_DRAW);
}

void Buffer::write(const void* data, std::size_t bytes) {
  reserve(bytes);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, name_);
  if (bytes > 0) glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, GLsizeiptr(bytes), data);
}

void Buffer::read(void* data, std::size_t bytes) const {
  if (bytes == 0) return;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, name_);
  const void* const mapped =
      glMapBufferRange(GL_SHADER_STORAGE_BUFFER, 0, GLsizeiptr(bytes), GL_MAP_READ_BIT);
  if (!mapped) throw DeviceError(Message("the device was lost"));
  std::copy_n(static_cast<const std::byte*>(mapped), bytes, static_cast<std::byte*>(data));
  glUnmapBuffer(GL_SHADER_STORAGE_BUFFER);
}

void Buffer::bind(unsigned binding) const {
  // What is used and no more: shaders ask for the length.
  glBindBufferRange(GL_SHADER_STORAGE_BUFFER, binding, name_, 0, GLsizeiptr(used_));
}

Program::Program(const std::string& source) {
  const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
  const char* const text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint is_compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetShaderInfoLog(shader, GLsizei(log.size()), &length, log.data());
  GLint is_linked = 0;
  if (is_compiled) {
    name_ = glCreateProgram();
    glAttachShader(name_, shader);
    glLinkProgram(name_);
    glGetProgramiv(name_, GL_LINK_STATUS, &is_linked);
    if (!is_linked) glGetProgramInfoLog(name_, GLsizei(log.size()), &length, log.data());
  }
  glDeleteShader(shader);
  if (is_linked) return;
  glDeleteProgram(name_);
  log.resize(std::size_t(length));
  std::ranges::replace(log, '\n', ' ');
  throw DeviceError(Message("the device's driver does not take a shader ({0})", log));
}

void Program::set(const char* uniform, int value) const {
  glUniform1i(glGetUniformLocation(name_, uniform), value);
}

void Program::set(const char* uniform, int x, int y) const {
  glUniform2i(glGetUniformLocation(name_, uniform), x, y);
}

void Program::run(int groups) const {
  if (groups <= 0) return;
  glDispatchCompute(GLuint(std::min(groups, row_of_groups)),
                    GLuint((groups + row_of_groups - 1) / row_of_groups), 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

std::string constant(const char* name, std::span<const float> values) {
  const std::string type = "float[" + std::to_string(values.size()) + "]";
  std::string text = "const " + type + " " + name + " = " + type + "(";
  for (std::size_t i = 0; i < values.size(); ++i) text += (i > 0 ? ", " : "") + literal(values[i]);
  return text + ");\n";
}

std::string constant(const char* name, float value) {
  return std::string("const float ") + name + " = " + literal(value) + ";\n";
}

std::string constant(const char* name, int value) {
  return std::string("const int ") + name + " = " + std::to_string(value) + ";\n";
}

std::string shader_source(std::initializer_list<std::string> parts) {
  std::string source = epoxy_is_desktop_gl() ? "#version 430 core\n" : "#version 320 es\n";
  source += "precision highp float;\nprecision highp int;\n";
  for (const std::string& part : parts) source += part;
  return source;
}

}  // namespace gradmesh
