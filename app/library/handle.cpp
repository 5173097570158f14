// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/library/handle.h"

#include <fmt/format.h>

#include <new>

#include "app/process/exit_code.h"

namespace surefoot {

std::string& lastError() {
  thread_local std::string sentence;
  return sentence;
}

surefoot_status refuse(surefoot_status status, std::string sentence) {
  lastError() = std::move(sentence);
  return status;
}

surefoot_status refuse(const Error& error) {
  std::string sentence = error.message;
  if (sentence.starts_with("--")) sentence.erase(0, 2);  // "--seed: …" is "seed: …" here
  return refuse(static_cast<surefoot_status>(exitCode(error.kind)), std::move(sentence));
}

surefoot_status refuseException() noexcept {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    lastError().assign("no memory");  // short: it fits into the text without any
  } catch (const std::exception& error) {
    try {
      lastError() = std::string("something went wrong that should not: ") + error.what() + ".";
    } catch (...) {
      lastError().assign("no memory");
    }
  } catch (...) {
    lastError().assign("unknown error");
  }
  return SUREFOOT_INTERNAL;
}

surefoot_status refuseBusy() {
  return refuse(SUREFOOT_BUSY, "another thread is inside this handle; one thread at a time may use it.");
}

Status checkArray(const void* array, std::size_t count, std::size_t needed, const char* name) {
  if (count != needed) return Error{fmt::format("{}: {} numbers are needed, not {}.", name, needed, count)};
  if (!array && needed > 0) return Error{fmt::format("{}: it is NULL.", name)};
  return Done{};
}

}  // namespace surefoot

unsigned surefoot_api(void) {
  return SUREFOOT_API;
}

const char* surefoot_last_error(void) {
  return surefoot::lastError().c_str();
}
