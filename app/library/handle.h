// SPDX-License-Identifier: GPL-3.0-or-later
// What every call of the library goes through: nothing is thrown across it, a handle is used by one thread at a time,
// and an error leaves its sentence.
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "app/library/surefoot.h"
#include "core/basics/result.h"

namespace surefoot {

/// Part of every handle.
struct Handle {
  std::atomic<bool> used{false};  ///< a thread is inside
  std::string text{};             ///< what was handed out last
};

/// Whoever holds it is alone in the handle.
class Inside {
 public:
  explicit Inside(Handle& handle) : handle_(handle), alone_(!handle.used.exchange(true, std::memory_order_acquire)) {}
  Inside(const Inside&) = delete;
  ~Inside() {
    if (alone_) handle_.used.store(false, std::memory_order_release);
  }
  bool alone() const { return alone_; }

 private:
  Handle& handle_;
  bool alone_;
};

/// The sentence of this thread's last call.
std::string& lastError();
surefoot_status refuse(surefoot_status status, std::string sentence);
surefoot_status refuse(const Error& error);
/// Because of the exception that is being handled.
surefoot_status refuseException() noexcept;
surefoot_status refuseBusy();

/// A call without a handle: `work` returns a Status.
template <class Work>
surefoot_status call(const Work& work) noexcept {
  try {
    lastError().clear();
    const Status status = work();
    return status ? SUREFOOT_DONE : refuse(status.error());
  } catch (...) {
    return refuseException();
  }
}

/// A call with a handle, which messages call `name`.
template <class SomeHandle, class Work>
surefoot_status call(SomeHandle* handle, const char* name, const Work& work) noexcept {
  try {
    lastError().clear();
    if (!handle) return refuse(SUREFOOT_USAGE, std::string(name) + ": it is NULL.");
    const Inside inside(*handle);
    if (!inside.alone()) return refuseBusy();
    const Status status = work(*handle);
    return status ? SUREFOOT_DONE : refuse(status.error());
  } catch (...) {
    return refuseException();
  }
}

/// `place` ← what `make` makes; NULL where it makes nothing.
template <class SomeHandle, class Make>
surefoot_status makeHandle(SomeHandle** place, const Make& make) noexcept {
  return call([&]() -> Status {
    if (!place) return Error{"the place for the new handle: it is NULL."};
    *place = nullptr;
    Result<std::unique_ptr<SomeHandle>> made = make();
    if (!made) return made.error();
    *place = made->release();
    return Done{};
  });
}

template <class SomeHandle>
surefoot_status closeHandle(SomeHandle* handle) noexcept {
  try {
    lastError().clear();
    if (!handle) return SUREFOOT_DONE;
    if (handle->used.exchange(true, std::memory_order_acquire)) return refuseBusy();
    delete handle;
    return SUREFOOT_DONE;
  } catch (...) {
    return refuseException();
  }
}

/// Hands a text out, which the handle keeps.
inline Status handOut(Handle& handle, std::string text, const char** place) {
  if (!place) return Error{"the place for the text: it is NULL."};
  handle.text = std::move(text);
  *place = handle.text.c_str();
  return Done{};
}

/// A text that is not NULL.
inline Result<std::string> given(const char* text, const char* name) {
  if (!text) return Error{std::string(name) + ": it is NULL."};
  return std::string(text);
}

/// An array that is not NULL and has as many elements as are needed.
Status checkArray(const void* array, std::size_t count, std::size_t needed, const char* name);

}  // namespace surefoot
