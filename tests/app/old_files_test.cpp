// SPDX-License-Identifier: GPL-3.0-or-later
// Files that Surefoot 0.1.0 wrote on its way (tests/app/old): `first`, before stores; `laboratory`, before lives
// had a number; `lessons`, with sessions and hand-ins. Each is read, or refused with a sentence that names the file,
// the version that wrote it, this one, and what can be done.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "app/process/exit_code.h"
#include "core/basics/version.h"
#include "tests/app/program.h"

namespace surefoot {

namespace {

struct OldFile {
  std::string file;     ///< below tests/app/old
  std::string command;  ///< with {} for the file
  int code = kDone;
  std::vector<std::string> words{};  ///< that it says
};

// What is refused at all is refused for its version.
const std::vector<std::string> kHint = {"Surefoot 0.1.0 wrote", kVersion, "`surefoot train --from FILE`"};
const std::vector<std::string> kOtherLives = {"Surefoot 0.1.0", "did not note its lives", kVersion, "--other-version"};

const std::vector<OldFile> kFiles = {
    // Tables and radial bases are laid out as they were; tiles of a state lie together now.
    {"first/cliff-table.safetensors", "train --load {} --episodes 2"},
    {"first/cliff-table.safetensors", "query {} --state 3,0"},
    {"first/car-radial.safetensors", "inspect {}"},
    {"first/car-radial.safetensors", "train --load {} --episodes 1"},
    {"first/chain-hashed.safetensors", "train --load {} --episodes 2", kFile, kHint},
    {"first/chain-hashed.safetensors", "train --from {} --episodes 2"},
    {"first/chain-sarsa-2q.safetensors", "inspect {}", kFile, kHint},
    {"first/chain-sarsa-2q.safetensors", "train --from {} --episodes 2"},
    {"first/cliff-checkpoint.safetensors", "train --resume {}", kFile, kOtherLives},
    {"first/cliff-checkpoint.safetensors", "train --resume {} --other-version", kFile, kHint},
    {"first/cliff-checkpoint.safetensors", "train --from {} --episodes 2", kDone, {"Surefoot 0.1.0", "left out"}},
    {"first/cliff-checkpoint.safetensors", "train --load {} --episodes 2"},
    {"first/cliff.jsonl", "replay {}", kDone, {"Surefoot 0.1.0", kVersion, "not the same life"}},
    {"first/cliff.jsonl", "replay {} --verify", kMismatch, {"Surefoot 0.1.0", "not the same life"}},
    {"first/cliff.jsonl", "train --from {}"},
    {"first/cliff.csv", "difference {} {}"},
    {"laboratory/cliff-table.safetensors", "train --load {} --episodes 2"},
    {"laboratory/chain-sarsa-2q.safetensors", "train --load {} --episodes 2"},
    {"laboratory/chain-hashed.safetensors", "train --load {} --episodes 2", kFile, kHint},
    {"laboratory/cliff-checkpoint.safetensors", "train --resume {}", kFile, kOtherLives},
    {"laboratory/cliff-checkpoint.safetensors", "inspect {}", kFile, kHint},
    {"laboratory/cliff-checkpoint.safetensors", "train --load {} --episodes 2"},
    {"laboratory/cliff.jsonl", "replay {} --verify"},
    {"laboratory/chain.jsonl", "replay {} --verify"},
    {"laboratory/cliff.csv", "difference {} {}"},
    {"laboratory/chain.sqlite", "statistics {}", kDone, {"an earlier version wrote it", "--resume"}},
    {"laboratory/chain.sqlite", "merge {} --out {}.new", kFile, {"--other-version"}},
    {"laboratory/chain.sqlite", "merge {} --out {}.new --other-version"},
    {"laboratory/plan.toml",
     "experiment {} --out $(dirname {})/chain.sqlite --resume",
     kFile,
     {kVersion, "--other-version"}},
    {"laboratory/plan.toml", "experiment {} --out $(dirname {})/chain.sqlite --resume --other-version"},
    {"lessons/cliff-table.safetensors", "train --load {} --episodes 2"},
    {"lessons/chain-hashed.safetensors", "train --load {} --episodes 2"},
    {"lessons/chain-sarsa-2q.safetensors", "train --load {} --episodes 2"},
    {"lessons/cliff-checkpoint.safetensors", "train --resume {} --episodes 30"},
    {"lessons/cliff.surefoot", "train --resume {} --episodes 300"},
    {"lessons/cliff.surefoot", "train --from {}"},
    {"lessons/cliff.jsonl", "replay {} --verify"},
    {"lessons/cliff.csv", "difference {} {}"},
    {"lessons/chain.sqlite", "statistics {}"},
    {"lessons/plan.toml", "experiment {} --dry-run"},
    {"lessons/06-the-cliff.toml", "lessons check {}"},
    {"lessons/class/05-taught.toml", "lessons grade $(dirname {})"},
    {"lessons/class/taught-Ada.jsonl", "lessons grade $(dirname {})", kDone, {"Ada", "taught", "yes"}},
    {"robots/acrobot.toml", "check {}"},
};

const std::string kOld = std::string(SUREFOOT_SOURCE) + "/tests/app/old/";

/// A copy, which the program may write beside.
std::string copied(const Folder& folder, const std::string& file) {
  namespace fs = std::filesystem;
  fs::create_directories(fs::path(folder.file(file)).parent_path());
  fs::copy(fs::path(kOld + file).parent_path(), fs::path(folder.file(file)).parent_path(), fs::copy_options::recursive);
  return folder.file(file);
}

std::string with(std::string command, const std::string& file) {
  for (auto at = command.find("{}"); at != std::string::npos; at = command.find("{}", at)) command.replace(at, 2, file);
  return command;
}

}  // namespace

TEST(OldFiles, AreReadOrRefusedWithWhatCanBeDone) {
  for (const OldFile& old : kFiles) {
    const Folder folder;
    const std::string file = copied(folder, old.file);
    const Finished done = surefoot(with(old.command, file));
    EXPECT_EQ(done.code, old.code) << old.command << " " << old.file << "\n" << done.err;
    for (const std::string& word : old.words)
      EXPECT_NE((done.err + done.out).find(word), std::string::npos) << old.command << " " << old.file << "\n"
                                                                     << done.err;
    if (old.code == kDone) continue;
    const std::string named = file.ends_with(".toml") ? "chain.sqlite:" : file + ":";
    EXPECT_NE(done.err.find(named), std::string::npos) << done.err;
    EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << "one sentence";
  }
}

TEST(OldFiles, EveryOneIsTried) {
  std::set<std::string> tried;
  for (const OldFile& old : kFiles) tried.insert(old.file);
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kOld)) {
    if (!entry.is_regular_file()) continue;
    bytes += entry.file_size();
    const std::string name = entry.path().string().substr(kOld.size());
    EXPECT_TRUE(tried.contains(name)) << name;
  }
  EXPECT_LT(bytes, 300'000u);
}

}  // namespace surefoot
