// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lesson_details.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "core/lessons/reading/lesson_reading.h"
#include "core/lessons/reading/step_reading.h"
#include "ui/controls/hairline.h"
#include "ui/controls/labels.h"
#include "ui/controls/text_button.h"
#include "ui/language/from_core.h"
#include "ui/lessons/lesson_picture.h"
#include "ui/style/painted.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {

class Picture final : public Painted<> {
 public:
  Picture(const Registry& registry, const Lesson& lesson) : registry_(registry), lesson_(lesson) {
    whenScaled(this, [this] { setFixedHeight(scaled(176)); });
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    ScaledPainter p(this);
    drawLessonPicture(p, rect(), registry_, lesson_, themeOf(*this));
  }

 private:
  const Registry& registry_;
  const Lesson lesson_;
};

QLabel* makeLabel(const QString& text, int pixels, int weight, bool quiet) {
  QLabel* label = makeText(text, pixels, weight, quiet, nullptr);
  label->setWordWrap(true);
  return label;
}

const ShelvedLesson* named(const std::vector<ListedLesson>& all, const std::string& name) {
  for (const ListedLesson& listed : all)
    if (listed.shelved->lesson && listed.shelved->lesson->name == name) return listed.shelved;
  return nullptr;
}

/// A panel or a choice that a step shows, in a word or two.
QString wordOfShown(const std::string& name) {
  const std::pair<const char*, QString> words[] = {
      {"world", LessonDetails::tr("world")},           {"parameters", LessonDetails::tr("parameters")},
      {"actions", LessonDetails::tr("actions")},       {"maps", LessonDetails::tr("Q on a map")},
      {"reward", LessonDetails::tr("average reward")}, {"step", LessonDetails::tr("one step")},
      {"rule", LessonDetails::tr("rule of thumb")},    {"list", LessonDetails::tr("list of falls")},
      {"signals", LessonDetails::tr("signals")},       {"portrait", LessonDetails::tr("phase portrait")},
      {"strides", LessonDetails::tr("strides")},       {"agent", LessonDetails::tr("the learning rule")},
      {"policy", LessonDetails::tr("policy")},         {"scenario", LessonDetails::tr("scenario")}};
  for (const auto& [key, word] : words)
    if (name == key) return word;
  return fromCore(name);
}

}  // namespace

LessonDetails::LessonDetails(const Registry& registry, QWidget* parent)
    : QWidget(parent),
      registry_(registry),
      scroll_(new QScrollArea),
      buttons_(new QHBoxLayout) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  column->addWidget(scroll_, 1);
  column->addLayout(buttons_);
  whenScaled(this, [this] {
    buttons_->setContentsMargins(scaled({12, 8, 12, 8}));
    buttons_->setSpacing(scaled(8));
  });
}

void LessonDetails::show(const ListedLesson& listed, const std::vector<ListedLesson>& all) {
  while (QLayoutItem* item = buttons_->takeAt(0)) {
    if (item->widget()) item->widget()->deleteLater();
    delete item;
  }
  auto* content = new QWidget;
  column_ = new QVBoxLayout(content);
  whenScaled(content, [column = column_] {
    column->setContentsMargins(scaled({12, 0, 12, 12}));
    column->setSpacing(scaled(8));
  });
  listed.shelved->lesson ? showLesson(listed, all) : showError(*listed.shelved);
  column_->addStretch(1);
  scroll_->setWidget(content);
}

void LessonDetails::addLine() {
  column_->addWidget(new Hairline(Qt::Horizontal));
}

void LessonDetails::showError(const ShelvedLesson& shelved) {
  auto* title = makeLabel(toText(shelved.file()), 13, 500, false);
  whenScaled(title, [title] { title->setFixedHeight(scaled(32)); });
  column_->addWidget(title);
  for (const Complaint& complaint : shelved.complaints) {
    auto* label = makeLabel(toText(complaintText(shelved.path, complaint)), 13, 400, false);
    label->setProperty("caution", true);
    column_->addWidget(label);
  }
}

