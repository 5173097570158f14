// SPDX-License-Identifier: GPL-3.0-or-later
// View › Film…: made in the background, while the life goes on.
#include "ui/window/film_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include "tests/ui/film/filmed.h"
#include "tests/ui/pixels_of.h"
#include "tests/ui/window_setup.h"
#include "ui/live/live_page.h"

namespace surefoot {

namespace {

/// A window that has moved for a moment, and its dialog.
struct Filmed : Window {
  explicit Filmed(bool fallen = false) : Window("epsilon-greedy") {
    if (fallen) {
      session->life().setPace(8);
      session->life().setRunning(true);
      EXPECT_TRUE(waitFor([&] { return !session->looking().falls().empty(); }, 30'000));
    }
    session->life().setRunning(true);
    EXPECT_TRUE(waitFor([&] { return session->looking().recorded().seconds() > 0.5; }));
    if (fallen) session->looking().replayFall(0);
    open();
  }
  void open() {
    for (QAction* action : window->findChildren<QAction*>())
      if (action->text() == "Fil&m …") action->trigger();
    dialog = window->findChild<FilmDialog*>();
    ASSERT_TRUE(dialog);
    field<QSpinBox>("Width of the film")->setValue(128);
    field<QSpinBox>("Height of the film")->setValue(72);
  }
  template <class F>
  F* field(const char* name) {
    for (F* one : dialog->findChildren<F*>())
      if (one->accessibleName() == name) return one;
    ADD_FAILURE() << name;
    return nullptr;
  }
  QString words() const {
    QString all;
    for (const QLabel* label : dialog->findChildren<QLabel*>()) all += label->text() + '\n';
    return all;
  }
  Folder folder;
  FilmDialog* dialog = nullptr;
};

}  // namespace

TEST(FilmDialog, FilmsAPartOfTheLastMinutesWhileTheLifeGoesOn) {
  Filmed w;
  QStringList told;
  QObject::connect(w.dialog, &FilmDialog::made, [&](const QString& sentence) { told << sentence; });
  w.field<QDoubleSpinBox>("Film from")->setValue(0.1);
  w.field<QDoubleSpinBox>("Film up to")->setValue(0.4);
  EXPECT_TRUE(w.words().contains("A film of 0.3 s, in 9 pictures."));
  const std::int64_t steps = w.session->life().snapshot().steps;
  w.dialog->make(QString::fromStdString(w.folder.file("a.webp")));
  EXPECT_TRUE(w.dialog->busy());
  ASSERT_TRUE(w.waitFor([&] { return !w.dialog->busy(); }));
  ASSERT_EQ(told.size(), 1) << w.words().toStdString();
  EXPECT_TRUE(told[0].contains("a.webp")) << told[0].toStdString();
  EXPECT_FALSE(w.dialog->isVisible());
  const Decoded decoded = decodedWebp(w.folder.file("a.webp"));
  ASSERT_FALSE(decoded.pictures.empty());
  EXPECT_EQ(decoded.pictures[0].size(), QSize(128, 72));
  EXPECT_EQ(decoded.ends.back(), 300);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps > steps; }));
}

TEST(FilmDialog, FilmsTheReplayInHandToItsFall) {
  Filmed w(true);
  EXPECT_EQ(w.field<QComboBox>("What is filmed")->count(), 2);
  EXPECT_TRUE(w.field<QComboBox>("What is filmed")->currentText().contains("fall 1"));
  w.field<QComboBox>("Colours of the film")->setCurrentIndex(1);
  w.field<QSpinBox>("Width of the film")->setValue(480);
  w.field<QSpinBox>("Height of the film")->setValue(270);
  w.dialog->make(QString::fromStdString(w.folder.file("a.webp")));
  ASSERT_TRUE(w.waitFor([&] { return !w.dialog->busy(); }));
  const Decoded decoded = decodedWebp(w.folder.file("a.webp"));
  ASSERT_FALSE(decoded.pictures.empty()) << w.words().toStdString();
  EXPECT_EQ(decoded.pictures.back().pixelColor(0, 0), darkTheme().paper);
  EXPECT_GT(pixelsOf(decoded.pictures.back(), darkTheme().fall), pixelsOf(decoded.pictures[0], darkTheme().fall) + 100)
      << "it ends fallen";
}

