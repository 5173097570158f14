// SPDX-License-Identifier: GPL-3.0-or-later
// The table is described in the System V ABI ("Procedure Linkage Table"): DT_JMPREL has a relocation for every function
// that the library calls in another one, with the name of the function and the place of its address.
#include "physics/world/box2d_binding.h"

#include <box2d/b2_timer.h>
#include <dlfcn.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <string_view>

// Our definitions under the names that the compiler gives them.
extern "C" {
void surefootTimer(b2Timer*) __asm__("_ZN7b2TimerC1Ev");
void surefootTimerReset(b2Timer*) __asm__("_ZN7b2Timer5ResetEv");
float surefootTimerTime(const b2Timer*) __asm__("_ZNK7b2Timer15GetMillisecondsEv");
void sincosf(float x, float* sine, float* cosine) noexcept;
}

namespace surefoot {

namespace {

struct Call {
  std::string_view name;
  void* ours;
  bool needed;  ///< without it there are other bits
};

template <class Function>
void* address(Function* function) {
  return reinterpret_cast<void*>(function);
}

const Call kCalls[] = {
    {"sinf", address(static_cast<float (*)(float)>(::sinf)), true},
    {"cosf", address(static_cast<float (*)(float)>(::cosf)), true},
    {"sincosf", address(::sincosf), true},
    {"_ZN7b2TimerC1Ev", address(surefootTimer), false},
    {"_ZN7b2Timer5ResetEv", address(surefootTimerReset), false},
    {"_ZNK7b2Timer15GetMillisecondsEv", address(surefootTimerTime), false},
};

/// What the dynamic section of a loaded library says.
struct Dynamic {
  const char* names = nullptr;
  const ElfW(Sym) * symbols = nullptr;
  const ElfW(Rela) * calls = nullptr;
  std::size_t count = 0;
  bool boundAtOnce = false;  ///< the table is for reading only

  explicit Dynamic(const link_map& library) {
    for (const ElfW(Dyn)* entry = library.l_ld; entry->d_tag != DT_NULL; ++entry) {
      const auto place = entry->d_un.d_ptr;
      if (entry->d_tag == DT_STRTAB) names = reinterpret_cast<const char*>(place);
      if (entry->d_tag == DT_SYMTAB) symbols = reinterpret_cast<const ElfW(Sym)*>(place);
      if (entry->d_tag == DT_JMPREL) calls = reinterpret_cast<const ElfW(Rela)*>(place);
      if (entry->d_tag == DT_PLTRELSZ) count = entry->d_un.d_val / sizeof(ElfW(Rela));
      if (entry->d_tag == DT_FLAGS) boundAtOnce |= (entry->d_un.d_val & DF_BIND_NOW) != 0;
      if (entry->d_tag == DT_FLAGS_1) boundAtOnce |= (entry->d_un.d_val & DF_1_NOW) != 0;
    }
  }
};

bool point(void** place, void* to, bool readOnly) {
  if (!readOnly) {
    *place = to;
    return true;
  }
  const auto size = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  auto* page = reinterpret_cast<void*>(reinterpret_cast<std::uintptr_t>(place) / size * size);
  if (mprotect(page, size, PROT_READ | PROT_WRITE) != 0) return false;
  *place = to;
  mprotect(page, size, PROT_READ);
  return true;
}

}  // namespace

Status bindBox2d() {
  const Error unbound{
      "Box2D: the libbox2d.so.2 of this process does not call sine and cosine as expected, so lives would "
      "have other bits; use the one of Debian.",
      ErrorKind::Mismatch};
  void* handle = dlopen("libbox2d.so.2", RTLD_NOW | RTLD_NOLOAD);
  if (!handle) return unbound;
  const auto& library = *static_cast<const link_map*>(handle);
  const Dynamic dynamic(library);
  if (!dynamic.names || !dynamic.symbols || !dynamic.calls) return unbound;
  for (const Call& call : kCalls) {
    bool found = false;
    for (std::size_t i = 0; i < dynamic.count; ++i) {
      const ElfW(Rela)& entry = dynamic.calls[i];
      const auto symbol = sizeof(void*) == 8 ? entry.r_info >> 32 : entry.r_info >> 8;
      if (dynamic.names + dynamic.symbols[symbol].st_name != call.name) continue;
      auto** place = reinterpret_cast<void**>(library.l_addr + entry.r_offset);
      found = point(place, call.ours, dynamic.boundAtOnce);
    }
    if (!found && call.needed) return unbound;
  }
  return Done{};
}

}  // namespace surefoot
