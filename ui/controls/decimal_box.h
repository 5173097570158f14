// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace surefoot {

/// A field for a number with decimals. It shows the language's sign before them; where that is a comma, it takes a
/// point, too.
class DecimalBox final : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;
  QValidator::State validate(QString& text, int& cursor) const override {
    if (const QString sign = locale().decimalPoint(); sign != QStringLiteral(".")) text.replace('.', sign);
    return QDoubleSpinBox::validate(text, cursor);
  }
};

}  // namespace surefoot
