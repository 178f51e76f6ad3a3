// SPDX-License-Identifier: LGPL-3.0-or-later
#include "faulty_memory.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace gcv::faults {

long live = 0;
long until_fault = never;
long faults_left = 0;
bool failed = false;
bool failed_loudly = false;

}  // namespace gcv::faults

namespace {

using gcv::faults::failed;
using gcv::faults::failed_loudly;
using gcv::faults::faults_left;
using gcv::faults::live;
using gcv::faults::until_fault;

void* allocate(std::size_t size, std::size_t alignment) noexcept {
  if (until_fault > 0) {
    --until_fault;
  } else if (faults_left > 0) {
    --faults_left;
    failed = true;
    return nullptr;
  }
  // aligned_alloc takes multiples of the alignment.
  const std::size_t rounded = (std::max<std::size_t>(size, 1) + alignment - 1) & ~(alignment - 1);
  void* const block = rounded < size ? nullptr : std::aligned_alloc(alignment, rounded);
  live += block != nullptr ? 1 : 0;
  return block;
}

void* allocate_or_throw(std::size_t size, std::size_t alignment) {
  void* const block = allocate(size, alignment);
  if (block == nullptr) {
    failed_loudly = true;
    throw std::bad_alloc();
  }
  return block;
}

void release(void* block) noexcept {
  live -= block != nullptr ? 1 : 0;
  std::free(block);
}

constexpr std::size_t plain = __STDCPP_DEFAULT_NEW_ALIGNMENT__;
using Alignment = std::align_val_t;
using Quiet = std::nothrow_t;

std::size_t bytes(Alignment alignment) { return static_cast<std::size_t>(alignment); }

}  // namespace

void* operator new(std::size_t n) { return allocate_or_throw(n, plain); }
void* operator new[](std::size_t n) { return allocate_or_throw(n, plain); }
void* operator new(std::size_t n, Alignment a) { return allocate_or_throw(n, bytes(a)); }
void* operator new[](std::size_t n, Alignment a) { return allocate_or_throw(n, bytes(a)); }
void* operator new(std::size_t n, const Quiet&) noexcept { return allocate(n, plain); }
void* operator new[](std::size_t n, const Quiet&) noexcept { return allocate(n, plain); }
void* operator new(std::size_t n, Alignment a, const Quiet&) noexcept {
  return allocate(n, bytes(a));
}
void* operator new[](std::size_t n, Alignment a, const Quiet&) noexcept {
  return allocate(n, bytes(a));
}
void operator delete(void* block) noexcept { release(block); }
void operator delete[](void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, Alignment) noexcept { release(block); }
void operator delete[](void* block, Alignment) noexcept { release(block); }
void operator delete(void* block, std::size_t, Alignment) noexcept { release(block); }
void operator delete[](void* block, std::size_t, Alignment) noexcept { release(block); }
void operator delete(void* block, const Quiet&) noexcept { release(block); }
void operator delete[](void* block, const Quiet&) noexcept { release(block); }
void operator delete(void* block, Alignment, const Quiet&) noexcept { release(block); }
void operator delete[](void* block, Alignment, const Quiet&) noexcept { release(block); }
