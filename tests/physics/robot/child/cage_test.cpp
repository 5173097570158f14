// SPDX-License-Identifier: GPL-3.0-or-later
// What a program in a cage can see: its own folder, the system and what programs need to run, and nothing else of the
// person who starts it.
#include "physics/robot/child/cage.h"

#include "physics/robot/child/cage_folders.h"
#include "physics/robot/child/process.h"
#include "tests/physics/robot/child/programs.h"

namespace surefoot {

namespace {

namespace fs = std::filesystem;

/// A variable of the environment, for as long as this lives.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* now = std::getenv(name)) before_ = now;
    setenv(name, value.c_str(), 1);
  }
  ~Variable() {
    if (before_)
      setenv(name_, before_->c_str(), 1);
    else
      unsetenv(name_);
  }
  Variable(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

/// A home as people have them, behind a symbolic link; the system's programs are in PATH, too.
struct Home {
  Home() {
    const fs::path real = folder.file("disk/ann");
    for (const char* one :
         {".local/bin", ".local/lib/python3.11", ".local/share/keyrings", ".cargo/bin", "conda/bin", "conda/lib",
          "conda/pkgs", ".pyenv/shims", ".pyenv/versions", "bin", "robots/car", "tools/bin", "tools/lib"})
      fs::create_directories(real / one);
    for (const char* one : {".cargo/credentials.toml", ".local/share/keyrings/login", "tools/bin/simulator", "letter"})
      std::ofstream(real / one) << "secret";
    fs::permissions(real / "tools/bin/simulator", fs::perms(0755));
    fs::create_symlink(real, folder.file("ann"));
    path = fs::canonical(real).string();
    home.emplace("HOME", folder.file("ann"));
    std::string list;
    for (const char* one : {".local/bin", ".cargo/bin", "conda/bin", ".pyenv/shims", "bin"})
      list += folder.file("ann") + "/" + one + ":";
    paths.emplace("PATH", list + std::getenv("PATH"));
  }

  Folder folder;
  std::string path;
  std::optional<Variable> home, paths;
};

/// What a cage shows of a home, by the paths in it.
std::set<std::string> shownOf(const Home& home, const std::string& program) {
  std::set<std::string> shown;
  for (const fs::path& one : shownFolders(program, home.path + "/robots/car", "").paths)
    if (one.string().starts_with(home.path)) shown.insert(one.string().substr(home.path.size()));
  return shown;
}

}  // namespace

TEST(Cage, ShowsOfAHomeOnlyWhatProgramsNeed) {
  const Home home;
  EXPECT_EQ(shownOf(home, home.path + "/tools/bin/simulator"),
            (std::set<std::string>{"/.cargo/bin", "/.local/bin", "/.local/lib", "/.pyenv", "/bin", "/conda/bin",
                                   "/conda/lib", "/robots/car", "/tools/bin", "/tools/lib"}));
  const ShownFolders all = shownFolders("python3", home.path + "/robots/car", "");
  EXPECT_TRUE(hiddenFolders().contains(home.path)) << "behind the link";
  EXPECT_EQ(all.links.at(home.folder.file("ann")), home.path) << "names of a home behind a link stay right";
}

TEST(Cage, ShowsNoHomeThatAVariableNames) {
  const Home home;
  for (const char* name : {"PATH", "PYTHONPATH", "VIRTUAL_ENV", "PYENV_ROOT", "CONDA_PREFIX", "LD_LIBRARY_PATH"})
    for (const std::string& folder : {home.path, home.folder.file("disk"), std::string("/")}) {
      const char* now = std::getenv(name);
      const Variable variable(name, folder + (now ? std::string(":") + now : ""));
      for (const fs::path& one : shownFolders("python3", home.path + "/robots/car", "").paths)
        EXPECT_NE(fs::relative(home.path + "/letter", one).begin()->string(), "letter") << name << " " << one;
    }
}

TEST(Cage, LibrariesThatLieElsewhereAreNotShown) {
  const Home home;
  fs::create_directories(home.path + "/robots/t/bin");
  fs::create_directory_symlink(home.path + "/.cargo", home.path + "/robots/t/lib");
  fs::copy("/bin/true", home.path + "/robots/t/bin/run");
  EXPECT_FALSE(shownOf(home, "../t/bin/run").contains("/.cargo"));
  EXPECT_TRUE(shownOf(home, "../t/bin/run").contains("/robots/t/bin"));
}

// As uv and python3 -m venv make them: a link to a link in a folder that is a link.
TEST(Cage, ShowsTheWayToAnInterpreterThroughAllItsLinks) {
  const Home home;
  fs::create_directories(home.path + "/store/python-3.11.7/bin");
  fs::copy("/bin/true", home.path + "/store/python-3.11.7/bin/python3.11");
  fs::create_symlink("python3.11", home.path + "/store/python-3.11.7/bin/python3");
  fs::create_directory_symlink("python-3.11.7", home.path + "/store/python-3.11");
  fs::create_directories(home.path + "/venv/bin");
  fs::create_symlink(home.path + "/store/python-3.11/bin/python3", home.path + "/venv/bin/python3");
  std::ofstream(home.path + "/venv/pyvenv.cfg") << "home = x";
  const ShownFolders all = shownFolders(home.path + "/venv/bin/python3", home.path + "/robots/car", "");
  for (const char* one : {"/venv/bin", "/venv/pyvenv.cfg", "/store/python-3.11.7/bin"})
    EXPECT_TRUE(all.paths.contains(home.path + one)) << one;
  EXPECT_EQ(all.links.at(home.path + "/store/python-3.11"), "python-3.11.7");
  if (!*hasCage()) return;
  const auto words = caged({home.path + "/venv/bin/python3"}, home.path + "/robots/car", "");
  ASSERT_TRUE(words) << words.error().message;
  const auto process = Process::start(*words, childEnvironment(""));
  ASSERT_TRUE(process);
  std::byte nothing{};
  static_cast<void>((*process)->read(std::span(&nothing, 1), Process::Clock::now() + std::chrono::seconds(20)));
  EXPECT_EQ((*process)->end(), "it ended with the exit code 0");
}

TEST(Cage, TakesNoFolderThatShowsAllOfAHome) {
  const Home home;
  const auto check = [&](const std::string& folder, const std::vector<std::string>& command) {
    return checkCageFolders(command, folder, shownFolders(command.front(), folder, ""));
  };
  EXPECT_TRUE(check(home.path + "/robots/car", {"python3", "car.py"}));
  EXPECT_TRUE(check(home.path + "/robots/car", {home.path + "/tools/bin/simulator", "--fast"}));
  const Status whole = check(home.path, {"python3", "car.py"});
  ASSERT_FALSE(whole);
  EXPECT_NE(whole.error().message.find("into a folder of their own"), std::string::npos) << whole.error().message;
  EXPECT_FALSE(check("/", {"python3", "car.py"}));
  const Status outside = check(home.path + "/robots/car", {"python3", "../../letter"});
  ASSERT_FALSE(outside);
  EXPECT_NE(outside.error().message.find("where a cage hides it"), std::string::npos) << outside.error().message;
}

TEST(Cage, AProgramReadsNothingElseAndWritesNowhereElse) {
  if (!*hasCage()) GTEST_SKIP() << "there is no bubblewrap, or it may not make cages here";
  const Home home;
  const std::string seen = home.folder.file("seen");
  const std::string look = R"(
import os, surefoot_child
HOME = os.environ["HOME"]
def reads(path):
    try:
        open(path).read()
        return True
    except OSError:
        return False
def writes(path):
    try:
        open(path, "w").write("x")
        return True
    except OSError:
        return False
class Look:
    def reset(self, random, parameters):
        self.seen = [reads("robot.py"), reads(HOME + "/.cargo/credentials.toml"), reads(HOME + "/letter"),
                     reads(HOME + "/.local/share/keyrings/login"), writes("robot.py"), writes("/tmp/x"),
                     writes("/var/tmp/x"), writes("/etc/x"), writes("/dev/x"),
                     os.access("/proc/sys/kernel/core_pattern", os.W_OK)]
        return [0, 0]
    def step(self, levels):
        raise RuntimeError(" ".join("+" if one else "-" for one in self.seen))
surefoot_child.serve(Look())
)";
  const ProgramHouse house(R"(["python3", "robot.py"])", look);
  const auto life = house.life();
  life->begin();
  life->step();
  EXPECT_NE(life->unanswered().find("RuntimeError: + - - - - + - - - -"), std::string::npos) << life->unanswered();
}

}  // namespace surefoot
