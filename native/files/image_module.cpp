#include "files/image_module.h"

#include <string>

#include "base/error.h"

#ifdef _WIN32
#include <windows.h>

#include <array>
#include <filesystem>
#else
#include <dlfcn.h>
#endif

namespace gradmesh {
namespace {

constexpr const char* symbol_name = "gradmesh_image_codec";

[[noreturn]] void fail(const Message& why) {
  throw InputError("images cannot be read here: {0}.", why);
}

#ifdef _WIN32

/// Returns the folder of the program or library that this code is linked into.
std::filesystem::path own_folder() {
  HMODULE own = nullptr;
  GetModuleHandleExW(
      GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT,
      reinterpret_cast<LPCWSTR>(&own_folder), &own);
  std::array<wchar_t, 32768> name{};
  GetModuleFileNameW(own, name.data(), DWORD(name.size()));
  return std::filesystem::path(name.data()).parent_path();
}

const void* load() {
  // The folders that a RUNPATH names elsewhere: beside a Python module, in lib/gradmesh for the
  // program, and for both of them while they are in the build folder.
  for (const char* folder :
       {".", "../lib/gradmesh", "../../../gradmesh", "lib/gradmesh", "../../lib/gradmesh"}) {
    const auto path = (own_folder() / folder / "gradmesh_images.dll").lexically_normal();
    HMODULE module = LoadLibraryExW(path.c_str(), nullptr, LOAD_WITH_ALTERED_SEARCH_PATH);
    if (!module) continue;
    if (const auto symbol = GetProcAddress(module, symbol_name))
      return reinterpret_cast<const void*>(symbol);
  }
  fail(Message("gradmesh_images.dll cannot be loaded"));
}

#else

const void* load() {
#ifdef __APPLE__
  const char* name = "@rpath/gradmesh_images.so";
#else
  // A bare name is looked for in the RUNPATH of the program or library that this is linked into.
  const char* name = "gradmesh_images.so";
#endif
  void* module = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
  const void* symbol = module ? dlsym(module, symbol_name) : nullptr;
  if (!symbol) fail(Message("{0}", dlerror()));
  return symbol;
}

#endif

}  // namespace

const ImageCodec& image_codec() {
  static const ImageCodec& loaded = *static_cast<const ImageCodec*>(load());
  return loaded;
}

}  // namespace gradmesh
