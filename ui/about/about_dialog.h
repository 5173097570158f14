// SPDX-License-Identifier: GPL-3.0-or-later
// Help › About: what Surefoot is, the versions of all that it is made of (to copy into a report of a fault), and the
// pages that come with it.
#pragma once

#include <QDialog>
#include <QString>
#include <utility>
#include <vector>

class QListWidget;
class QTextBrowser;

namespace surefoot {

/// What the program tells the window of itself.
struct AboutFacts {
  std::vector<std::pair<QString, QString>> versions{};  ///< the program first, then libraries
  QString folder{};                                     ///< of the pages (resources/about); empty: there are none
};

class AboutDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit AboutDialog(AboutFacts facts, QWidget* parent = nullptr);

 private:
  enum class Kind { Prose, Lines };
  void addPage(const QString& title, const QString& text, Kind kind);
  void addFile(const QString& title, const QString& name);
  QString versionLines() const;
  void showPage(int row);

  AboutFacts facts_;
  QListWidget* list_;
  QTextBrowser* text_;
  std::vector<std::pair<QString, Kind>> pages_;
};

}  // namespace surefoot
