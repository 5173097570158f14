// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/toml_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/files/toml_parser.h"
#include "core/text/printable.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

namespace {

using Kind = TomlNode::Kind;

TextPlace placeOf(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

bool before(const TextPlace& a, const TextPlace& b) {
  return std::pair(a.line, a.column) < std::pair(b.line, b.column);
}

/// The place of a table is that of its first content; [name] stands in front of it.
std::optional<TomlNode> nodeOf(const toml::node& from, std::vector<Complaint>& complaints) {
  TomlNode node{.at = placeOf(from.source())};
  if (const auto* text = from.as_string()) {
    node.kind = Kind::Text, node.text = text->get();
  } else if (const auto* whole = from.as_integer()) {
    node.kind = Kind::Whole, node.whole = whole->get(), node.number = static_cast<double>(whole->get());
  } else if (const auto* number = from.as_floating_point()) {
    node.kind = Kind::Number, node.number = number->get();
  } else if (const auto* flag = from.as_boolean()) {
    node.kind = Kind::Flag, node.flag = flag->get();
  } else if (const auto* list = from.as_array()) {
    node.kind = Kind::List;
    for (const toml::node& element : *list)
      if (auto child = nodeOf(element, complaints)) node.list.push_back(std::move(*child));
  } else if (const auto* table = from.as_table()) {
    for (const auto& [key, value] : *table) {
      auto child = nodeOf(value, complaints);
      if (!child) continue;
      child->keyAt = placeOf(key.source());
      node.table.emplace_back(key.str(), std::move(*child));
    }
    std::stable_sort(node.table.begin(), node.table.end(),
                     [](const auto& a, const auto& b) { return before(a.second.at, b.second.at); });
  } else {
    complaints.push_back({node.at, "dates and times mean nothing here."});
    return std::nullopt;
  }
  return node;
}

std::string_view lineOf(std::string_view text, int line) {
  for (; line > 1; --line) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

/// "0,12": two numbers that a comma joins, and no list.
bool hasDecimalComma(std::string_view line) {
  const auto digit = [&](std::size_t at) {
    return at < line.size() && std::isdigit(static_cast<unsigned char>(line[at]));
  };
  const auto comma = line.find(',');
  return comma != std::string_view::npos && comma > 0 && digit(comma - 1) && digit(comma + 1) &&
         line.find('[') == std::string_view::npos;
}

/// "body.wheel" of "[body.wheel]", with how many brackets; nothing: the line is no heading.
std::optional<std::pair<std::string_view, std::size_t>> headingIn(std::string_view line) {
  const auto first = line.find_first_not_of(" \t");
  if (first == line.npos || line[first] != '[') return std::nullopt;
  const std::size_t brackets = line.substr(first).starts_with("[[") ? 2 : 1;
  const auto end = line.find(std::string_view("]]").substr(0, brackets), first);
  if (end == line.npos) return std::nullopt;
  return std::pair(line.substr(first + brackets, end - first - brackets), brackets);
}

/// The lines before line `at`, in one pass.
std::vector<std::string_view> linesBefore(std::string_view text, int at) {
  std::vector<std::string_view> lines;
  for (int line = 1; line < at; ++line) {
    const auto end = text.find('\n');
    lines.push_back(text.substr(0, end));
    if (end == text.npos) break;
    text.remove_prefix(end + 1);
  }
  return lines;
}

/// Why the parser does not take a heading: it is there already.
std::string aboutHeading(std::string_view text, int at) {
  constexpr const char* kNone = "a heading stands in brackets, [body.leg] or [[state]].";
  const auto here = headingIn(lineOf(text, at));
  if (!here) return kNone;
  const std::string name = printable(shortened(here->first));
  int line = 0;
  for (const std::string_view words : linesBefore(text, at)) {
    ++line;
    const auto other = headingIn(words);
    if (!other || other->first != here->first) continue;
    return other->second == 1 && here->second == 1
               ? fmt::format("[{}] stands in line {} already.", name, line)
               : fmt::format("line {} says {}; write [[{}]] for each of several.", line,
                             other->second == 1 ? "[" + name + "]" : "[[" + name + "]]", name);
  }
  return kNone;
}

/// Where the list begins that line `at` goes on with; 0: it goes on with none.
int openListBefore(std::string_view text, int at) {
  const auto lines = linesBefore(text, at);
  for (int line = static_cast<int>(lines.size()); line > 0; --line) {
    const std::string_view words = lines[static_cast<std::size_t>(line) - 1];
    const auto opens = words.find("= [");
    if (opens != words.npos && words.find(']', opens) == words.npos) return line;
    if (words.find_first_not_of(" \t\r") != words.npos) return 0;
  }
  return 0;
}

/// What the parser says, with its commonest cause. `at`: in which line.
std::string inOurWords(std::string_view sentence, std::string_view text, int at) {
  const std::string_view line = lineOf(text, at);
  const auto says = [&](std::string_view words) { return sentence.find(words) != std::string_view::npos; };
  if (hasDecimalComma(line)) return "a number has a point and no comma: 0.12.";
  if (says("unescaped control characters") || (says("string") && says("end-of-file")))
    return "a text begins in this line and has no closing quote.";
  if (const int open = openListBefore(text, at); open > 0) return fmt::format("the [ of line {} is not closed.", open);
  if (says("could not determine value type") || says("expected decimal digit") || says("expected digit"))
    return "this is no number; an expression stands in quotes, as in x = \"2 * r\".";
  if (says("table header")) return aboutHeading(text, at);
  if (says("expected comma or closing ']'")) return "a list has commas between its values and ends with ].";
  if (says("key-value pair") && (says("end-of-file") || says("expected '='")))
    return "a key is followed by = and a value.";
  if (sentence.find("expected a comment or whitespace") != std::string_view::npos)
    return "behind a value nothing but a comment is expected; a text that holds quotes goes between single quotes.";
  constexpr std::string_view kBegins = "Error while parsing ";
  if (sentence.starts_with(kBegins)) sentence.remove_prefix(kBegins.size());
  std::string said = printable(sentence.substr(0, 200));
  for (std::size_t end; (end = said.find('\n')) != std::string::npos;) said.replace(end, 1, "\\n");
  return fmt::format("this is no TOML: {}.", said);
}

}  // namespace

std::string complaintLine(const std::string& file, const Complaint& complaint) {
  std::string place = file;
  if (complaint.at.line > 0) place += fmt::format(":{}", complaint.at.line);
  if (complaint.at.column > 0) place += fmt::format(":{}", complaint.at.column);
  return fmt::format("{}: {}", place, complaint.sentence);
}

const TomlNode* TomlNode::find(std::string_view key) const {
  for (const auto& [name, node] : table)
    if (name == key) return &node;
  return nullptr;
}

std::optional<TomlNode> parseToml(std::string_view text, std::vector<Complaint>& complaints) {
  const auto root = parseLimitedToml(text);
  if (const auto* table = std::get_if<toml::table>(&root)) return nodeOf(*table, complaints);
  const auto& trouble = std::get<TomlTrouble>(root);
  complaints.push_back({{trouble.line, trouble.column}, inOurWords(trouble.sentence, text, trouble.line)});
  return std::nullopt;
}

const TomlNode* TomlReader::find(std::string_view key) {
  known_.emplace_back(key);
  return table_.find(key);
}

const TomlNode* TomlReader::need(std::string_view key) {
  const TomlNode* node = find(key);
  if (!node) complaints_.push_back({table_.at, fmt::format("{} is missing.", key)});
  return node;
}

void TomlReader::complain(std::string_view key, std::string sentence) {
  const TomlNode* node = table_.find(key);
  complaints_.push_back({node ? node->at : table_.at, fmt::format("{}: {}", key, sentence)});
}

const TomlNode* TomlReader::findKind(std::string_view key, Kind kind, const char* what) {
  const TomlNode* node = find(key);
  if (!node || node->kind == kind || (kind == Kind::Number && node->kind == Kind::Whole)) return node;
  complain(key, fmt::format("it takes {}.", what));
  return nullptr;
}

std::string TomlReader::text(std::string_view key, std::string otherwise) {
  const TomlNode* node = findKind(key, Kind::Text, "a text in quotes");
  return node ? node->text : std::move(otherwise);
}

std::string TomlReader::neededText(std::string_view key) {
  if (!need(key)) return {};
  std::string content = text(key);
  if (table_.find(key)->kind == Kind::Text && content.empty()) complain(key, "it is empty.");
  return content;
}

double TomlReader::number(std::string_view key, double low, double high, double otherwise) {
  const TomlNode* node = findKind(key, Kind::Number, "a number");
  if (!node) return otherwise;
  if (node->number >= low && node->number <= high) return node->number;
  complain(key, fmt::format("{} is not allowed; it takes {} to {}.", node->number, low, high));
  return otherwise;
}

std::int64_t TomlReader::whole(std::string_view key, std::int64_t low, std::int64_t high, std::int64_t otherwise) {
  const TomlNode* node = findKind(key, Kind::Whole, "a whole number");
  if (!node) return otherwise;
  if (node->whole >= low && node->whole <= high) return node->whole;
  complain(key, fmt::format("{} is not allowed; it takes {} to {}.", node->whole, low, high));
  return otherwise;
}

bool TomlReader::flag(std::string_view key, bool otherwise) {
  const TomlNode* node = findKind(key, Kind::Flag, "true or false");
  return node ? node->flag : otherwise;
}

std::vector<std::string> TomlReader::texts(std::string_view key) {
  std::vector<std::string> all;
  const TomlNode* node = findKind(key, Kind::List, "a list of texts");
  for (const TomlNode& element : node ? node->list : std::vector<TomlNode>{}) {
    if (element.kind == Kind::Text)
      all.push_back(element.text);
    else
      complaints_.push_back({element.at, fmt::format("{}: it takes texts in quotes.", key)});
  }
  return all;
}

std::vector<const TomlNode*> TomlReader::tables(std::string_view key) {
  std::vector<const TomlNode*> all;
  const TomlNode* node = find(key);
  if (!node) return all;
  if (node->kind == Kind::Table) return {node};
  for (const TomlNode& element : node->list) {
    if (element.kind != Kind::Table) return complain(key, "it takes tables."), std::vector<const TomlNode*>{};
    all.push_back(&element);
  }
  if (node->kind != Kind::List) complain(key, "it takes tables.");
  return all;
}

const TomlNode* TomlReader::table(std::string_view key) {
  return findKind(key, Kind::Table, "a table");
}

bool TomlReader::end() {
  bool known = true;
  for (const auto& [key, node] : table_.table) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    const std::string near = nearestWord(key, known_);
    complaints_.push_back({node.keyAt, fmt::format("there is no \"{}\" here{}.", printable(shortened(key)),
                                                   near.empty() ? "" : "; did you mean " + near)});
    known = false;
  }
  return known;
}

}  // namespace surefoot
