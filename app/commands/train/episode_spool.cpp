// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/train/episode_spool.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace surefoot {

namespace {

bool writeAll(int descriptor, std::int64_t from, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = pwrite(descriptor, text.data(), text.size(), from);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    from += written;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool readAll(int descriptor, std::int64_t from, std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t got =
        pread(descriptor, text.data() + done, text.size() - done, from + static_cast<std::int64_t>(done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    done += static_cast<std::size_t>(got);
  }
  return true;
}

}  // namespace

EpisodeSpool::EpisodeSpool(const std::string& folder) {
  descriptor_ = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (descriptor_ >= 0) return;
  std::string name = folder + "/.surefoot-XXXXXX";
  descriptor_ = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ >= 0) unlink(name.c_str());
}

EpisodeSpool::~EpisodeSpool() {
  if (descriptor_ >= 0) close(descriptor_);
}

void EpisodeSpool::append(int life, std::string text) {
  if (text.empty()) return;
  const std::lock_guard lock(mutex_);
  if (descriptor_ >= 0 && writeAll(descriptor_, end_, text)) {
    parts_.push_back({.life = life, .from = end_, .length = text.size()});
    end_ += static_cast<std::int64_t>(text.size());
  } else {
    parts_.push_back({.life = life, .from = -1, .length = text.size(), .text = std::move(text)});
  }
}

Status EpisodeSpool::read(const std::function<Status(std::string_view part)>& take) {
  const std::lock_guard lock(mutex_);
  std::stable_sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.life < b.life; });
  std::string text;
  for (const Part& part : parts_) {
    if (part.from >= 0) {
      text.resize(part.length);
      if (!readAll(descriptor_, part.from, text))
        return Error{std::string("the rows of the log cannot be read again: ") + std::strerror(errno) + ".",
                     ErrorKind::File};
    }
    if (const Status s = take(part.from >= 0 ? text : part.text); !s) return s;
  }
  return Done{};
}

}  // namespace surefoot
