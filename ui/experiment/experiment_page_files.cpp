// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the Experiment page that opens, copies and writes.
#include <QClipboard>
#include <QGuiApplication>
#include <QPointer>
#include <QProgressDialog>
#include <QTimer>

#include "core/files/whole_file.h"
#include "core/store/csv_export.h"
#include "ui/experiment/experiment_page.h"
#include "ui/experiment/figures/figure_painter.h"
#include "ui/experiment/plan_editor.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/ask_for_file.h"

namespace surefoot {

void ExperimentPage::openWithDialog() {
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
    inBackground(
        tr("Writing the tables"), 0,
        [path = experiment_.storePath(), followed = experiment_.following() != nullptr, folder = folder.toStdString(),
         forSpreadsheets](std::atomic<int>&) -> Status {
          const auto store = followed ? Store::peek(path) : Store::open(path);
          return store ? surefoot::exportCsv(*store, folder, "folder", forSpreadsheets) : store.error();
        },
        tr("conditions.csv, lives.csv and episodes.csv are in %1.").arg(folder));
  });
}

void ExperimentPage::exportCharts() {
  if (!experiment_.view()) return Q_EMIT refused(tr("There is no chart yet; run the experiment first."));
  askForFolder(this, tr("Folder for the charts"), [this](const QString& folder) { writeCharts(folder); });
}

void ExperimentPage::writeCharts(const QString& folder) {
  const auto write = [&registry = experiment_.registry(), figures = experiment_.figures(), view = experiment_.view(),
                      claims = experiment_.claims(), theme = themeOf(*this),
                      folder = folder.toStdString()](std::atomic<int>& done) -> Status {
    for (const FigureSpec& spec : figures) {
      if (done < 0) break;  // cancelled
      if (const auto figure = figureOf(registry, spec, *view, claims)) {
        const std::string path = folder + "/" + figure->name;
        Status s = saveFigure(*figure, theme, path);
        if (s) s = writeWhole("chart", path + ".csv", figureAsCsv(*figure));
        if (!s) return s;
      }
      int before = done;
      while (before >= 0 && !done.compare_exchange_weak(before, before + 1)) {
      }
    }
    return Done{};
  };
  inBackground(tr("Drawing the charts"), static_cast<int>(experiment_.figures().size()), write,
               tr("Every chart is in %1, as PNG, SVG, PDF and CSV.").arg(folder));
}

/// Runs `work` behind a window that shows its progress and has a Cancel button; `done` below 0: cancelled. With 0
/// steps it cannot be cancelled.
void ExperimentPage::inBackground(const QString& what, int steps, std::function<Status(std::atomic<int>&)> work,
                                  const QString& then) {
  if (writing_.busy()) return Q_EMIT refused(tr("Something is being written; wait for its end."));
  auto done = std::make_shared<std::atomic<int>>(0);
  auto status = std::make_shared<Status>(Done{});
  auto* progress = new QProgressDialog(what, tr("Cancel"), 0, steps, this);
  progress->setAttribute(Qt::WA_DeleteOnClose);
  progress->setAutoClose(false);
  progress->setAutoReset(false);
  progress->setMinimumDuration(300);
  if (steps == 0) progress->setCancelButton(nullptr);
  connect(progress, &QProgressDialog::canceled, this, [done] { *done = -1; });
  auto* look = new QTimer(progress);
  connect(look, &QTimer::timeout, progress, [progress, done] {
    if (*done >= 0) progress->setValue(*done);
  });
  look->start(100);
  connect(&writing_, &Background::failed, progress, &QObject::deleteLater);
  writing_.start([done, status, work = std::move(work)](const std::atomic<bool>&) { *status = work(*done); },
                 [this, done, status, progress = QPointer<QProgressDialog>(progress), then] {
                   if (progress) progress->deleteLater();
                   if (!*status) return Q_EMIT refused(toText(status->error().message));
                   Q_EMIT told(*done < 0 ? tr("It was cancelled; what was written before is there.") : then);
                 });
}

}  // namespace surefoot
