// SPDX-License-Identifier: GPL-3.0-or-later
// The View menu: panels, layouts (also a person's own), colours, full screen; and the preferences.
#include <QActionGroup>
#include <QApplication>
#include <QInputDialog>
#include <QMenuBar>
#include <QSettings>
#include <cmath>

#include "ui/controls/message_bar.h"
#include "ui/controls/panel.h"
#include "ui/controls/preferences.h"
#include "ui/live/live_page.h"
#include "ui/live/world/world_view.h"
#include "ui/style/scale.h"
#include "ui/window/autosave.h"
#include "ui/window/main_window.h"

namespace surefoot {

namespace {

constexpr int kMostLayouts = 20;
constexpr int kLongestName = 40;

/// A name as a key of the settings; keys must not hold slashes.
QString keyOf(const QString& name) {
  return QStringLiteral("layouts/") + QString::fromLatin1(name.toUtf8().toPercentEncoding());
}

QStringList keptLayouts() {
  QSettings settings;
  settings.beginGroup("layouts");
  QStringList names;
  for (const QString& key : settings.childKeys())
    names << QString::fromUtf8(QByteArray::fromPercentEncoding(key.toLatin1()));
  return names;
}

}  // namespace

void MainWindow::makeViewMenu() {
  QMenu* view = menuBar()->addMenu(tr("&View"));
  const QString pages[] = {tr("&Live"), tr("&Experiment"), tr("Le&ssons"), tr("&Robot")};
  for (int page = 0; page <= kRobotPage; ++page)
    connect(addAction(view, pages[page], tr("The page %1").arg(QString(pages[page]).remove('&')),
                      QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + page))),
            &QAction::triggered, this, [this, page] { setPage(page); });
  view->addSeparator();
  for (Panel* panel : live_->panels()) view->addAction(panel->toggleViewAction());
  view->addSeparator();
  QMenu* layouts = view->addMenu(tr("La&youts"));
  for (const auto& [text, tip, layout] :
       {std::tuple{tr("&Usual"), tr("Every panel back in its place"), LivePage::Layout::Usual},
        {tr("&Teaching"), tr("What a step teaches, and the rule of thumb"), LivePage::Layout::Teaching},
        {tr("&Falls"), tr("The list of falls beside the charts"), LivePage::Layout::Falls},
        {tr("&Maps"), tr("The value maps large"), LivePage::Layout::Maps},
        {tr("&Signals"), tr("How the robot moves: strip charts, phase portrait, strides"), LivePage::Layout::Signals}})
    connect(addAction(layouts, text, tip, {}), &QAction::triggered, live_,
            [this, layout = layout] { live_->useLayout(layout); });
  layouts->addSeparator();
  connect(addAction(layouts, tr("&Keep this one as …"), tr("The panels as they are now, under a name"), {}),
          &QAction::triggered, this, &MainWindow::keepLayout);
  ownLayouts_ = layouts->addMenu(tr("&My own"));
  connect(ownLayouts_, &QMenu::aboutToShow, this, &MainWindow::fillLayouts);
  QAction* fit = addAction(view, tr("&Fit the world"), tr("The zoom that shows the whole world"), Qt::Key_Home);
  connect(fit, &QAction::triggered, this, [this] { live_->world().fit(); });
  QAction* film = addAction(view, tr("Fil&m …"), tr("The last minutes, or a replay, as a film"), {});
  connect(film, &QAction::triggered, this, &MainWindow::showFilm);
  connect(live_, &LivePage::filmAsked, this, &MainWindow::showFilm);
  for (QAction* action : {fit, film}) liveActions_.push_back(action);
  view->addSeparator();
  appearances_ = new QActionGroup(this);
  for (const auto& [text, appearance] :
       {std::pair{tr("Colours of the &system"), Appearance::System}, std::pair{tr("L&ight"), Appearance::Light},
        std::pair{tr("&Dark"), Appearance::Dark}}) {
    QAction* action = addAction(view, text, text, {});
    action->setCheckable(true);
    action->setData(static_cast<int>(appearance));
    appearances_->addAction(action);
    connect(action, &QAction::triggered, this, [this, appearance = appearance] {
      Preferences p = readPreferences();
      p.appearance = appearance;
      writePreferences(p);
      usePreferences(p);
    });
  }
  view->addSeparator();
  makeTextSizes(view);
  QAction* fullScreen = addAction(view, tr("F&ull screen"), tr("The whole screen"), Qt::Key_F11);
  fullScreen->setCheckable(true);
  connect(fullScreen, &QAction::toggled, this, [this](bool on) { on ? showFullScreen() : showNormal(); });
}

