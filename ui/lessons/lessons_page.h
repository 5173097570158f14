// SPDX-License-Identifier: GPL-3.0-or-later
// The Lessons page: the list with the chosen lesson beside it, or a lesson being taken.
#pragma once

#include <QPointer>
#include <QStackedWidget>
#include <QTimer>
#include <functional>
#include <memory>

#include "core/lessons/reading/lesson_library.h"
#include "ui/lessons/lesson_list.h"
#include "ui/lessons/lesson_store.h"
#include "ui/lessons/teacher/teacher_window.h"
#include "ui/support/background.h"

class QBoxLayout;
class QLabel;

namespace surefoot {

class LessonDetails;
class LessonEditor;
class LessonView;
class TextButton;

class LessonsPage final : public QStackedWidget {
  Q_OBJECT

 public:
  /// `lessons`: the folder of the program's lessons, read when the page is first shown; `store`: where progress is
  /// kept.
  LessonsPage(const Registry& registry, QString lessons, QString store, QWidget* parent = nullptr);
  ~LessonsPage() override;

  /// Starts a lesson by its name, or goes on with it; false: there is none.
  bool start(const std::string& name);
  /// The same for the chosen one; an error: it has one.
  Status startChosen();
  /// A lesson's file is added to the list and chosen.
  Status open(const QString& path);
  /// Answers are kept in a shared folder, in files of the student's own.
  Status setClass(const QString& folder, const QString& student);
  /// An editor with the chosen lesson (the program's own are opened as copies), or with a template.
  void editChosen();
  void editTemplate();
  LessonEditor* editor() const { return editor_; }
  void showList();
  void showHint();
  /// The focus goes to the list, or to what the lesson asks.
  void focusHome();
  LessonView* view() const { return view_; }
  LessonList& list() { return *list_; }
  const std::vector<ShelvedLesson>& lessons();

  /// A life for the Live page: its configuration at the beginning, and the life.
  using Explore = std::function<void(Configuration began, std::unique_ptr<Life> life)>;
  void setExplore(Explore explore) { explore_ = std::move(explore); }

 Q_SIGNALS:
  void refused(const QString& sentence);
  void told(const QString& sentence);
  void statusChanged(const QString& left, const QString& right);
  /// Asks before a lesson that was begun is forgotten.
  void beginAgainAsked(const QString& sentence, const std::function<void()>& go);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeListPage();
  QWidget* makeBar();
  QWidget* makeFoot();
  void read();
  void fit();
  void refresh();
  std::vector<ListedLesson> listed();
  const Lesson* chosenLesson() const;
  void edit(const QString& text, const QString& path);
  Result<int> addFile(const QString& path);
  void askForClass();
  void startKiosk();
  void printHandout(bool solutions);
  void showTeacher();
  void showNotes();
  void startLesson(const Lesson& lesson, bool again);
  void exploreStart(const Lesson& lesson);
  void refreshStatus();
  void keepDrafts();

  const Registry& registry_;
  const QString folder_;
  LessonStore store_;
  std::vector<ShelvedLesson> lessons_;
  bool read_ = false;
  Explore explore_;
  LessonList* list_ = nullptr;
  LessonDetails* details_ = nullptr;
  TextButton* continue_ = nullptr;
  QLabel *next_ = nullptr, *asked_ = nullptr, *left_ = nullptr, *count_ = nullptr;
  QWidget *progress_ = nullptr, *drop_ = nullptr, *note_ = nullptr;
  QBoxLayout* parts_ = nullptr;  // the list, and the chosen lesson beside or below it
  LessonView* view_ = nullptr;
  QPointer<TeacherWindow> teacher_;
  LessonEditor* editor_ = nullptr;
  Background printing_;
  QTimer drafting_;
  bool isDrafted_ = false;  // and not written yet
  int nextLesson_ = -1;
};

}  // namespace surefoot
