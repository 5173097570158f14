// SPDX-License-Identifier: GPL-3.0-or-later
// The text of a robot's file: line numbers, sections in bold, keys and comments quiet, and under a line what is wrong
// with it. The document never holds the sentences.
#pragma once

#include <QPlainTextEdit>
#include <vector>

#include "core/files/toml_tree.h"
#include "ui/robot/robot_help.h"

namespace surefoot {

class RobotText final : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit RobotText(QWidget* parent = nullptr);

  /// Whether one of the errors can be mended by a key.
  bool anyProposal() const;
  void setComplaints(std::vector<Complaint> complaints);
  const std::vector<Complaint>& complaints() const { return complaints_; }
  /// Replaces all, as one step that can be undone; the caret stays where it is.
  void replaceAll(const QString& text);
  void goTo(TextPlace place);
  void goToNextComplaint();
  /// Writes what the nearest complaint at or behind the caret proposes; false: none proposes anything.
  bool repair();
  /// Replaces `length` characters at a place, as one step.
  void write(TextPlace place, int length, const QString& text);
  /// A text of the file's head, such as its name.
  void setHead(const QString& key, const QString& value);
  RobotTextPlace caret() const;
  /// Shows a sentence at the caret, until a key is pressed or the mouse moves.
  void explain(const QString& sentence);
  /// What stands from a place to the end of its line.
  QString lineFrom(TextPlace place) const;

 Q_SIGNALS:
  void lineChanged(int line);  ///< the caret's, from 1
  void helpAsked();            ///< about what stands at the caret

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  friend class LineNumbers;
  class Roomy;

  /// What a sentence proposes: "did you mean shin?" for "shank".
  struct Proposal {
    QString wrong, right;
  };
  static std::optional<Proposal> proposalOf(const Complaint& complaint);
  bool repair(const Complaint& complaint);
  void refresh();
  void placeNumbers();
  int gapHeight(int line) const;
  void paintNumbers(QPainter& painter, const QRect& dirty);
  std::vector<const Complaint*> at(int line) const;
  QTextCursor cursorAt(TextPlace place) const;
  QString sentenceOf(const Complaint& complaint) const;

  std::vector<Complaint> complaints_;
  Roomy* roomy_;
  QWidget* numbers_;
  std::vector<std::pair<QRectF, std::size_t>> links_;  // where a repair can be clicked, and of which complaint
};

}  // namespace surefoot
