// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/film_dialog.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>
#include <optional>

#include "core/experiment/configuration.h"
#include "ui/controls/combo.h"
#include "ui/controls/decimal_box.h"
#include "ui/controls/fitted_dialog.h"
#include "ui/film/film_writer.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/ask_for_file.h"
#include "ui/support/counted.h"
#include "ui/support/plain_text.h"

namespace surefoot {

namespace {

constexpr double kUsualSeconds = 20;  // of the last minutes
constexpr double kLeastSeconds = 0.1;
constexpr int kEveryMs = 100;  // between two looks at the progress
constexpr double kShares[] = {1.0, 0.5, 0.25};

/// A number with a name and a unit.
template <class Field>
Field* makeField(const QString& name, const QString& suffix) {
  auto* field = new Field;
  field->setAccessibleName(name);
  field->setSuffix(suffix);
  return field;
}

QWidget* rowOf(std::initializer_list<QWidget*> parts) {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  for (QWidget* part : parts) row->addWidget(part);
  row->addStretch(1);
  whenScaled(box, [row] { row->setSpacing(scaled(8)); });
  return box;
}

/// A row more, with a title.
void addRow(QGridLayout* grid, const QString& title, QWidget* field) {
  const int row = grid->rowCount();
  grid->addWidget(new QLabel(title), row, 0);
  grid->addWidget(field, row, 1);
}

QString picturesText(std::int64_t number) {
  return counted(number, FilmDialog::tr("%1 pictures", nullptr, forms(number)));
}

}  // namespace

FilmDialog::FilmDialog(const RunningLife& life, const Looking& looking, QWidget* parent)
    : QDialog(parent),
      life_(life) {
  setWindowTitle(tr("Film"));
  const Playback* replay = looking.playback();
  const auto add = [this](const QString& title, Footage footage, const SignalTable& signals, double begin = 0.0) {
    sources_.push_back({title, std::move(footage), std::make_shared<const SignalTable>(signals), begin});
  };
  if (replay) add(replay->title, footageOf(*replay), replay->signals, replay->begin / replay->realRate);
  // One whose start is not known is of the last minutes already.
  if (!replay || replay->start) add(tr("the last minutes"), looking.recorded(), looking.recordedSignals());
  std::erase_if(sources_, [](const Source& source) { return source.footage.seconds() < kLeastSeconds; });
  auto* body = new QWidget;
  auto* grid = new QGridLayout(body);
  makePart(grid);
  makeLook(grid);
  makeWords(grid);
  whenScaled(this, [grid] {
    grid->setContentsMargins(scaled({24, 20, 24, 12}));
    grid->setHorizontalSpacing(scaled(24));
    grid->setVerticalSpacing(scaled(10));
  });
  QWidget* foot = makeFoot();
  choose();
  fillDialog(*this, body, foot);
  connect(&watch_, &QTimer::timeout, this, &FilmDialog::refresh);
  connect(&making_, &Background::busyChanged, this, &FilmDialog::refresh);
  connect(&making_, &Background::failed, words_, &QLabel::setText);
}

void FilmDialog::makePart(QGridLayout* grid) {
  source_ = new Combo(tr("What is filmed"));
  for (const Source& source : sources_) source_->addItem(source.title);
  connect(source_, &QComboBox::activated, this, &FilmDialog::choose);
  addRow(grid, tr("Of"), source_);

  from_ = makeField<DecimalBox>(tr("Film from"), tr(" s"));
  to_ = makeField<DecimalBox>(tr("Film up to"), tr(" s"));
  for (QDoubleSpinBox* field : {from_, to_}) {
    field->setDecimals(1);
    connect(field, &QDoubleSpinBox::valueChanged, this, &FilmDialog::refresh);
  }
  addRow(grid, tr("From"), rowOf({from_, new QLabel(tr("to")), to_}));

  speed_ = new Combo(tr("Speed of the film"));
  for (const QString& text : {tr("as it was"), tr("half"), tr("a quarter")}) speed_->addItem(text);
  connect(speed_, &QComboBox::activated, this, &FilmDialog::refresh);
  addRow(grid, tr("Speed"), rowOf({speed_}));
}

void FilmDialog::makeLook(QGridLayout* grid) {
  width_ = makeField<QSpinBox>(tr("Width of the film"), {});
  height_ = makeField<QSpinBox>(tr("Height of the film"), {});
  for (QSpinBox* field : {width_, height_}) {
    field->setRange(kLeastFilmSide, kMostFilmSide);
    field->setSingleStep(2);
  }
  width_->setValue(kUsualFilmSize.width());
  height_->setValue(kUsualFilmSize.height());
  addRow(grid, tr("Size"), rowOf({width_, new QLabel(tr("×")), height_, new QLabel(tr("pixels"))}));

  colours_ = new Combo(tr("Colours of the film"));
  colours_->addItem(tr("light"));
  colours_->addItem(tr("dark"));
  colours_->setCurrentIndex(themeOf(*this).dark ? 1 : 0);
  addRow(grid, tr("Colours"), rowOf({colours_}));

  signals_ = new QCheckBox(tr("below the picture"));
  signals_->setAccessibleName(tr("Signals below the picture"));
  addRow(grid, tr("Signals"), rowOf({signals_}));
}

void FilmDialog::makeWords(QGridLayout* grid) {
  words_ = new QLabel;
  words_->setWordWrap(true);
  whenScaled(words_, [this] { words_->setMinimumSize(scaled(380), 3 * QFontMetrics(scaledFont(13)).lineSpacing()); });
  grid->addWidget(words_, grid->rowCount(), 0, 1, 2);
  progress_ = new QProgressBar;
  progress_->setAccessibleName(tr("Progress of the film"));
  progress_->setTextVisible(false);
  grid->addWidget(progress_, grid->rowCount(), 0, 1, 2);
  grid->setRowStretch(grid->rowCount(), 1);
}

QWidget* FilmDialog::makeFoot() {
  make_ = new QPushButton(tr("Make the film …"));
  cancel_ = new QPushButton(tr("Cancel"));
  make_->setDefault(true);
  connect(make_, &QPushButton::clicked, this, &FilmDialog::askForPath);
  connect(cancel_, &QPushButton::clicked, this, &FilmDialog::reject);
  auto* foot = new QWidget;
  auto* line = new QHBoxLayout(foot);
  line->addStretch(1);
  line->addWidget(make_);
  line->addWidget(cancel_);
  whenScaled(foot, [line] { line->setContentsMargins(scaled({24, 0, 24, 20})); });
  return foot;
}

/// Another source: what a replay plays, the end of the last minutes.
void FilmDialog::choose() {
  const int at = source_->currentIndex();
  const Source none, &source = at < 0 ? none : sources_[static_cast<std::size_t>(at)];
  const double seconds = source.footage.seconds();
  for (QDoubleSpinBox* field : {from_, to_}) field->setRange(0, seconds);
  to_->setValue(seconds);
  from_->setValue(std::max(source.begin, seconds - kUsualSeconds));
  refresh();
}

QSize FilmDialog::size() const {
  return {width_->value(), height_->value()};
}

Footage FilmDialog::chosen() const {
  const Source& source = sources_[static_cast<std::size_t>(source_->currentIndex())];
  return cut(source.footage, from_->value(), to_->value(), kShares[speed_->currentIndex()]);
}

bool FilmDialog::hasSignals() const {
  const int at = source_->currentIndex();
  return at >= 0 && sources_[static_cast<std::size_t>(at)].signals->rows() > 0;
}

StripsBelow FilmDialog::below() const {
  if (!signals_->isChecked() || !hasSignals()) return {};
  const auto& table = sources_[static_cast<std::size_t>(source_->currentIndex())].signals;
  return {table, chosenStrips(life_.configuration().names.environment, table->signals())};
}

void FilmDialog::refresh() {
  const bool busy = making_.busy(), some = !sources_.empty() && to_->value() > from_->value();
  for (QWidget* field : std::initializer_list<QWidget*>{source_, from_, to_, speed_, width_, height_, colours_})
    field->setEnabled(!busy);
  const bool written = hasSignals();
  signals_->setEnabled(!busy && written);
  signals_->setToolTip(tipText(written ? tr("The strips of the Signals layout, with a cursor that goes along")
                                       : tr("None were written down: they are while the Signals layout is shown")));
  make_->setEnabled(some && !busy);
  cancel_->setText(busy ? tr("Stop") : tr("Cancel"));
  progress_->setVisible(busy);
  if (busy) {
    progress_->setValue(static_cast<int>(*done_));
    return words_->setText(tr("%1 of %2 pictures. The life goes on meanwhile.").arg(*done_).arg(progress_->maximum()));
  }
  watch_.stop();
  if (!some)
    return words_->setText(sources_.empty() ? tr("There is nothing to film yet: nothing has moved in the window.")
                                            : tr("A film ends after it begins."));
  const double seconds = (to_->value() - from_->value()) / kShares[speed_->currentIndex()];
  words_->setText(tr("A film of %1 s, in %2.%3")
                      .arg(fixedNumber(seconds, 1), picturesText(filmFrames(seconds)),
                           ffmpegProgram().empty()
                               ? tr(" WebP only: all others are made by the program ffmpeg, which is "
                                    "not installed.")
                               : QString()));
}

void FilmDialog::askForPath() {
  QStringList filters;
  for (const FilmKind& kind : filmKinds())
    if (!kind.byFfmpeg() || !ffmpegProgram().empty())
      filters << QStringLiteral("%1 (*%2)").arg(fromCore(kind.title), toText(kind.ending));
  askForNewFile(this, tr("Make the film"), "film.webp", filters.join(";;"), "webp",
                [this](const QString& path) { make(path); });
}

void FilmDialog::make(const QString& path) {
  if (!make_->isEnabled()) return;
  const auto refuse = [this](const Error& error) { words_->setText(toText(error.message)); };
  Footage footage = chosen();
  const auto frames = static_cast<std::int64_t>(footage.poses.size());
  const auto kind = checkFilm("film", path.toStdString(), size(), frames);
  if (!kind) return refuse(kind.error());
  auto file = WholeFile::createOrReplace("film", path.toStdString());
  if (!file) return refuse(file.error());
  auto environment = makeEnvironment(life_.registry(), life_.configuration());
  if (!environment) return refuse(environment.error());
  paint(filmOf(std::move(*environment), std::move(footage), below(), size(),
               colours_->currentIndex() == 1 ? darkTheme() : lightTheme()),
        *kind, std::move(*file), path);
}

void FilmDialog::paint(const Film& film, const FilmKind& kind, WholeFile file, const QString& path) {
  progress_->setRange(0, static_cast<int>(film.frames));
  done_ = std::make_shared<std::atomic<std::int64_t>>(0);
  const auto status = std::make_shared<std::optional<Status>>();
  const auto claimed = std::make_shared<WholeFile>(std::move(file));
  watch_.start(kEveryMs);
  making_.start(
      [=, done = done_](const std::atomic<bool>& interrupted) {
        *status = writeFilm("film", film, kind, std::move(*claimed), interrupted, [&](std::int64_t n) { *done = n; });
      },
      [=, this, frames = film.frames] { finished(**status, frames, path); });
}

void FilmDialog::finished(const Status& status, std::int64_t frames, const QString& path) {
  if (!status) return words_->setText(toText(status.error().message));
  Q_EMIT made(tr("The film is in %1 (%2).").arg(path, picturesText(frames)));
  accept();
}

void FilmDialog::reject() {
  if (!making_.busy()) return QDialog::reject();
  making_.cancel();
}

}  // namespace surefoot

#include "moc_film_dialog.cpp"
