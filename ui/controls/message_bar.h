// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences below the toolbar of a page, with what can be done about them. No dialog boxes; they cover nothing.
//
// A question never takes the keyboard: the focus stays where the person was, and no key that was meant for something
// else presses an answer. Its answers are reached by the mouse, by Tab, or by Alt and a letter; none of
// them is a default.
#pragma once

#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <map>
#include <vector>

class QLabel;
class QVBoxLayout;

namespace surefoot {

class MessageRow;

class MessageBar final : public QWidget {
  Q_OBJECT

 public:
  /// A row of its own below the toolbar, so that it covers nothing; hidden while it has nothing to say.
  explicit MessageBar(QWidget* parent);
  /// Shows a sentence with only Dismiss.
  void say(const QString& sentence);
  /// The same for good news, which goes away by itself. What is told in the same moment as another sentence shares its
  /// line.
  void tell(const QString& sentence);
  /// A button that answers a question, and its action.
  struct Answer {
    QString text;
    std::function<void()> then;
  };
  enum class Question {
    Passing,  ///< about the present life: withdrawn when the life changes; a new question replaces it
    Quit,     ///< stays until it is answered or cancelled
    Lasting,  ///< stays until it is answered
    Report    ///< stays beside all others until it is answered
  };
  /// Shows a question beside the present messages; Escape in the bar is Cancel.
  void ask(const QString& sentence, std::vector<Answer> answers, Question kind = Question::Passing);
  bool asks(Question kind) const { return questions_.count(kind) > 0; }
  /// Takes remarks and passing questions away.
  void dismiss();
  /// Takes remarks away, but no questions.
  void dismissRemark();
  /// Takes a question back that can be cancelled; false: there is none.
  bool cancel();

 protected:
  void paintEvent(QPaintEvent*) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void remove(Question kind);
  void refresh();

  QPointer<QWidget> before_;  // had the focus before Tab led into the bar
  QVBoxLayout* rows_;
  MessageRow* remark_;
  std::map<Question, MessageRow*> questions_;
  QTimer leaving_;
};

}  // namespace surefoot