// The strips of the Signals layout stand below, as in `surefoot rollout --film --strips`; without signals there are
// none.
TEST(FilmDialog, FilmsSignalsBelowThePicture) {
  Filmed w;
  EXPECT_FALSE(w.field<QCheckBox>("Signals below the picture")->isEnabled()) << "nobody looked at signals";
  w.dialog->reject();
  w.window->livePage().useLayout(LivePage::Layout::Signals);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->looking().recordedSignals().rows() > 40; }, 20'000));
  w.open();
  w.field<QSpinBox>("Width of the film")->setValue(480);
  w.field<QSpinBox>("Height of the film")->setValue(360);
  auto* below = w.field<QCheckBox>("Signals below the picture");
  ASSERT_TRUE(below->isEnabled());
  below->setChecked(true);
  const double end = w.field<QDoubleSpinBox>("Film up to")->value();
  w.field<QDoubleSpinBox>("Film from")->setValue(end - 0.3);
  w.dialog->make(QString::fromStdString(w.folder.file("a.webp")));
  ASSERT_TRUE(w.waitFor([&] { return !w.dialog->busy(); }));
  const Decoded decoded = decodedWebp(w.folder.file("a.webp"));
  ASSERT_GT(decoded.pictures.size(), 1u) << w.words().toStdString();
  const auto strips = [](const QImage& picture) { return picture.copy(0, 360 * 6 / 10, 480, 360 * 4 / 10); };
  const Theme& theme = themeOf(*w.window);
  EXPECT_EQ(strips(decoded.pictures[0]).pixelColor(1, 1), theme.panel);
  EXPECT_GT(pixelsOf(strips(decoded.pictures.back()), theme.ink), 30);
  EXPECT_NE(strips(decoded.pictures.front()), strips(decoded.pictures.back())) << "the cursor goes along";
}

TEST(FilmDialog, IsStoppedAndRefusedInWords) {
  Filmed w;
  const std::string path = w.folder.file("a.webp");
  w.dialog->make(QString::fromStdString(w.folder.file("a.avi")));
  EXPECT_TRUE(w.words().contains(".webp, .gif")) << w.words().toStdString();
  w.dialog->make("/nowhere/a.webp");
  EXPECT_TRUE(w.words().contains("/nowhere")) << w.words().toStdString();
  std::ofstream(path) << "mine";
  w.field<QSpinBox>("Width of the film")->setValue(3840);
  w.field<QSpinBox>("Height of the film")->setValue(2160);
  w.dialog->make(QString::fromStdString(path));
  ASSERT_TRUE(w.dialog->busy());
  w.dialog->reject();
  EXPECT_TRUE(w.dialog->isVisible()) << "the first time it stops the film";
  ASSERT_TRUE(w.waitFor([&] { return !w.dialog->busy(); }));
  EXPECT_EQ(contentOf(path), "mine");
  w.dialog->reject();
  EXPECT_FALSE(w.dialog->isVisible());
}

TEST(FilmDialog, DoesNotTouchTheLearner) {
  const auto hashOf = [](bool filming) {
    Window w("epsilon-greedy", 12'000);
    const Folder folder;
    w.session->life().setTurbo(true);
    w.session->life().setRunning(true);
    int films = 0;
    std::unique_ptr<FilmDialog> dialog;
    while (!w.session->life().finished()) {
      QTest::qWait(5);
      if (!filming || (dialog && dialog->busy()) || w.session->looking().recorded().seconds() < 0.3) continue;
      dialog = std::make_unique<FilmDialog>(w.session->life(), w.session->looking(), nullptr);
      dialog->make(QString::fromStdString(folder.file(std::to_string(++films) + ".webp")));
    }
    EXPECT_EQ(films > 0, filming);
    dialog.reset();
    return w.session->life().finish()->hash();
  };
  EXPECT_EQ(hashOf(false), hashOf(true));
}

}  // namespace surefoot
