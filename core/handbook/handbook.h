// SPDX-License-Identifier: GPL-3.0-or-later
// The handbook: pages that are written by hand (resources/handbook), and pages that are made from what the program
// declares, so that no method, parameter or command is without one. Any thread.
#pragma once

#include <span>

#include "core/basics/result.h"
#include "core/handbook/handbook_speech.h"
#include "core/handbook/page.h"
#include "core/registry.h"

namespace surefoot {

/// A command of the program, as its help has it.
struct CommandHelp {
  struct Item {
    std::string words{}, help{};  ///< "--seed N", and what it says
  };
  std::string name{}, summary{};
  std::string line{};    ///< "surefoot train [OPTIONS]"
  std::string remark{};  ///< may be empty
  std::vector<Item> options{}, examples{};
};

/// `folder`: with the written pages. An error names the file that cannot be read. Names of pages and anchors are the
/// same in every language; pages of commands are what `man` shows, in English.
Result<Handbook> makeHandbook(const Registry& registry, const std::string& folder,
                              const std::vector<CommandHelp>& commands, const HandbookSpeech& speech = {});

/// The sections, in the order in which they are read, in English.
std::span<const char* const> handbookSections();

/// The page that tells of a method ("method-trl"), a world, a parameter ("parameters-policy#policy.epsilon"; one of an
/// environment stands on the page of its world), a command.
std::string methodPage(std::string_view name);
std::string worldPage(std::string_view name);
std::string parameterPage(std::string_view key, std::string_view environment = "");
std::string commandPage(std::string_view name);

/// Links and pictures that lead nowhere: "first-steps: no-such-page". For the tests.
std::vector<std::string> brokenLinks(const Handbook& handbook, const std::string& pictures);

}  // namespace surefoot
