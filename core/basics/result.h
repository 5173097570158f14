// SPDX-License-Identifier: GPL-3.0-or-later
// A value, or one plain sentence that says why there is none. For everything that comes from outside: arguments,
// files, numbers in a form. What the program itself guarantees is checked by expects() instead.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace surefoot {

/// The kind of an error; the program's exit codes are made from it (app/exit_code.h).
enum class ErrorKind { Usage, File, Diverged, Mismatch, Unanswered, Interrupted };

struct Error {
  std::string message;  ///< one sentence: the thing, the value given, the allowed values
  ErrorKind kind = ErrorKind::Usage;
};

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}
  Result(Error error) : content_(std::move(error)) {}

  explicit operator bool() const { return std::holds_alternative<T>(content_); }
  T& value() & { return std::get<T>(content_); }
  const T& value() const& { return std::get<T>(content_); }
  T&& value() && { return std::get<T>(std::move(content_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const { return std::get<Error>(content_); }

 private:
  std::variant<T, Error> content_;
};

/// Success without a value.
struct Done {};
using Status = Result<Done>;

}  // namespace surefoot
