// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the Lessons page for teachers: files, classes, the kiosk, hand-outs, and the teacher's window.
#include <QApplication>
#include <QCoreApplication>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>

#include "core/files/read_file.h"
#include "core/files/whole_file.h"
#include "ui/controls/fitted_dialog.h"
#include "ui/controls/link_button.h"
#include "ui/lessons/handout.h"
#include "ui/lessons/lessons_page.h"
#include "ui/lessons/taking/lesson_view.h"
#include "ui/lessons/writing/lesson_editor.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/support/ask_for_file.h"

namespace surefoot {

QWidget* LessonsPage::makeFoot() {
  auto* foot = new QWidget;
  auto* row = new QHBoxLayout(foot);
  auto* head = new QLabel(tr("For teachers:"));
  auto* drop = new QLabel(tr("a lesson file can also be dropped here"));
  for (QLabel* label : {head, drop}) {
    label->setForegroundRole(QPalette::PlaceholderText);
    whenScaled(label, [label] { label->setFont(scaledFont(11)); });
  }
  drop_ = drop;
  auto* notes = new LinkButton(tr("Notes"));
  notes->setToolTip(tr("What the chosen lesson's teacher should know: answers, questions, times"));
  connect(notes, &QToolButton::clicked, this, &LessonsPage::showNotes);
  auto* open = new LinkButton(tr("Open a lesson file …"));
  auto* write = new LinkButton(tr("Write …"));
  auto* shared = new LinkButton(tr("Class …"));
  auto* kiosk = new LinkButton(tr("Kiosk"));
  auto* handout = new LinkButton(tr("Hand-out …"));
  open->setToolTip(tr("A lesson of one's own: one text file"));
  shared->setToolTip(tr("Answers are kept in a shared folder, in a file for each student"));
  kiosk->setToolTip(tr("Two robots on the whole screen, for a booth; a window of its own"));
  handout->setToolTip(tr("The lesson on paper, with room to write, or with the answers"));
  write->setToolTip(tr("A lesson of one's own as text, checked while it is typed"));
  auto* texts = new QMenu(write);
  texts->addAction(tr("A new lesson"), this, &LessonsPage::editTemplate);
  texts->addAction(tr("The chosen one"), this, &LessonsPage::editChosen);
  write->setMenu(texts);
  write->setPopupMode(QToolButton::InstantPopup);
  auto* kinds = new QMenu(handout);
  kinds->addAction(tr("For students …"), this, [this] { printHandout(false); });
  kinds->addAction(tr("With the answers …"), this, [this] { printHandout(true); });
  handout->setMenu(kinds);
  handout->setPopupMode(QToolButton::InstantPopup);
  row->addWidget(head);
  for (LinkButton* link : {notes, open, write, shared, kiosk, handout}) row->addWidget(link);
  row->addStretch(1);
  row->addWidget(drop);
  whenScaled(foot, [row] {
    row->setContentsMargins(scaled({12, 4, 12, 4}));
    row->setSpacing(scaled(16));
  });
  connect(open, &QToolButton::clicked, this, [this] {
    askForFile(this, tr("Open a lesson"), tr("Lessons (*.toml);;All files (*)"), [this](const QString& path) {
      if (const Status s = this->open(path); !s) Q_EMIT refused(toText(s.error().message));
    });
  });
  connect(shared, &QToolButton::clicked, this, &LessonsPage::askForClass);
  connect(kiosk, &QToolButton::clicked, this, &LessonsPage::startKiosk);
  return foot;
}

void LessonsPage::edit(const QString& text, const QString& path) {
  if (!editor_) {
    editor_ = new LessonEditor(registry_);
    addWidget(editor_);
    connect(editor_, &LessonEditor::refused, this, &LessonsPage::refused);
    connect(editor_, &LessonEditor::saved, this, [this](const QString& saved) {
      Q_EMIT told(tr("%1 is written.").arg(saved));
      if (const auto added = addFile(saved); !added) Q_EMIT refused(toText(added.error().message));
    });
    connect(editor_, &LessonEditor::checked, this,
            [this] { store_.keepDraft(editor_->hasEdits() ? editor_->text() : QString()); });
    connect(editor_, &LessonEditor::closeAsked, this, &LessonsPage::showList);
    connect(editor_, &LessonEditor::tryAsked, this, [this] {
      if (editor_->lesson()) startLesson(*editor_->lesson(), true);
    });
  }
  setCurrentWidget(editor_);
  // A text that is not saved waits in the editor until it is.
  if (editor_->hasEdits() && !editor_->text().isEmpty())
    return Q_EMIT told(tr("The text in hand is not saved; save it, and then take another."));
  const QString draft = editor_->text().isEmpty() ? store_.draft() : QString();
  editor_->edit(draft.isEmpty() ? text : draft, draft.isEmpty() ? path : QString());
  if (!draft.isEmpty()) Q_EMIT told(tr("This text was not saved; it is back as it was."));
}

void LessonsPage::editTemplate() {
  const auto text = readText((folder_ + QStringLiteral("/template/my-lesson.toml")).toStdString());
  if (!text) return Q_EMIT refused(toText(text.error().message));
  edit(toText(*text), {});
}

void LessonsPage::editChosen() {
  const int chosen = list_->chosen();
  if (chosen < 0) return editTemplate();
  const QString path = toText(lessons_[static_cast<std::size_t>(chosen)].path);
  const auto text = readText(path.toStdString());
  if (!text) return Q_EMIT refused(toText(text.error().message));
  edit(toText(*text), path.startsWith(folder_) ? QString() : path);
}

/// A folder and a name; both empty: no class any more.
void LessonsPage::askForClass() {
  auto* dialog = new QDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Class"));
  auto* form = new QFormLayout(dialog);
  auto* folder = new QLineEdit(store_.classFolder());
  auto* student = new QLineEdit(store_.student());
  auto* note = new QLabel(tr("Every student has a file of their own in the folder. A name of your choosing will do."));
  note->setWordWrap(true);
  auto* join = new QPushButton(tr("Join"));
  form->addRow(tr("Shared folder"), folder);
  form->addRow(tr("Name"), student);
  form->addRow(note);
  form->addRow(join);
  const auto check = [folder, student, note, join] {
    static const QRegularExpression kName(
        QStringLiteral("^[\\p{L}\\p{N}_-]([\\p{L}\\p{N} _-]{0,38}[\\p{L}\\p{N}_-])?$"));
    const bool none = folder->text().isEmpty() && student->text().isEmpty();
    const bool there = QFileInfo(folder->text()).isDir(), named = kName.match(student->text()).hasMatch();
    join->setEnabled(none || (there && named));
    note->setText(none || (there && named)
                      ? tr("Every student has a file of their own in the folder. A name of your choosing will do.")
                  : there ? tr("A name has up to 40 letters, digits, blanks, - and _.")
                          : tr("There is no such folder."));
  };
  for (QLineEdit* field : {folder, student}) connect(field, &QLineEdit::textChanged, dialog, check);
  check();
  connect(join, &QPushButton::clicked, dialog, [this, dialog, folder, student, note] {
    if (const Status s = setClass(folder->text(), student->text()); !s) return note->setText(toText(s.error().message));
    dialog->accept();
  });
  dialog->open();
}

/// A program of its own: it has its own size of texts, and outlives this window.
void LessonsPage::startKiosk() {
  const Lesson* lesson = chosenLesson();
  if (!lesson || !lesson->kiosk) {
    QStringList names;
    for (const ShelvedLesson& one : lessons_)
      if (one.lesson && one.lesson->kiosk) names << toText(one.lesson->title);
    return Q_EMIT refused(tr("This lesson has no kiosk; these have one: %1.").arg(names.join(QStringLiteral(", "))));
  }
  const QStringList arguments = {QStringLiteral("window"), QStringLiteral("--kiosk"), toText(lesson->name)};
  if (!QProcess::startDetached(QCoreApplication::applicationFilePath(), arguments))
    Q_EMIT refused(tr("The kiosk could not be started."));
  else
    Q_EMIT told(tr("The kiosk opens. Ctrl+Shift+K and the word “%1” leave it.").arg(toText(lesson->kiosk->word)));
}

void LessonsPage::printHandout(bool solutions) {
  const Lesson* chosen = chosenLesson();
  if (!chosen) return;
  askForNewFile(
      this, tr("Hand-out"),
      toText(chosen->name) + (solutions ? QStringLiteral("-answers.pdf") : QStringLiteral(".pdf")),
      QStringLiteral("*.pdf"), QStringLiteral("pdf"), [this, lesson = *chosen, solutions](const QString& path) {
        auto told = std::make_shared<std::vector<ToldStep>>();
        printing_.start(
            [told, lesson, solutions, &registry = registry_](const std::atomic<bool>&) {
              if (solutions) static_cast<void>(liveThrough(registry, lesson, lesson.start.seed, told.get()));
            },
            [this, told, lesson, path] {
              const QByteArray pdf = handoutOf(registry_, lesson, *told);
              const Status s = writeWhole("hand-out", path.toStdString(), pdf.toStdString());
              s ? Q_EMIT this->told(tr("%1 is written.").arg(path)) : Q_EMIT refused(toText(s.error().message));
            });
      });
}

/// Of the chosen lesson, before it is begun.
void LessonsPage::showNotes() {
  const Lesson* lesson = chosenLesson();
  if (!lesson) return;
  delete teacher_;
  teacher_ = new TeacherWindow(*lesson, store_.classFolder(), this);
  teacher_->setAttribute(Qt::WA_DeleteOnClose);
  teacher_->QWidget::show();
}

void LessonsPage::showTeacher() {
  if (!view_) return;
  if (!teacher_) {
    teacher_ = new TeacherWindow(view_->driver().lesson(), store_.classFolder(), this);
    teacher_->setAttribute(Qt::WA_DeleteOnClose);
    teacher_->follow(view_->driver().number(), view_->driver().secondsInStep());
  }
  teacher_->QWidget::show();
  teacher_->raise();
}

}  // namespace surefoot
