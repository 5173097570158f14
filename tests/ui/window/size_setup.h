// SPDX-License-Identifier: GPL-3.0-or-later
// What tests of sizes share.
#pragma once

#include <QApplication>
#include <QSettings>
#include <vector>

#include "tests/ui/window/layout_check.h"
#include "tests/ui/window_setup.h"
#include "ui/style/scale.h"
#include "ui/style/theme.h"

namespace surefoot {

/// The usual size again, whatever a test did.
struct UsualSize {
  ~UsualSize() {
    applyTextSize(1.0);
    for (const char* key : {"textSize", "geometry", "layout"}) QSettings().remove(key);
  }
};

struct Screen {
  QSize size;
  double text = 1.0;
};

/// 1366 × 768 at 125 % are 1093 × 614.
inline const std::vector<Screen> kScreens = {
    {{1280, 720}, 1.0}, {{1093, 614}, 1.0}, {{1920, 1080}, kProjectorText}, {{1024, 640}, 1.0}};

inline QString textOf(const Screen& s) {
  return QStringLiteral("%1 × %2, text %3").arg(s.size.width()).arg(s.size.height()).arg(s.text);
}

/// Light and dark in turn; both at every size where pictures are asked for.
inline std::vector<Appearance> looks() {
  static bool dark = false;
  if (qEnvironmentVariableIsSet("SUREFOOT_PICTURES")) return {Appearance::Light, Appearance::Dark};
  return {(dark = !dark) ? Appearance::Dark : Appearance::Light};
}

/// What `check` finds unreadable, at every size of a list, in the looks() that are asked for.
template <class Check>
void atEverySize(const std::vector<Screen>& screens, Check check) {
  for (const Screen& screen : screens)
    for (const Appearance look : looks()) {
      applyAppearance(*qApp, look);
      check(screen, textOf(screen) + (look == Appearance::Dark ? ", dark" : ", light"));
    }
}

struct UsualLook : UsualSize {
  ~UsualLook() { applyAppearance(*qApp, Appearance::Light); }
};

/// A life that has learned and fallen for a while, and stands still.
inline void live(Window& w, const std::string& environment) {
  const auto life = w.session->life().snapshot().life;
  ASSERT_TRUE(w.session->newLives().beginEnvironment(environment));
  ASSERT_TRUE(
      w.waitFor([&] { return w.session->life().snapshot().life > life && w.session->life().values(); }, 30'000));
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().totals.episodes > 12; }, 30'000));
  w.session->life().setRunning(false);
  QTest::qWait(100);
}

}  // namespace surefoot
