// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;

namespace tactooth {

/// OpenGL 4.1 core for every window. Before the QApplication.
void prepareWindowSystem();

/// The same quiet look on every desktop.
void applyLook(QApplication& application);

}  // namespace tactooth
