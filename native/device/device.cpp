#include "device/device.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <optional>

#include "device/use.h"

namespace gradmesh {
namespace {

/// What the shaders need (shaders/).
constexpr int most_buffers = 7, most_shared_bytes = 32768, most_threads = 256;

bool has_extension(const char* extensions, const char* name) {
  return extensions && epoxy_extension_in_string(extensions, name);
}

struct Place {
  EGLenum platform;
  void* device;
  bool is_hardware;
};

/// Returns the places where EGL can be asked for a display that needs no window: each of its
/// devices or, with an older Mesa, the platform without a surface.
std::vector<Place> places() {
  if (!epoxy_has_egl()) return {};
  const char* const client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::vector<Place> found;
  if (has_extension(client, "EGL_EXT_platform_device") &&
      (has_extension(client, "EGL_EXT_device_enumeration") ||
       has_extension(client, "EGL_EXT_device_base"))) {
    std::array<EGLDeviceEXT, 32> devices = {};
    EGLint count = 0;
    if (eglQueryDevicesEXT(EGLint(devices.size()), devices.data(), &count))
      for (EGLint i = 0; i < count; ++i) {
        const char* const extensions =
            eglQueryDeviceStringEXT(devices[std::size_t(i)], EGL_EXTENSIONS);
        found.push_back({EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(i)],
                         !has_extension(extensions, "EGL_MESA_device_software")});
      }
  }
  std::stable_partition(found.begin(), found.end(),
                        [](const Place& place) { return place.is_hardware; });
  if (has_extension(client, "EGL_MESA_platform_surfaceless"))
    found.push_back({EGL_PLATFORM_SURFACELESS_MESA, nullptr, false});
  return found;
}

/// Returns true if the library with the functions of OpenGL, or OpenGL ES, is installed. EGL may
/// offer a context without it; libepoxy then ends the program at the first call.
bool has_library(bool es) {
  const auto opens = [](const char* name) {
    return dlopen(name, RTLD_LAZY | RTLD_LOCAL) != nullptr;
  };
  return es ? opens("libGLESv2.so.2") : opens("libOpenGL.so.0") || opens("libGL.so.1");
}

EGLContext make_context(EGLDisplay display, bool es) {
  if (!has_library(es)) return EGL_NO_CONTEXT;
  if (!eglBindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API)) return EGL_NO_CONTEXT;
  const bool is_robust =
      has_extension(eglQueryString(display, EGL_EXTENSIONS), "EGL_EXT_create_context_robustness");
  std::vector<EGLint> attributes = {EGL_CONTEXT_MAJOR_VERSION, es ? 3 : 4,
                                    EGL_CONTEXT_MINOR_VERSION, es ? 2 : 3};
  if (!es)
    attributes.insert(attributes.end(),
                      {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT});
  // So that the driver tells when the device was reset. The name differs between the two.
  if (is_robust)
    attributes.insert(attributes.end(), {es ? EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT
                                            : EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                                         EGL_LOSE_CONTEXT_ON_RESET});
  attributes.push_back(EGL_NONE);
  return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
}

int limit(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

std::string text(GLenum name) {
  const GLubyte* const value = glGetString(name);
  return value ? reinterpret_cast<const char*>(value) : "";
}

/// Returns what is missing in the current context; empty if nothing is.
std::string what_is_missing() {
  if (limit(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS) < most_buffers)
    return "it has too few storage buffers";
  if (limit(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE) < most_shared_bytes)
    return "it has too little shared memory";
  if (limit(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS) < most_threads)
    return "its groups of threads are too small";
  return "";
}

}  // namespace

struct Device::Context {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  DeviceInfo info;
  std::mutex mutex;
  /// The programs by their sources.
  std::map<std::string, Program> programs;

