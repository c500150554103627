// operator new of the program: it throws std::bad_alloc where there is no memory, while that of mimalloc, a C
// library, ends the program. freeing_delete.cpp frees its memory. malloc() and free() are those of mimalloc
// where it is linked (penumbra_allocator).
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

void* found(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

// aligned_alloc() requires a size that is a multiple of the alignment.
void* aligned(std::size_t size, std::align_val_t alignment) noexcept {
  const auto step = static_cast<std::size_t>(alignment);
  const std::size_t rounded = (std::max<std::size_t>(size, 1) + step - 1) / step * step;
  return rounded < size ? nullptr : std::aligned_alloc(step, rounded);
}

}  // namespace

// NOLINTBEGIN(cppcoreguidelines-no-malloc): all other code calls these
void* operator new(std::size_t size) {
  return found(std::malloc(std::max<std::size_t>(size, 1)));
}
void* operator new[](std::size_t size) {
  return operator new(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return std::malloc(std::max<std::size_t>(size, 1));
}
void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept {
  return operator new(size, tag);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return found(aligned(size, alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return operator new(size, alignment);
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return aligned(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return aligned(size, alignment);
}
// NOLINTEND(cppcoreguidelines-no-malloc)
