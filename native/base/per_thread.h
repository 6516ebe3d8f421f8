#pragma once

#ifdef __MINGW32__
#include <pthread.h>

#include <memory>
#include <new>
#endif

namespace gradmesh {

/// Returns this thread's own T, which is made when the thread first asks and kept until it ends.
/// Another `Tag` is another object.
template <class T, class Tag = T>
T& per_thread() {
#ifdef __MINGW32__
  // As a thread ends there, the memory of a thread_local is freed before the destructor runs (GCC's
  // bug 80816). The destructor's fault then leaves a lock of the threads' library held for good.
  static const pthread_key_t key = [] {
    pthread_key_t made;
    if (pthread_key_create(&made, [](void* object) { delete static_cast<T*>(object); }) != 0)
      throw std::bad_alloc();
    return made;
  }();
  if (void* const object = pthread_getspecific(key)) return *static_cast<T*>(object);
  auto object = std::make_unique<T>();
  if (pthread_setspecific(key, object.get()) != 0) throw std::bad_alloc();
  return *object.release();
#else
  static thread_local T object;
  return object;
#endif
}

}  // namespace gradmesh