  explicit Context(const Place& place) {
    info.is_hardware = place.is_hardware;
    info.problem = open(place);
  }
  ~Context() {
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    // The display stays: EGL gives the same one to everybody in this process.
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  bool make_current() const {
    return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
  }
  void release() const { eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

 private:
  std::string open(const Place& place) {
    display = eglGetPlatformDisplayEXT(place.platform, place.device, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
      return "its driver does not start";
    const char* const extensions = eglQueryString(display, EGL_EXTENSIONS);
    for (const char* needed : {"EGL_KHR_surfaceless_context", "EGL_KHR_no_config_context"})
      if (!has_extension(extensions, needed) &&
          !has_extension(extensions, "EGL_MESA_configless_context"))
        return std::string("it lacks ") + needed;
    for (const bool es : {false, true}) {
      context = make_context(display, es);
      if (context != EGL_NO_CONTEXT) break;
    }
    if (context == EGL_NO_CONTEXT) return "it has neither OpenGL 4.3 nor OpenGL ES 3.2";
    if (!make_current()) return "it does not work without a window";
    info.name = text(GL_RENDERER);
    info.version = text(GL_VERSION);
    // Drivers that are programs do not always say so to EGL.
    for (const char* program : {"llvmpipe", "softpipe", "SwiftShader"})
      if (info.name.find(program) != std::string::npos) info.is_hardware = false;
    std::string missing = what_is_missing();
    release();
    return missing;
  }
};

std::vector<DeviceInfo> Device::list() {
  std::vector<DeviceInfo> devices;
  for (const Place& place : places()) {
    // A display that the devices have offered already is not listed again.
    if (place.platform == EGL_PLATFORM_SURFACELESS_MESA && !devices.empty()) continue;
    devices.push_back(Context(place).info);
  }
  return devices;
}

std::shared_ptr<Device> Device::open(bool hardware_only) {
  for (const Place& place : places()) {
    if (hardware_only && !place.is_hardware) continue;
    auto context = std::make_unique<Context>(place);
    if (!context->info.problem.empty() || (hardware_only && !context->info.is_hardware)) continue;
    return std::shared_ptr<Device>(new Device(std::move(context)));
  }
  return nullptr;
}

Device::Device(std::unique_ptr<Context> context)
    : info_(context->info), context_(std::move(context)) {}

Device::~Device() = default;

Device::Use::Use(Device& device) : device_(device), lock_(device.context_->mutex) {
  if (device.uses_left_ > 0) --device.uses_left_;
  if (device.is_lost_ || device.uses_left_ == 0 || !device.context_->make_current()) {
    device.is_lost_ = true;
    throw DeviceError(Message("the device was lost"));
  }
}

Device::Use::~Use() { device_.context_->release(); }

const Program& Device::Use::program(const std::string& source) const {
  std::map<std::string, Program>& programs = device_.context_->programs;
  const auto found = programs.find(source);
  return found != programs.end() ? found->second : programs.emplace(source, source).first->second;
}

void Device::Use::check() const {
  const bool tells_resets = epoxy_gl_version() >= (epoxy_is_desktop_gl() ? 45 : 32) ||
                            epoxy_has_gl_extension("GL_KHR_robustness");
  const auto lost = [this] {
    device_.is_lost_ = true;
    return DeviceError(Message("the device was lost"));
  };
  if (tells_resets && glGetGraphicsResetStatus() != GL_NO_ERROR) throw lost();
  // One at a time, until there is none.
  std::optional<GLenum> first;
  for (GLenum error = 0; (error = glGetError()) != GL_NO_ERROR;) {
    if (!first) first = error;
    if (error == GL_CONTEXT_LOST) break;
  }
  if (!first) return;
  if (*first == GL_OUT_OF_MEMORY) throw DeviceError(Message("the device has not enough memory"));
  if (*first == GL_CONTEXT_LOST) throw lost();
  throw DeviceError(Message("the device's driver refused its work (OpenGL error {0})", *first));
}

}  // namespace gradmesh
