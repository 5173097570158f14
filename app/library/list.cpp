// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/library/handle.h"
#include "app/library/ours.h"
#include "app/reports/list_report.h"

surefoot_status surefoot_list(const char** json) {
  return surefoot::call([&]() -> surefoot::Status {
    thread_local std::string list;
    if (!json) return surefoot::Error{"the place for the text: it is NULL."};
    const auto registry = surefoot::ourRegistry();
    if (!registry) return registry.error();
    list = surefoot::listAsJson(**registry);
    *json = list.c_str();
    return surefoot::Done{};
  });
}
