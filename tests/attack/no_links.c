/* SPDX-License-Identifier: GPL-3.0-or-later
   To be loaded before the C library: a file system without hard links, without files that have no name, and without a
   rename that refuses to replace (SMB, exFAT). */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>

int link(const char* from, const char* to) {
  (void)from, (void)to;
  errno = EPERM;
  return -1;
}
int linkat(int a, const char* from, int b, const char* to, int flags) {
  (void)a, (void)from, (void)b, (void)to, (void)flags;
  errno = EPERM;
  return -1;
}
int renameat2(int a, const char* from, int b, const char* to, unsigned flags) {
  int (*next)(int, const char*, int, const char*) = dlsym(RTLD_NEXT, "renameat");
  if (flags == 0) return next(a, from, b, to);
  errno = EINVAL;
  return -1;
}
int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const unsigned mode = va_arg(rest, unsigned);
  va_end(rest);
  int (*next)(const char*, int, ...) = dlsym(RTLD_NEXT, "open");
  if ((flags & O_TMPFILE) != O_TMPFILE) return next(path, flags, mode);
  errno = EOPNOTSUPP;
  return -1;
}
