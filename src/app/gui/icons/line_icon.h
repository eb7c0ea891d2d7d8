// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QIcon>

namespace tactooth {

/// A line drawing of the folder data/icons, in the colour of the texts of the program's palette: it follows light and
/// dark colours by itself, and is sharp at each size. `name`: of the file, without its ending; it is there.
[[nodiscard]] QIcon lineIcon(const char* name);

/// Gives the drawing to an action. Menus show the check mark of a checkable action in its place.
void setLineIcon(QAction& action, const char* name);

/// The icon of the program, for the window and the task bar.
[[nodiscard]] QIcon programIcon();

}  // namespace tactooth
