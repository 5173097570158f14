// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/latex.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <vector>
namespace surefoot {

namespace {

/// Of ASCII: commands, and what stands for another letter in LaTeX's own fonts.
const std::map<char32_t, const char*> kAscii = {{U'&', "\\&"},
                                                {U'%', "\\%"},
                                                {U'$', "\\$"},
                                                {U'#', "\\#"},
                                                {U'_', "\\_"},
                                                {U'{', "\\{"},
                                                {U'}', "\\}"},
                                                {U'<', "$<$"},
                                                {U'>', "$>$"},
                                                {U'|', "$|$"},
                                                {U'"', "''"},
                                                {U'[', "{[}"},
                                                {U']', "{]}"},
                                                {U'*', "{*}"},
                                                {U'\t', " "},
                                                {U'\n', " "},
                                                {U'\r', " "},
                                                {U'\\', "\\textbackslash{}"},
                                                {U'~', "\\textasciitilde{}"},
                                                {U'^', "\\textasciicircum{}"}};

const std::map<char32_t, const char*> kLetters = {{U'α', "$\\alpha$"},
                                                  {U'β', "$\\beta$"},
                                                  {U'γ', "$\\gamma$"},
                                                  {U'δ', "$\\delta$"},
                                                  {U'ε', "$\\varepsilon$"},
                                                  {U'ϵ', "$\\epsilon$"},
                                                  {U'ζ', "$\\zeta$"},
                                                  {U'η', "$\\eta$"},
                                                  {U'θ', "$\\theta$"},
                                                  {U'ϑ', "$\\vartheta$"},
                                                  {U'ι', "$\\iota$"},
                                                  {U'κ', "$\\kappa$"},
                                                  {U'λ', "$\\lambda$"},
                                                  {U'μ', "$\\mu$"},
                                                  {U'µ', "$\\mu$"},
                                                  {U'ν', "$\\nu$"},
                                                  {U'ξ', "$\\xi$"},
                                                  {U'ο', "o"},
                                                  {U'π', "$\\pi$"},
                                                  {U'ρ', "$\\rho$"},
                                                  {U'ς', "$\\varsigma$"},
                                                  {U'σ', "$\\sigma$"},
                                                  {U'τ', "$\\tau$"},
                                                  {U'υ', "$\\upsilon$"},
                                                  {U'φ', "$\\varphi$"},
                                                  {U'ϕ', "$\\phi$"},
                                                  {U'χ', "$\\chi$"},
                                                  {U'ψ', "$\\psi$"},
                                                  {U'ω', "$\\omega$"},
                                                  {U'Α', "A"},
                                                  {U'Β', "B"},
                                                  {U'Γ', "$\\Gamma$"},
                                                  {U'Δ', "$\\Delta$"},
                                                  {U'Ε', "E"},
                                                  {U'Ζ', "Z"},
                                                  {U'Η', "H"},
                                                  {U'Θ', "$\\Theta$"},
                                                  {U'Ι', "I"},
                                                  {U'Κ', "K"},
                                                  {U'Λ', "$\\Lambda$"},
                                                  {U'Μ', "M"},
                                                  {U'Ν', "N"},
                                                  {U'Ξ', "$\\Xi$"},
                                                  {U'Ο', "O"},
                                                  {U'Π', "$\\Pi$"},
                                                  {U'Ρ', "P"},
                                                  {U'Σ', "$\\Sigma$"},
                                                  {U'Τ', "T"},
                                                  {U'Υ', "$\\Upsilon$"},
                                                  {U'Φ', "$\\Phi$"},
                                                  {U'Χ', "X"},
                                                  {U'Ψ', "$\\Psi$"},
                                                  {U'Ω', "$\\Omega$"},
                                                  {U'Ω', "$\\Omega$"},
                                                  {U'ß', "\\ss{}"},
                                                  {U'æ', "\\ae{}"},
                                                  {U'Æ', "\\AE{}"},
                                                  {U'ø', "\\o{}"},
                                                  {U'Ø', "\\O{}"},
                                                  {U'å', "\\aa{}"},
                                                  {U'Å', "\\AA{}"},
                                                  {U'ł', "\\l{}"},
                                                  {U'Ł', "\\L{}"},
                                                  {U'œ', "\\oe{}"},
                                                  {U'Œ', "\\OE{}"},
                                                  {U'ı', "\\i{}"},
                                                  {U'ℓ', "$\\ell$"},
                                                  {U'ħ', "$\\hbar$"}};

const std::map<char32_t, const char*> kSigns = {{U'−', "$-$"},
                                                {U'±', "$\\pm$"},
                                                {U'×', "$\\times$"},
                                                {U'÷', "$\\div$"},
                                                {U'·', "$\\cdot$"},
                                                {U'≤', "$\\leq$"},
                                                {U'≥', "$\\geq$"},
                                                {U'≠', "$\\neq$"},
                                                {U'≈', "$\\approx$"},
                                                {U'∞', "$\\infty$"},
                                                {U'→', "$\\to$"},
                                                {U'←', "$\\leftarrow$"},
                                                {U'↔', "$\\leftrightarrow$"},
                                                {U'⇒', "$\\Rightarrow$"},
                                                {U'√', "$\\surd$"},
                                                {U'∑', "$\\sum$"},
                                                {U'∂', "$\\partial$"},
                                                {U'∈', "$\\in$"},
                                                {U'°', "$^{\\circ}$"},
                                                {U'′', "$'$"},
                                                {U'″', "$''$"},
                                                {U'•', "$\\bullet$"},
                                                {U'–', "--"},
                                                {U'—', "---"},
                                                {U'‐', "-{}"},
                                                {U'‑', "-{}"},
                                                {U'…', "\\dots{}"},
                                                {U'‘', "`{}"},
                                                {U'’', "'{}"},
                                                {U'“', "``"},
                                                {U'”', "''"},
                                                {U'„', ",,"},
                                                {U'§', "\\S{}"},
                                                {U'¶', "\\P{}"},
                                                {U'£', "\\pounds{}"},
                                                {U'©', "\\copyright{}"},
                                                {U'¡', "!`"},
                                                {U'¿', "?`"},
                                                {U'½', "$1/2$"},
                                                {U'¼', "$1/4$"},
                                                {U'¾', "$3/4$"},
                                                {U'\u00A0', "~"},
                                                {U'\u2009', "\\,"},
                                                {U'\u202F', "\\,"},
                                                {U'\uFFFD', "?"},
                                                {U'✕', "$\\times$"},
                                                {U'∗', "$*$"},
                                                {U'⁺', "$^{+}$"},
                                                {U'⁻', "$^{-}$"},
                                                {U'⁼', "$^{=}$"},
                                                {U'⁽', "$^{(}$"},
                                                {U'⁾', "$^{)}$"},
                                                {U'ⁿ', "$^{n}$"},
                                                {U'ⁱ', "$^{i}$"},
                                                {U'₊', "$_{+}$"},
                                                {U'₋', "$_{-}$"},
                                                {U'₌', "$_{=}$"},
                                                {U'₍', "$_{(}$"},
                                                {U'₎', "$_{)}$"}};

constexpr std::u32string_view kSubscripts = U"ₐₑₒₓₕₖₗₘₙₚₛₜᵢᵣᵤᵥⱼ", kTheirLetters = U"aeoxhklmnpstiruvj";

/// Accents that follow their letter as a character of their own.
struct Combining {
  char32_t accent;
  const char *inText, *inMath;
};
constexpr Combining kCombining[] = {
    {0x0300, "\\`", "\\grave"},    {0x0301, "\\'", "\\acute"}, {0x0302, "\\^", "\\hat"}, {0x0303, "\\~", "\\tilde"},
    {0x0304, "\\=", "\\bar"},      {0x0306, "\\u", "\\breve"}, {0x0307, "\\.", "\\dot"}, {0x0308, "\\\"", "\\ddot"},
    {0x030A, "\\r", "\\mathring"}, {0x030C, "\\v", "\\check"}};

/// Latin letters with accents, in the order of their letters, one list an accent.
struct Accented {
  const char* command;
  std::u32string_view with, without;
};
constexpr Accented kAccents[] = {{"\\`", U"ÀÈÌÒÙàèìòùǸǹ", U"AEIOUaeiouNn"},
                                 {"\\'", U"ÁÉÍÓÚÝáéíóúýĆćĹĺŃńŔŕŚśŹź", U"AEIOUYaeiouyCcLlNnRrSsZz"},
                                 {"\\^", U"ÂÊÎÔÛâêîôûĈĉĜĝĤĥĴĵŜŝŴŵŶŷ", U"AEIOUaeiouCcGgHhJjSsWwYy"},
                                 {"\\~", U"ÃÑÕãñõĨĩŨũ", U"ANOanoIiUu"},
                                 {"\\\"", U"ÄËÏÖÜäëïöüÿŸ", U"AEIOUaeiouyY"},
                                 {"\\=", U"ĀāĒēĪīŌōŪū", U"AaEeIiOoUu"},
                                 {"\\u", U"ĂăĔĕĞğĬĭŎŏŬŭ", U"AaEeGgIiOoUu"},
                                 {"\\.", U"ĊċĖėĠġİŻżȦȧ", U"CcEeGgIZzAa"},
                                 {"\\v", U"ČčĎďĚěŇňŘřŠšŤťŽžǍǎ", U"CcDdEeNnRrSsTtZzAa"},
                                 {"\\c", U"ÇçĢģĶķĻļŅņŖŗŞşŢţ", U"CcGgKkLlNnRrSsTt"},
                                 {"\\H", U"ŐőŰű", U"OoUu"},
                                 {"\\r", U"Ůů", U"Uu"}};

std::string accented(char32_t c) {
  for (const Accented& a : kAccents)
    if (const auto place = a.with.find(c); place < a.without.size())
      return fmt::format("{}{{{}}}", a.command, static_cast<char>(a.without[place]));
  return "";
}

std::string latexOf(char32_t c) {
  for (const auto* list : {&kAscii, &kLetters, &kSigns})
    if (const auto found = list->find(c); found != list->end()) return found->second;
  if (c < 0x20 || c == 0x7F || c == 0xFEFF || (c >= 0x200B && c <= 0x200F)) return "";
  if (c < 0x7F) return {static_cast<char>(c)};
  if (const std::string letter = accented(c); !letter.empty()) return letter;
  if (const auto place = kSubscripts.find(c); place != kSubscripts.npos)
    return fmt::format("$_{{{}}}$", static_cast<char>(kTheirLetters[place]));
  if (c >= U'₀' && c <= U'₉') return fmt::format("$_{{{}}}$", static_cast<int>(c - U'₀'));
  if (c == U'⁰' || (c >= U'⁴' && c <= U'⁹')) return fmt::format("$^{{{}}}$", static_cast<int>(c - U'⁰'));
  if (c == U'²' || c == U'³') return c == U'²' ? "$^{2}$" : "$^{3}$";
  if (c == U'¹') return "$^{1}$";
  return fmt::format("U+{:04X}", static_cast<std::uint32_t>(c));
}

/// "α" and a dot → "$\dot{\alpha}$".
std::string withAccent(const std::string& letter, const Combining& c) {
  if (letter.empty()) return "";
  if (!letter.starts_with('$')) return fmt::format("{}{{{}}}", c.inText, letter);
  return fmt::format("${}{{{}}}$", c.inMath, letter.substr(1, letter.size() - 2));
}

/// UTF-8 as characters; a byte that is none of it as U+FFFD.
std::u32string charactersOf(std::string_view text) {
  std::u32string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i++]);
    const int more = first < 0x80 ? 0 : first >= 0xC2 && first < 0xE0 ? 1 : first >= 0xE0 && first < 0xF0 ? 2 : 3;
    bool sound = first < 0x80 || (first >= 0xC2 && first < 0xF5);
    char32_t c = more == 0 ? first : first & (0x3F >> more);
    for (int k = 0; sound && k < more; ++k) {
      sound = i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
      if (sound) c = c << 6 | (static_cast<unsigned char>(text[i++]) & 0x3F);
    }
    out += sound ? c : U'\uFFFD';
  }
  return out;
}

/// "--", "``" and the like would become one sign.
bool joins(char32_t c, char32_t next) {
  if (c == U'?' || c == U'!') return next == U'`';
  return c == next && (c == U'-' || c == U'`' || c == U'\'' || c == U',');
}

}  // namespace

std::string latexText(std::string_view text) {
  std::vector<std::string> pieces;
  const std::u32string characters = charactersOf(text);
  for (std::size_t i = 0; i < characters.size(); ++i) {
    const char32_t c = characters[i];
    const auto* accent =
        std::find_if(std::begin(kCombining), std::end(kCombining), [&](const Combining& a) { return a.accent == c; });
    if (accent != std::end(kCombining) && !pieces.empty()) {
      pieces.back() = withAccent(pieces.back(), *accent);
      continue;
    }
    pieces.push_back(latexOf(c));
    if (i + 1 < characters.size() && joins(c, characters[i + 1])) pieces.back() += "{}";
  }
  return fmt::format("{}", fmt::join(pieces, ""));
}

}  // namespace surefoot
