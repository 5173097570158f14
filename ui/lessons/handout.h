// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson on paper: its questions with room to write, or with the answers, for the teacher.
#pragma once

#include <QByteArray>

#include "core/lessons/lesson_check.h"

namespace surefoot {

/// A PDF. `told`: what each step says and comes to; empty: numbers are left open, for the student to write in.
QByteArray handoutOf(const Registry& registry, const Lesson& lesson, const std::vector<ToldStep>& told);

}  // namespace surefoot
