// SPDX-License-Identifier: GPL-3.0-or-later
// The Lessons page: the list with the chosen lesson beside it, or a lesson being taken.
#pragma once

#include <QStackedWidget>
#include <functional>
#include <memory>

#include "core/lessons/lesson_library.h"
#include "ui/lessons/lesson_list.h"
#include "ui/lessons/lesson_store.h"

class QLabel;

namespace surefoot {

class LessonDetails;
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
  /// A lesson's file is added to the list and chosen.
  Status open(const QString& path);
  void showList();
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

 private:
  QWidget* makeListPage();
  QWidget* makeBar();
  void read();
  void refresh();
  std::vector<ListedLesson> listed();
  void startLesson(const Lesson& lesson, bool again);
  void exploreStart(const Lesson& lesson);
  void refreshStatus();

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
  QWidget* progress_ = nullptr;
  LessonView* view_ = nullptr;
  int nextLesson_ = -1;
};

}  // namespace surefoot
