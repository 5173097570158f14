// SPDX-License-Identifier: GPL-3.0-or-later
// The part of RobotText that puts what a complaint proposes in place of what is wrong.
#include <QRegularExpression>
#include <QTextBlock>
#include <algorithm>

#include "ui/robot/robot_text.h"
#include "ui/style/theme.h"

namespace surefoot {

bool RobotText::anyProposal() const {
  return std::any_of(complaints_.begin(), complaints_.end(), [](const Complaint& c) { return proposalOf(c); });
}

std::optional<RobotText::Proposal> RobotText::proposalOf(const Complaint& complaint) {
  static const QRegularExpression kWrong(QStringLiteral("\"([^\"]+)\"")),
      kRight(QStringLiteral("did you mean ([\\w-]+)"));
  const QString sentence = toText(complaint.sentence);
  const auto right = kRight.match(sentence);
  if (!right.hasMatch()) return std::nullopt;
  // The last word in quotes before the proposal: "pole" has no "angel".
  QString wrong;
  for (auto all = kWrong.globalMatch(sentence.left(right.capturedStart())); all.hasNext();)
    wrong = all.next().captured(1);
  if (wrong.isEmpty()) return std::nullopt;
  return Proposal{wrong, right.captured(1)};
}

bool RobotText::repair(const Complaint& complaint) {
  const auto proposal = proposalOf(complaint);
  if (!proposal) return false;
  const QTextBlock block = document()->findBlockByNumber(std::max(1, complaint.at.line) - 1);
  const QTextCursor from = cursorAt(complaint.at);
  auto found = block.text().indexOf(proposal->wrong, from.positionInBlock());
  if (found < 0) found = block.text().indexOf(proposal->wrong);
  if (found < 0) return false;
  QTextCursor cursor(block);
  cursor.setPosition(block.position() + static_cast<int>(found));
  cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor, static_cast<int>(proposal->wrong.size()));
  cursor.insertText(proposal->right);
  return true;
}

bool RobotText::repair() {
  const int line = textCursor().blockNumber() + 1;
  for (const bool behind : {true, false})
    for (const Complaint& c : complaints_)
      if ((c.at.line >= line) == behind && repair(Complaint(c))) return true;
  return false;
}

}  // namespace surefoot
