// SPDX-License-Identifier: GPL-3.0-or-later
// What `statistics` and `export` say of few lives, of a reference without falls, and of names that are formulas.
#include "tests/app/program.h"

namespace surefoot {

namespace {

class Tables : public testing::Test {
 protected:
  std::string file(const std::string& name) const { return folder.file(name); }
  /// The store that a plan makes.
  std::string storeOf(const std::string& plan) const {
    std::ofstream(file("plan.toml")) << plan;
    const Finished run = surefoot("experiment " + file("plan.toml") + " --out " + file("store.sqlite"));
    EXPECT_EQ(run.code, 0) << run.err;
    return file("store.sqlite");
  }
  Folder folder;
};

}  // namespace

TEST_F(Tables, OneLifeHasNoIntervalInAnyForm) {
  const std::string store = storeOf(R"(lives = 1
reference = "a"
[base]
minutes = 0.5
[[condition]]
name = "a"
[[condition]]
name = "b"
policy = "softmax"
)");
  const auto b = run("statistics " + store)["conditions"][1];
  EXPECT_TRUE(b["falls"]["value"].is_number());
  EXPECT_TRUE(b["falls"]["low"].is_null());
  EXPECT_TRUE(b["against_reference"]["change_per_cent"]["value"].is_number());
  EXPECT_TRUE(b["against_reference"]["change_per_cent"]["low"].is_null());
  EXPECT_TRUE(b["against_reference"]["anova"].is_null());
  for (const char* form : {"", " --csv", " --latex"}) {
    const std::string out = surefoot("statistics " + store + form).out;
    EXPECT_EQ(out.find("nan"), std::string::npos) << out;
    EXPECT_EQ(out.find("±"), std::string::npos) << out;
    EXPECT_EQ(out.find("\\pm"), std::string::npos) << out;
  }
  EXPECT_EQ(surefoot("statistics " + store + " --json --csv").code, 2);
}

TEST_F(Tables, AReferenceWithoutFallsHasADifferenceInPlaceOfPerCent) {
  const std::string store = storeOf(R"(lives = 5
reference = "never falls"
[[condition]]
name = "never falls"
minutes = 0.0001
[[condition]]
name = "falls"
minutes = 0.1
)");
  const auto against = run("statistics " + store)["conditions"][1]["against_reference"];
  EXPECT_TRUE(against["change_per_cent"]["value"].is_null());
  EXPECT_GT(against["difference"]["low"], 0);
  for (const char* form : {"", " --json", " --csv", " --latex"}) {
    const std::string out = surefoot("statistics " + store + form).out;
    for (const char* odd : {"inf", "nan"}) EXPECT_EQ(out.find(odd), std::string::npos) << out;
  }
  EXPECT_NE(surefoot("statistics " + store).out.find(" falls (+"), std::string::npos);
}

TEST_F(Tables, TablesForSpreadsheetsHoldNoFormulas) {
  const std::string store = storeOf(R"(title = "Häßlich µ"
lives = 2
reference = '=HYPERLINK("http://x","y")'
[base]
minutes = 0.1
[[condition]]
name = '=HYPERLINK("http://x","y")'
[[condition]]
name = "-1+{policy.threshold}"
policy = "trl"
set.policy.threshold = [0, 50]
)");
  const std::string quoted = R"q("'=HYPERLINK(""http://x"",""y"")")q";
  ASSERT_EQ(surefoot("export " + store + " --csv " + file("plain")).code, 0);
  ASSERT_EQ(surefoot("export " + store + " --for-spreadsheets --csv " + file("marked")).code, 0);
  const std::string plain = contentOf(file("plain/conditions.csv"));
  EXPECT_NE(plain.find("\n0," + quoted + ","), std::string::npos) << plain;
  EXPECT_NE(plain.find("\n1,'-1+0,"), std::string::npos) << plain;
  const std::string table = surefoot("statistics " + store + " --csv").out;
  EXPECT_NE(table.find("\n" + quoted + "," + quoted + ","), std::string::npos) << table;
  for (const char* name : {"/conditions.csv", "/lives.csv", "/episodes.csv"})
    EXPECT_EQ(contentOf(file("marked") + name), "\xEF\xBB\xBF" + contentOf(file("plain") + name)) << name;
}

}  // namespace surefoot
