// SPDX-License-Identifier: GPL-3.0-or-later
// The glossary: a list of words that can be searched, and the meaning of the chosen word.
#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;
class QListWidget;

namespace surefoot {

class WordsDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit WordsDialog(QWidget* parent = nullptr);
  /// Shows the word for an entry of the registry, by the entry's name.
  void showWord(const std::string& name);

 private:
  void search(const QString& text);
  void showRow(int row);

  QLineEdit* search_;
  QListWidget* list_;
  QLabel *title_, *text_, *formula_, *source_;
};

}  // namespace surefoot