void LessonDetails::addRow(const QString& first, const QString& words, const QString& last, bool quietFirst) {
  auto* row = new QHBoxLayout;
  auto* left = makeLabel(first, 13, 400, quietFirst);
  left->setWordWrap(false);
  row->addWidget(left, 0, Qt::AlignTop);
  if (!words.isEmpty()) row->addWidget(makeLabel(words, 13, 400, false), 1);
  auto* right = makeLabel(last, words.isEmpty() ? 13 : 11, 400, !words.isEmpty());
  right->setAlignment(Qt::AlignRight);
  right->setWordWrap(words.isEmpty());
  row->addWidget(right, words.isEmpty() ? 1 : 0);
  whenScaled(left, [row] { row->setSpacing(scaled(12)); });  // as long as the row lives
  column_->addLayout(row);
}

void LessonDetails::showLesson(const ListedLesson& listed, const std::vector<ListedLesson>& all) {
  const Lesson& lesson = *listed.shelved->lesson;
  auto* title =
      makeLabel(QStringLiteral("%1  %2").arg(toText(lesson.number), toText(lesson.title)).trimmed(), 13, 500, false);
  whenScaled(title, [title] { title->setMinimumHeight(scaled(32)); });
  column_->addWidget(title);
  column_->addWidget(new Picture(registry_, lesson));
  column_->addWidget(makeLabel(toText(lesson.about.empty() ? lesson.line : lesson.about), 13, 400, false));
  addLine();
  auto* head = new QHBoxLayout;
  head->addWidget(makeHead(tr("%n steps", nullptr, static_cast<int>(lesson.steps.size())), this));
  head->addStretch(1);
  head->addWidget(makeLabel(tr("%1 min, level %2").arg(lesson.minutes).arg(lesson.level), 11, 400, true));
  column_->addLayout(head);
  for (std::size_t i = 0; i < lesson.steps.size(); ++i)
    addRow(QString::number(i + 1), toText(lesson.steps[i].title), fromCore(kindOf(lesson.steps[i])), true);
  addLine();
  addFacts(lesson, all);
  addButtons(listed);
}

void LessonDetails::addFacts(const Lesson& lesson, const std::vector<ListedLesson>& all) {
  QStringList after, panels, knobs;
  for (const std::string& name : lesson.needs)
    if (const ShelvedLesson* before = named(all, name))
      after << QStringLiteral("%1 %2").arg(toText(before->lesson->number), toText(before->lesson->title)).trimmed();
  const auto& names = lessonPanels();
  for (const LessonStep& step : lesson.steps)
    for (const std::string& name : step.show) {
      const auto* entry = lesson.start.parameters.find(name);
      const bool panel = std::find(names.begin(), names.end(), name) != names.end();
      const QString word =
          entry ? fromCore(entry->parameter.symbol.empty() ? entry->parameter.title : entry->parameter.symbol)
                : wordOfShown(name);
      if (panel && !panels.contains(word)) panels << word;
      const bool choice = name == "policy" || name == "agent" || name == "scenario";
      if ((entry || choice) && !knobs.contains(word)) knobs << word;
    }
  if (!after.empty()) addRow(tr("Better after"), {}, after.join(QStringLiteral(", ")), true);
  if (!panels.empty()) addRow(tr("On screen"), {}, panels.join(QStringLiteral(", ")), true);
  if (!knobs.empty()) addRow(tr("Knobs"), {}, knobs.join(QStringLiteral(", ")), true);
  addLine();
}

void LessonDetails::addButtons(const ListedLesson& listed) {
  const bool begun = listed.done > 0 && listed.done < 1;
  auto* start = new TextButton(listed.done >= 1 ? tr("See again")
                               : begun          ? tr("Continue at step %1").arg(listed.reached + 1)
                                                : tr("Start"),
                               TextButton::Look::Main);
  start->setStarts(true);
  connect(start, &QAbstractButton::clicked, this, [this] { Q_EMIT startAsked(); });
  buttons_->addWidget(start);
  if (begun) {
    auto* again = new TextButton(tr("Begin again"), TextButton::Look::Framed);
    connect(again, &QAbstractButton::clicked, this, &LessonDetails::beginAgainAsked);
    buttons_->addWidget(again);
  }
  auto* explore = new TextButton(tr("Explore freely"), TextButton::Look::Framed);
  explore->setToolTip(tr("The Live page, as the lesson begins"));
  connect(explore, &QAbstractButton::clicked, this, &LessonDetails::exploreAsked);
  buttons_->addWidget(explore);
  buttons_->addStretch(1);
}

}  // namespace surefoot

#include "moc_lesson_details.cpp"
