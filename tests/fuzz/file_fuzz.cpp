// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer target for everything that reads files: the bytes as a Q-function, a checkpoint and a journal. What the
// reader accepts is used: a learner is made from it and lives for some steps.
//   cmake -B build/fuzz -DSUREFOOT_FUZZ=ON -DCMAKE_CXX_COMPILER=clang++ -DSUREFOOT_UI=OFF
//   build/fuzz/tests/fuzz/file_fuzz -max_total_time=600 CORPUS tests/fuzz/corpus
#include "core/experiment/checkpoint.h"
#include "core/experiment/journal.h"
#include "core/experiment/q_file.h"

namespace {

using namespace surefoot;

const Registry& registry() {
  static const Registry filled = [] {
    Registry r;
    registerCore(r);
    return r;
  }();
  return filled;
}

void liveFor(Life& life, int steps) {
  for (int i = 0; i < steps && !life.finished(); ++i) life.step();
}

void begin(const std::shared_ptr<const TensorFile>& file) {
  auto configuration = configurationOf(registry(), *file);
  if (!configuration) return;
  beginWith(*configuration, file);
  if (const auto life = makeLife(registry(), *configuration, 0, false)) liveFor(**life, 20);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  if (const auto journal = parseJournal(registry(), bytes, "fuzz"); journal && !journal->configuration.start)
    if (const auto life = makeLife(registry(), journal->configuration, journal->life, false)) liveFor(**life, 20);

  auto parsed = TensorFile::parse(bytes, "fuzz");
  if (!parsed) return 0;
  const auto file = std::make_shared<const TensorFile>(std::move(*parsed));
  if (checkKind(*file, {"q-function", "checkpoint"})) begin(file);
  if (auto resumed = resume(registry(), file, {})) liveFor(*resumed->life, 20);
  return 0;
}
