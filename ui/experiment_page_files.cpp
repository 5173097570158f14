// SPDX-License-Identifier: GPL-3.0-or-later
// What the Experiment page opens, copies and writes.
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>

#include "core/files/whole_file.h"
#include "core/laboratory/csv_export.h"
#include "ui/ask_for_file.h"
#include "ui/experiment_page.h"
#include "ui/figure_view.h"
#include "ui/plan_editor.h"
#include "ui/symbol_text.h"

namespace surefoot {

void ExperimentPage::openWithDialog() {
  source_->setCurrentIndex(source_->findData(toText(experiment_.path())));
  askForFile(this, tr("Open a plan or results"), tr("Plans and results (*.toml *.sqlite);;All files (*)"),
             [this](const QString& path) { open(path); });
}

void ExperimentPage::savePlanAs() {
  askForNewFile(this, tr("Save the plan"), QStringLiteral("plan.toml"), tr("Plans (*.toml)"), QStringLiteral("toml"),
                [this](const QString& path) {
                  const std::string text =
                      editor_->text().isEmpty() ? experiment_.text() : editor_->text().toStdString();
                  if (const Status s = writeWhole("plan", path.toStdString(), text); !s)
                    Q_EMIT refused(toText(s.error().message));
                  else
                    Q_EMIT told(tr("The plan is in %1.").arg(path));
                });
}

void ExperimentPage::copyCsv() {
  if (!experiment_.view()) return Q_EMIT refused(tr("There is nothing to copy yet; run the experiment first."));
  QGuiApplication::clipboard()->setText(toText(findingsAsCsv(experiment_.view()->findings)));
  Q_EMIT told(tr("The table is on the clipboard, as CSV."));
}

void ExperimentPage::copyLatex() {
  if (!experiment_.view()) return Q_EMIT refused(tr("There is nothing to copy yet; run the experiment first."));
  QGuiApplication::clipboard()->setText(toText(findingsAsLatex(experiment_.view()->findings)));
  Q_EMIT told(tr("The table is on the clipboard, as LaTeX."));
}

void ExperimentPage::exportCsv() {
  exportTables(false);
}

void ExperimentPage::exportForSpreadsheets() {
  exportTables(true);
}

void ExperimentPage::exportTables(bool forSpreadsheets) {
  if (experiment_.storePath().empty() || experiment_.state() == Experiment::State::Running)
    return Q_EMIT refused(tr("Results can be exported when the experiment is complete or paused."));
  askForFolder(this, tr("Folder for the tables"), [this, forSpreadsheets](const QString& folder) {
    const auto store = Store::open(experiment_.storePath());
    const Status written =
        store ? surefoot::exportCsv(*store, folder.toStdString(), "folder", forSpreadsheets) : store.error();
    if (!written)
      Q_EMIT refused(toText(written.error().message));
    else
      Q_EMIT told(tr("conditions.csv, lives.csv and episodes.csv are in %1.").arg(folder));
  });
}

void ExperimentPage::exportCharts() {
  if (!experiment_.view()) return Q_EMIT refused(tr("There is no chart yet; run the experiment first."));
  askForFolder(this, tr("Folder for the charts"), [this](const QString& folder) { writeCharts(folder); });
}

void ExperimentPage::writeCharts(const QString& folder) {
  for (const FigureSpec& spec : experiment_.figures()) {
    const auto figure = experiment_.figure(spec);
    if (!figure) continue;
    const std::string path = folder.toStdString() + "/" + figure->name;
    Status s = FigureView(*figure).save(path);
    if (s) s = writeWhole("chart", path + ".csv", figureAsCsv(*figure));
    if (!s) return Q_EMIT refused(toText(s.error().message));
  }
  Q_EMIT told(tr("Every chart is in %1, as PNG, PDF and CSV.").arg(folder));
}

}  // namespace surefoot
