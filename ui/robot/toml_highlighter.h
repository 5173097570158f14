// SPDX-License-Identifier: GPL-3.0-or-later
// Sections in bold; keys and comments quiet; no other colours.
#pragma once

#include <QColor>
#include <QSyntaxHighlighter>

namespace surefoot {

class TomlHighlighter final : public QSyntaxHighlighter {
  Q_OBJECT

 public:
  using QSyntaxHighlighter::QSyntaxHighlighter;
  void setQuiet(const QColor& quiet);

 protected:
  void highlightBlock(const QString& text) override;

 private:
  QColor quiet_;
};

}  // namespace surefoot
