// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/preferences.h"

#include <QApplication>
#include <QButtonGroup>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QRadioButton>
#include <QSettings>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

#include "ui/controls/combo.h"
#include "ui/controls/fitted_dialog.h"
#include "ui/language/language.h"
#include "ui/style/scale.h"

namespace surefoot {

namespace {
constexpr const char* kReduceMotion = "reduceMotion";
}

Preferences readPreferences() {
  const QSettings settings;
  Preferences p;
  p.appearance = static_cast<Appearance>(std::clamp(settings.value("appearance", 0).toInt(), 0, 2));
  p.reduceMotion = settings.value(kReduceMotion, false).toBool();
  p.beginRunning = settings.value("beginRunning", true).toBool();
  p.autosaveMinutes = std::clamp(settings.value("autosaveMinutes", 1).toInt(), 1, 60);
  const double size = settings.value("textSize", 1.0).toDouble();
  p.textSize = std::isfinite(size) ? std::clamp(size, kSmallestText, kLargestText) : 1.0;
  p.language = settings.value("language").toString();
  qApp->setProperty(kReduceMotion, p.reduceMotion);
  return p;
}

void writePreferences(const Preferences& p) {
  QSettings settings;
  settings.setValue("appearance", static_cast<int>(p.appearance));
  settings.setValue(kReduceMotion, p.reduceMotion);
  settings.setValue("beginRunning", p.beginRunning);
  settings.setValue("autosaveMinutes", p.autosaveMinutes);
  settings.setValue("textSize", p.textSize);
  settings.setValue("language", p.language);
  qApp->setProperty(kReduceMotion, p.reduceMotion);
}

bool reducedMotion() {
  return qApp->property(kReduceMotion).toBool();
}

PreferencesDialog::PreferencesDialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Preferences"));
  const Preferences now = readPreferences();
  auto* body = new QWidget;
  auto* grid = new QGridLayout(body);
  whenScaled(this, [grid] {
    grid->setContentsMargins(scaled({24, 20, 24, 20}));
    grid->setHorizontalSpacing(scaled(24));
    grid->setVerticalSpacing(scaled(10));
  });
  int row = 0;
  const auto label = [&](const QString& text) { grid->addWidget(new QLabel(text), row, 0, Qt::AlignVCenter); };

  label(tr("Colours"));
  auto* group = new QButtonGroup(this);
  for (const auto& [text, appearance] : {std::pair{tr("those of the system"), Appearance::System},
                                         {tr("light"), Appearance::Light},
                                         {tr("dark"), Appearance::Dark}}) {
    auto* button = new QRadioButton(text);
    button->setAccessibleName(tr("Colours: %1").arg(text));
    button->setChecked(now.appearance == appearance);
    group->addButton(button);
    grid->addWidget(button, row++, 1);
    connect(button, &QRadioButton::clicked, this,
            [this, appearance = appearance] { change([&](Preferences& p) { p.appearance = appearance; }); });
  }
  label(tr("Language"));
  auto* language = new Combo(tr("Language"));
  language->addItem(tr("that of the system"), QString());
  for (const Language& one : languages()) language->addItem(one.name, one.code);
  language->setCurrentIndex(std::max(0, language->findData(now.language)));
  grid->addWidget(language, row++, 1, Qt::AlignLeft);
  auto* later = new QLabel(tr("From the next start on. Most sentences about errors are English."));
  later->setWordWrap(true);
  grid->addWidget(later, row++, 1);
  connect(language, &QComboBox::activated, this,
          [this, language] { change([&](Preferences& p) { p.language = language->currentData().toString(); }); });
  label(tr("Text size"));
  auto* sizes = new Combo(tr("Text size"));
  for (const int percent : {80, 90, 100, 110, 120, 130, 140, 150, 160, 170, 180, 190, 200})
    sizes->addItem(percent == 160 ? tr("160 %: projector") : tr("%1 %").arg(percent), percent / 100.0);
  sizes->setCurrentIndex(static_cast<int>(std::lround((now.textSize - kSmallestText) / kTextStep)));
  grid->addWidget(sizes, row++, 1, Qt::AlignLeft);
  connect(sizes, &QComboBox::activated, this,
          [this, sizes] { change([&](Preferences& p) { p.textSize = sizes->currentData().toDouble(); }); });
  const auto check = [&](const QString& text, bool on, bool Preferences::*member) {
    auto* box = new QCheckBox(text);
    box->setChecked(on);
    grid->addWidget(box, row++, 1);
    connect(box, &QCheckBox::toggled, this,
            [this, member](bool checked) { change([&](Preferences& p) { p.*member = checked; }); });
  };
  label(tr("Motion"));
  check(tr("less of it: no trail, no flash, a camera that stands,\nfalls shown frame by frame"), now.reduceMotion,
        &Preferences::reduceMotion);
  label(tr("At the start"));
  check(tr("learn as soon as the window is open"), now.beginRunning, &Preferences::beginRunning);

  label(tr("Safety copy"));
  auto* minutes = new QSpinBox;
  minutes->setRange(1, 60);
  minutes->setValue(now.autosaveMinutes);
  minutes->setPrefix(tr("every "));
  minutes->setSuffix(tr(" min; a crash loses no more"));
  minutes->setAccessibleName(tr("Minutes between two copies of the session on the disk"));
  grid->addWidget(minutes, row++, 1);
  connect(minutes, &QSpinBox::valueChanged, this,
          [this](int value) { change([&](Preferences& p) { p.autosaveMinutes = value; }); });

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* foot = new QWidget;
  auto* line = new QHBoxLayout(foot);
  line->addWidget(buttons);
  whenScaled(foot, [line] { line->setContentsMargins(scaled({24, 0, 24, 20})); });
  fillDialog(*this, body, foot);
}

void PreferencesDialog::change(const std::function<void(Preferences&)>& how) {
  Preferences p = readPreferences();
  how(p);
  writePreferences(p);
  Q_EMIT changed(p);
}

}  // namespace surefoot

#include "moc_preferences.cpp"
