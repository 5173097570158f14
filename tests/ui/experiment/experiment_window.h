// SPDX-License-Identifier: GPL-3.0-or-later
// A window at its Experiment page, for tests.
#pragma once

#include <QTemporaryDir>

#include "core/files/whole_file.h"
#include "tests/ui/window_setup.h"
#include "ui/experiment/experiment_page.h"

namespace surefoot {

using State = Experiment::State;

inline const std::string kPlan =
    "title = \"Two walks\"\nlives = 6\nreference = \"one\"\n[base]\nenvironment = \"cliff\"\nfeatures = \"table\"\n"
    "episodes = 200\n[[condition]]\nname = \"one\"\n[[condition]]\nname = \"two\"\npolicy = \"softmax\"\n";

inline const std::string kLongPlan =
    "lives = 1\nreference = \"one\"\n[base]\nminutes = 150\n[[condition]]\nname = \"one\"\n[[condition]]\n"
    "name = \"two\"\npolicy = \"softmax\"\n";

/// A window at its Experiment page, with a plan in a folder of its own.
struct ExperimentWindow : Window {
  explicit ExperimentWindow(const std::string& plan = kPlan) : page(window->experimentPage()) {
    path = folder.filePath("plan.toml");
    EXPECT_TRUE(writeWhole("plan", path.toStdString(), plan));
    window->setPage(1);
    page.open(path);
    EXPECT_TRUE(waitFor([&] { return !page.experiment().isOpening(); }));
    QObject::connect(&page, &ExperimentPage::refused, [this](const QString& why) { refusal = why.toStdString(); });
  }
  void runToTheEnd() {
    page.runOrPause();
    EXPECT_TRUE(waitFor([&] { return experiment().state() == State::Complete; }, 60'000)) << refusal;
  }
  Experiment& experiment() { return page.experiment(); }

  QTemporaryDir folder;
  QString path;
  std::string refusal;
  ExperimentPage& page;
};

}  // namespace surefoot
