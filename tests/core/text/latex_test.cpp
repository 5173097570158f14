// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/latex.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/findings/findings.h"
#include "tests/folder.h"

namespace surefoot {

namespace {

/// What people, and people who want to see it break, call a condition.
const std::vector<std::string> kHardNames = {R"(\input{/etc/passwd})",
                                             R"(\end{document} & 100 % of $x_1^2$ #3 {a} ~ b)",
                                             "[0.5ex] -- ??` \"quotes\" <|>",
                                             "*starred*",
                                             "Häßlich µ Łódź naïve Ærø ÿ ő ş",
                                             "Q⁻ 12 / 6 / 1, α⁺ = 0.7, τ ≥ .5 − ε₀, x₁₂, qₙ, R², ∞ → ½",
                                             "α\u0307 = α\u0308, e\u0301",
                                             "γλΩ ∑ ± × ÷ … „so“ – — ‘x’",
                                             "漢字 😀 кот",
                                             "\xFF\xC3 broken",
                                             "=HYPERLINK(\"http://x\",\"y\")",
                                             "tab\tline\nend"};

Findings findingsWith(const std::vector<std::string>& names) {
  Findings findings;
  for (const std::string& name : names) {
    Finding& f = findings.conditions.emplace_back();
    f.name = name;
    f.falls = {12.5, 10, 15};
    Comparison& c = f.comparison.emplace();
    c.change = {-45, -55, -32};
    c.anova = TestResult{30, 1, 8, 3.1e-5};
  }
  return findings;
}

}  // namespace

TEST(Latex, CommandsBecomeText) {
  EXPECT_EQ(latexText("a & 5 % of $x_1$ #3 {b}"), "a \\& 5 \\% of \\$x\\_1\\$ \\#3 \\{b\\}");
  EXPECT_EQ(latexText("\\input{x}"), "\\textbackslash{}input\\{x\\}");
  EXPECT_EQ(latexText("~^"), "\\textasciitilde{}\\textasciicircum{}");
  EXPECT_EQ(latexText("TRL-50"), "TRL-50");
  EXPECT_EQ(latexText("a--b"), "a-{}-b") << "two hyphens are no dash";
}

TEST(Latex, WhatIsNotAsciiIsSpelled) {
  EXPECT_EQ(latexText("ε ≥ −1"), "$\\varepsilon$ $\\geq$ $-$1");
  EXPECT_EQ(latexText("Äé ß"), "\\\"{A}\\'{e} \\ss{}");
  EXPECT_EQ(latexText("µ = μ"), "$\\mu$ = $\\mu$");
  EXPECT_EQ(latexText("Q⁻₁₂ₙ"), "Q$^{-}$$_{1}$$_{2}$$_{n}$");
  EXPECT_EQ(latexText("α\u0307"), "$\\dot{\\alpha}$");
  EXPECT_EQ(latexText("😀"), "U+1F600");
  EXPECT_EQ(latexText("\xFF"), "?");
  for (const std::string& name : kHardNames)
    for (const char c : latexText(name)) EXPECT_TRUE(c >= ' ' && c <= '~') << name;
}

TEST(Latex, ATableCompilesAsItIs) {
  if (std::system("pdflatex --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "pdflatex is not installed";
  const Folder folder;
  Findings findings = findingsWith(kHardNames);
  findings.conditions[0].comparison.reset();        // a reference
  findings.conditions[1].falls.low = std::nan("");  // of one life
  findings.conditions[1].comparison->change = {-45, std::nan(""), std::nan("")};
  findings.conditions[1].comparison->anova.reset();
  findings.conditions[2].comparison->change.value = std::nan("");  // of a reference without falls
  findings.conditions[2].comparison->difference = {2.4, 1, 3.8};
  const std::string table = findingsAsLatex(findings);
  EXPECT_EQ(table.find("nan"), std::string::npos) << table;
  std::ofstream(folder.file("t.tex")) << "\\documentclass{article}\n\\begin{document}\n"
                                      << table << "\\end{document}\n";
  const std::string options = "-no-shell-escape -interaction=nonstopmode -halt-on-error";
  const int status = std::system(("cd " + folder.file("") + " && pdflatex " + options + " t.tex >out 2>&1").c_str());
  std::ifstream log(folder.file("t.log"));
  const std::string words{std::istreambuf_iterator<char>(log), {}};
  EXPECT_EQ(status, 0) << words << table;
  EXPECT_EQ(words.find("Missing character"), std::string::npos) << words;
  EXPECT_GT(std::filesystem::file_size(folder.file("t.pdf")), 1000u);
}

}  // namespace surefoot
