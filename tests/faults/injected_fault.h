// Makes the n-th allocation, or the n-th call that opens, reads, writes or names a file, fail: this test
// program's own operator new, and the C library's functions as this program and the C++ library call them.
//
// The work is done again and again, as in SQLite's tests, with n from 0 until nothing failed any more.
#pragma once

#include <cstddef>

namespace penumbra::faults {

enum class Kind {
  memory,  // operator new throws std::bad_alloc
  full,    // a write takes half of its bytes, then ENOSPC; so do other calls that change the disk
  broken,  // EIO of reads, writes, opens and all else
};

enum class Extent {
  once,       // what is tried again succeeds
  from_there  // every call from the n-th on fails
};

// While an object lives faults may happen, on any thread. Only one may live at a time.
class InjectedFault {
 public:
  InjectedFault(Kind kind, Extent extent, std::size_t number);
  ~InjectedFault();
  InjectedFault(const InjectedFault&) = delete;
  InjectedFault& operator=(const InjectedFault&) = delete;

  bool happened() const;
};

// While an object lives nothing fails on this thread: a test uses it for what it does besides.
class NoFault {
 public:
  NoFault();
  ~NoFault();
  NoFault(const NoFault&) = delete;
  NoFault& operator=(const NoFault&) = delete;
};

std::size_t open_files();  // descriptors of this process

}  // namespace penumbra::faults
