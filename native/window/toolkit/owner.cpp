#include "window/toolkit/owner.h"

#include <SDL.h>
#include <SDL_syswm.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#ifdef _WIN32
#include <windows.h>

#include <filesystem>
#endif

namespace gradmesh {
namespace {

/// Returns the one of some windows, from the foremost on, that is meant; none of them if none is.
template <class Window, class Title>
Window owner_among(const std::vector<Window>& windows, const Title& title_of,
                   const OwnerTitle& owner, Window none) {
  Window found = none;
  for (const Window window : windows) {
    const std::string title = title_of(window);
    if (!title.ends_with(owner.end)) continue;
    if (title.find(owner.part) != title.npos) return window;
    if (found == none) found = window;
  }
  return found;
}

#if defined(_WIN32)

std::string title_of(HWND window) {
  std::wstring title(std::size_t(GetWindowTextLengthW(window)) + 1, L'\0');
  title.resize(std::size_t(GetWindowTextW(window, title.data(), int(title.size()))));
  const std::u8string text = std::filesystem::path(title).u8string();
  return {text.begin(), text.end()};
}

/// Adds a window to those that a person sees.
BOOL CALLBACK add_window(HWND window, LPARAM windows) {
  if (IsWindowVisible(window)) reinterpret_cast<std::vector<HWND>*>(windows)->push_back(window);
  return TRUE;
}

void give(const SDL_SysWMinfo& info, const OwnerTitle& title) {
  // They come from the foremost on.
  std::vector<HWND> windows;
  EnumWindows(add_window, reinterpret_cast<LPARAM>(&windows));
  if (const HWND owner = owner_among(windows, title_of, title, HWND()))
    SetWindowLongPtrW(info.info.win.window, GWLP_HWNDPARENT, reinterpret_cast<LONG_PTR>(owner));
}

#elif defined(SDL_VIDEO_DRIVER_X11)

/// A function of Xlib, which is loaded when it is needed, as SDL does.
#define GRADMESH_XLIB(name) \
  decltype(&::name) name =  \
      reinterpret_cast<decltype(&::name)>(SDL_LoadFunction(library.get(), #name))

struct Xlib {
  std::unique_ptr<void, void (*)(void*)> library{SDL_LoadObject("libX11.so.6"), SDL_UnloadObject};
  GRADMESH_XLIB(XChangeProperty);
  GRADMESH_XLIB(XCreateWindow);
  GRADMESH_XLIB(XFree);
  GRADMESH_XLIB(XGetWindowProperty);
  GRADMESH_XLIB(XInternAtom);
  GRADMESH_XLIB(XMapRaised);
  GRADMESH_XLIB(XSetErrorHandler);
  GRADMESH_XLIB(XSetTransientForHint);
  GRADMESH_XLIB(XSync);
};

#undef GRADMESH_XLIB

/// What is asked of a display's windows.
class Windows {
 public:
  Windows(const Xlib& x, Display* display) : x_(x), display_(display) {}

  Atom atom(const char* name) const { return x_.XInternAtom(display_, name, False); }

  /// Returns the values of a property, of that many bits each; none where the window has none.
  template <class Value>
  std::vector<Value> values(Window window, const char* property, int bits) const {
    constexpr long most = 4096;
    Atom type = None;
    int found_bits = 0;
    unsigned long count = 0, left = 0;
    unsigned char* bytes = nullptr;
    if (x_.XGetWindowProperty(display_, window, atom(property), 0, most, False, AnyPropertyType,
                              &type, &found_bits, &count, &left, &bytes) != Success)
      return {};
    std::vector<Value> found;
    const auto* const first = reinterpret_cast<const Value*>(bytes);
    if (first && found_bits == bits) found.assign(first, first + count);
    if (bytes) x_.XFree(bytes);
    return found;
  }

  /// Returns the windows that a window manager tells of, from the foremost on.
  std::vector<Window> from_the_foremost() const {
    auto all = values<Window>(DefaultRootWindow(display_), "_NET_CLIENT_LIST_STACKING", 32);
    std::ranges::reverse(all);
    return all;
  }

  std::string title_of(Window window) const {
    const auto letters = values<char>(window, "_NET_WM_NAME", 8);
    return {letters.begin(), letters.end()};
  }

 private:
  const Xlib& x_;
  Display* const display_;
};

void give(const SDL_SysWMinfo& info, const OwnerTitle& title) {
  if (info.subsystem != SDL_SYSWM_X11) return;
  static const Xlib x;
  if (!x.library) return;
  Display* const display = info.info.x11.display;
  const Window window = info.info.x11.window;
  // Windows of others may go at any time.
  const auto before = x.XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
  const Windows windows(x, display);
  const Window owner = owner_among(
      windows.from_the_foremost(), [&](Window each) { return windows.title_of(each); }, title,
      Window(None));
  if (owner != None) {
    x.XSetTransientForHint(display, window, owner);
    const Atom states[] = {windows.atom("_NET_WM_STATE_MODAL"),
                           windows.atom("_NET_WM_STATE_SKIP_TASKBAR")};
    x.XChangeProperty(display, window, windows.atom("_NET_WM_STATE"), windows.atom("ATOM"), 32,
                      PropModeReplace, reinterpret_cast<const unsigned char*>(states), 2);
    // Lies unseen over all of the owner, and goes with the connection.
    constexpr unsigned beyond_any_screen = 32767;
    XSetWindowAttributes takes{};
    takes.event_mask = ButtonPressMask | ButtonReleaseMask | PointerMotionMask;
    const Window shield =
        x.XCreateWindow(display, owner, 0, 0, beyond_any_screen, beyond_any_screen, 0, 0, InputOnly,
                        nullptr, CWEventMask, &takes);
    x.XMapRaised(display, shield);
  }
  x.XSync(display, False);
  x.XSetErrorHandler(before);
}

#else

void give(const SDL_SysWMinfo&, const OwnerTitle&) {}

#endif

}  // namespace

void give_to(SDL_Window* window, const OwnerTitle& owner) {
  if (owner.end.empty()) return;
  SDL_SysWMinfo info;
  SDL_VERSION(&info.version);
  if (SDL_GetWindowWMInfo(window, &info)) give(info, owner);
}

}  // namespace gradmesh
