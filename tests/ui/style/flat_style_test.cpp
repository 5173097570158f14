// SPDX-License-Identifier: GPL-3.0-or-later
// Standard controls in the theme's colours.
#include "ui/style/flat_style.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <QStyleOption>
#include <QTabBar>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>

#include "tests/ui/window/size_setup.h"
#include "tests/ui/window/text_recorder.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

struct Controls : QWidget {
  Controls() {
    auto* column = new QVBoxLayout(this);
    auto* combo = new QComboBox;
    combo->addItems({"softmax", "greedy"});
    auto* tabs = new QTabBar;
    tabs->addTab("Maps");
    tabs->addTab("Falls");
    auto* reset = new QToolButton;
    reset->setText("Reset");
    reset->setAutoRaise(true);
    reset->setFocusPolicy(Qt::TabFocus);
    all = {new QPushButton("Start"), new QLineEdit("190"), combo, new QCheckBox("reduce motion"),
           new QRadioButton("dark"), new QSpinBox,         tabs,  reset,
           new QTableWidget(2, 2)};
    for (QWidget* control : all) column->addWidget(control);
    show();
    activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(this));
    setFocus();  // on none of them
  }
  std::vector<QWidget*> all;
};

double share(const QImage& image, auto is) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) count += is(image.pixelColor(x, y));
  return static_cast<double>(count) / (image.width() * image.height());
}

QImage lookOf(QWidget& widget) {
  return widget.grab().toImage();
}

QRect part(int position, QStyle::SubControl control) {
  QStyleOptionSlider bar;
  bar.orientation = Qt::Vertical;
  bar.rect = QRect(5, 10, 8, 200);
  bar.minimum = 0;
  bar.maximum = 300;
  bar.pageStep = 100;
  bar.sliderPosition = position;
  return QApplication::style()->subControlRect(QStyle::CC_ScrollBar, &bar, control, nullptr);
}

}  // namespace

TEST(FlatStyle, EveryControlFollowsAChangeOfColours) {
  Controls controls;
  const auto isDark = [](const QColor& c) { return c.lightness() < 128; };
  for (const bool dark : {true, false}) {
    applyAppearance(*qApp, dark ? Appearance::Dark : Appearance::Light);
    QApplication::processEvents();  // Qt hands palettes on in the event loop
    for (QWidget* control : controls.all) {
      const double is = share(lookOf(*control), isDark);
      EXPECT_TRUE(dark ? is > 0.75 : is < 0.25) << control->metaObject()->className() << " " << is;
    }
  }
}

TEST(FlatStyle, TheAccentShowsWhereTheKeyboardIs) {
  Controls controls;
  const QColor accent = lightTheme().accent;
  const auto isAccent = [&](const QColor& c) { return c == accent; };
  for (QWidget* control : controls.all) {
    EXPECT_EQ(share(lookOf(*control), isAccent), 0) << control->metaObject()->className();
    control->setFocus(Qt::TabFocusReason);
    EXPECT_GT(share(lookOf(*control), isAccent), 0) << control->metaObject()->className();
    controls.setFocus();
  }
}

TEST(FlatStyle, WordsFitIntoTheirButtons) {
  for (const char* text : {"OK", "Begin a life in reality with it"}) {
    const QPushButton button(text);
    EXPECT_GE(button.sizeHint().width(), button.fontMetrics().horizontalAdvance(text) + 26) << text;
  }
}

// 100 of 400 lines are seen on 200 px: a handle of 50 px, which has 150 px to move.
TEST(FlatStyle, TheHandleOfAScrollBarIsAsLongAsWhatIsSeen) {
  EXPECT_EQ(part(0, QStyle::SC_ScrollBarSlider), QRect(5, 10, 8, 50));
  EXPECT_EQ(part(300, QStyle::SC_ScrollBarSlider), QRect(5, 160, 8, 50));
  EXPECT_EQ(part(150, QStyle::SC_ScrollBarSlider), QRect(5, 85, 8, 50));
  EXPECT_EQ(part(150, QStyle::SC_ScrollBarSubPage), QRect(5, 10, 8, 75));
  EXPECT_EQ(part(150, QStyle::SC_ScrollBarAddPage), QRect(5, 135, 8, 75));
  EXPECT_TRUE(part(150, QStyle::SC_ScrollBarAddLine).isEmpty());
}

TEST(FlatStyle, AMenuIsAsHighAsItsItems) {
  QMenu menu;
  menu.addAction("Run");
  menu.addSeparator();
  menu.addAction("Pause");
  const int line = menu.fontMetrics().height() + 10;
  EXPECT_EQ(menu.sizeHint().height(), 2 * line + 9 + 2 * (4 + 1)) << "two items, a separator, margin and frame";
  QMenu axes;
  axes.addSection("Horizontal");
  axes.addAction("pole angle");
  EXPECT_EQ(axes.sizeHint().height(), 2 * line + 2 * (4 + 1)) << "the head of a section is to be read";
}

TEST(FlatStyle, TheLongestEntryOfAMenuIsWhole) {
  const UsualSize usual;
  for (const double text : {1.0, 1.25, kProjectorText}) {
    applyTextSize(text);
    QMenu menu;
    menu.addAction("Shortcuts")->setShortcut(QKeySequence("Ctrl+F1"));
    menu.addAction("Report of the last crash");
    menu.popup({0, 0});
    QStringList drawn;
    for (const DrawnText& each : drawnTexts(menu)) drawn << each.text;
    EXPECT_TRUE(drawn.contains("Report of the last crash")) << text << ": " << drawn.join(" | ").toStdString();
  }
}

TEST(FlatStyle, MenusWithoutRoomAreBehindAButtonThatIsSeen) {
  const UsualLook usual;
  for (const Appearance look : {Appearance::Dark, Appearance::Light}) {
    applyAppearance(*qApp, look);
    QMenuBar bar;
    for (const char* menu : {"File", "Edit", "View"}) bar.addMenu(menu);
    bar.resize(90, 30);
    bar.show();
    QApplication::processEvents();
    auto* button = bar.findChild<QToolButton*>("qt_menubar_ext_button");
    ASSERT_TRUE(button && button->isVisible());
    const QColor ink = (look == Appearance::Dark ? darkTheme() : lightTheme()).ink;
    const auto isInk = [&](const QColor& c) { return std::abs(c.lightness() - ink.lightness()) < 60; };
    EXPECT_GT(share(lookOf(*button), isInk), 0.01);
  }
}

}  // namespace surefoot
