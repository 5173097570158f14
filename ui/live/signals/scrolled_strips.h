// SPDX-License-Identifier: GPL-3.0-or-later
// Strip charts that scroll where there is no room for all of them. Their time axis always stays in sight.
#pragma once

#include <QScrollArea>

namespace surefoot {

class SignalsShown;
class StripCharts;

class ScrolledStrips final : public QScrollArea {
  Q_OBJECT

 public:
  explicit ScrolledStrips(SignalsShown& shown, QWidget* parent = nullptr);
  StripCharts& charts() { return *charts_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void placeAxis();

  StripCharts* charts_;
  QWidget* axis_;
};

}  // namespace surefoot