void MainWindow::makeTextSizes(QMenu* view) {
  QAction* projector =
      addAction(view, tr("&Projector"), tr("Everything as large as the last row of a lecture room needs it"), {});
  projector->setCheckable(true);
  connect(projector, &QAction::triggered, this, [this](bool on) { setTextSize(on ? kProjectorText : 1.0); });
  QMenu* menu = view->addMenu(tr("Te&xt size"));
  QAction* larger = addAction(menu, tr("&Larger"), tr("Larger text, controls and drawings"), {});
  larger->setShortcuts({QKeySequence(Qt::CTRL | Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Equal)});
  shortcuts_.push_back(larger);
  connect(larger, &QAction::triggered, this, [this] { setTextSize(textSize() + kTextStep); });
  connect(addAction(menu, tr("&Smaller"), tr("Smaller text, controls and drawings"), Qt::CTRL | Qt::Key_Minus),
          &QAction::triggered, this, [this] { setTextSize(textSize() - kTextStep); });
  connect(addAction(menu, tr("&Usual"), tr("Text, controls and drawings in their usual size"), Qt::CTRL | Qt::Key_0),
          &QAction::triggered, this, [this] { setTextSize(1.0); });
  menu->addSeparator();
  std::vector<QAction*> sizes;
  for (const int percent : {80, 100, 120, 140, 160, 180, 200}) {
    sizes.push_back(addAction(menu, tr("%1 %").arg(percent), tr("Everything at %1 %").arg(percent), {}));
    sizes.back()->setCheckable(true);
    sizes.back()->setData(percent);
    connect(sizes.back(), &QAction::triggered, this, [this, percent] { setTextSize(percent / 100.0); });
  }
  whenScaled(this, [projector, sizes] {
    const auto percent = static_cast<int>(std::lround(100 * textSize()));
    projector->setChecked(percent == std::lround(100 * kProjectorText));
    for (QAction* size : sizes) size->setChecked(size->data().toInt() == percent);
  });
}

void MainWindow::setTextSize(double size) {
  applyTextSize(size);
  Preferences p = readPreferences();
  p.textSize = textSize();
  writePreferences(p);
}

void MainWindow::keepLayout() {
  auto* dialog = new QInputDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Keep this layout"));
  dialog->setLabelText(tr("Its name:"));
  dialog->setMinimumWidth(scaled(360));
  connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& text) {
    const QString name = text.simplified();
    if (name.isEmpty() || name.size() > kLongestName)
      return messages_->say(tr("The name of a layout has 1 to %1 characters.").arg(kLongestName));
    if (!keptLayouts().contains(name) && keptLayouts().size() >= kMostLayouts)
      return messages_->say(tr("%1 layouts are kept already; forget one first.").arg(kMostLayouts));
    QSettings().setValue(keyOf(name), live_->layoutState());
    messages_->tell(tr("Kept as \"%1\", in the menu View, Layouts, My own.").arg(name));
  });
  dialog->open();
}

void MainWindow::fillLayouts() {
  ownLayouts_->clear();
  const QStringList names = keptLayouts();
  for (const QString& name : names)
    connect(ownLayouts_->addAction(QString(name).replace('&', "&&")), &QAction::triggered, this, [this, name] {
      if (!live_->restoreLayout(QSettings().value(keyOf(name)).toByteArray()))
        messages_->say(tr("The layout \"%1\" is one of another version; keep it anew.").arg(name));
    });
  if (names.isEmpty()) {
    ownLayouts_->addAction(tr("None kept yet"))->setEnabled(false);
    return;
  }
  ownLayouts_->addSeparator();
  QMenu* forget = ownLayouts_->addMenu(tr("&Forget"));
  for (const QString& name : names)
    connect(forget->addAction(QString(name).replace('&', "&&")), &QAction::triggered, this,
            [name] { QSettings().remove(keyOf(name)); });
}

void MainWindow::usePreferences(const Preferences& p) {
  for (QAction* action : appearances_->actions())
    action->setChecked(action->data().toInt() == static_cast<int>(p.appearance));
  if (p.appearance != appearance_) applyAppearance(*qApp, p.appearance);
  appearance_ = p.appearance;
  applyTextSize(p.textSize);
  if (autosave_) autosave_->setMinutes(p.autosaveMinutes);
}

void MainWindow::showPreferences() {
  auto* dialog = new PreferencesDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PreferencesDialog::changed, this, &MainWindow::usePreferences);
  dialog->open();
}

}  // namespace surefoot
