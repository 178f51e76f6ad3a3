// SPDX-License-Identifier: LGPL-3.0-or-later
#include "refused_threads.hpp"

#include <dlfcn.h>
#include <pthread.h>

#include <cerrno>

namespace gcv::faults {

long threads_left = 0;
long threads_refused = 0;

}  // namespace gcv::faults

// The program's pthread_create is the one that all libraries call.
extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                              void* (*start)(void*), void* argument) noexcept {
  using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  if (gcv::faults::threads_left == 0) {
    ++gcv::faults::threads_refused;
    return EAGAIN;
  }
  --gcv::faults::threads_left;
  const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
  return create(thread, attributes, start, argument);
}
