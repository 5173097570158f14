// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/versions.h"

#include <fmt/format.h>
#include <nlopt.h>
#include <sqlite3.h>
#include <sys/utsname.h>
#include <toml++/impl/version.h>
#include <zlib.h>

#include <Eigen/src/Core/util/Macros.h>
#include <SQLiteCpp/SQLiteCpp.h>
#include <CLI/Version.hpp>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>

#include "core/basics/typed_json.h"
#include "core/basics/version.h"
#include "core/life/lives_version.h"
#include "physics/world/box2d_version.h"

namespace surefoot {

namespace {

std::string dotted(int major, int minor, int patch) {
  return fmt::format("{}.{}.{}", major, minor, patch);
}

std::string compilerVersion() {
#ifdef __clang__
  return fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  return fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

std::string systemVersion() {
  utsname name{};
  return uname(&name) == 0 ? fmt::format("{} {} {}", name.sysname, name.release, name.machine) : "";
}

std::string nloptVersion() {
  int major = 0, minor = 0, patch = 0;
  nlopt_version(&major, &minor, &patch);
  return dotted(major, minor, patch);
}

std::vector<PartVersion> ownVersions() {
  return {{"Surefoot", kVersion},
          {"lives", std::to_string(kLivesVersion)},
          {"compiler", compilerVersion()},
          {"system", systemVersion()}};
}

std::vector<PartVersion> libraryVersions() {
  std::vector<PartVersion> all = windowVersions();
  all.insert(
      all.end(),
      {{"Box2D", box2dVersion()},
       {"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
       {"SQLite", sqlite3_libversion()},
       {"SQLiteCpp", dotted(SQLITECPP_VERSION_NUMBER / 1'000'000, SQLITECPP_VERSION_NUMBER / 1000 % 1000,
                            SQLITECPP_VERSION_NUMBER % 1000)},
       {"NLopt", nloptVersion()},
       {"{fmt}", dotted(FMT_VERSION / 10'000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
       {"nlohmann/json", dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
       {"toml++", dotted(TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH)},
       {"CLI11", CLI11_VERSION},
       {"Boost", dotted(BOOST_VERSION / 100'000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
       {"zlib", zlibVersion()}});
  return all;
}

}  // namespace

std::vector<PartVersion> partVersions() {
  std::vector<PartVersion> all = ownVersions();
  const auto libraries = libraryVersions();
  all.insert(all.end(), libraries.begin(), libraries.end());
  return all;
}

std::string versionsAsJson() {
  nlohmann::ordered_json json;
  for (const PartVersion& part : ownVersions()) json[part.name == "Surefoot" ? "surefoot" : part.name] = part.version;
  json["lives"] = kLivesVersion;
  json["libraries"] = nlohmann::ordered_json::object();
  for (const PartVersion& part : libraryVersions()) json["libraries"][part.name] = part.version;
  return jsonText(json, 2) + "\n";
}

}  // namespace surefoot
