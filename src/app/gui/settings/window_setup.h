// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

class QApplication;
class QString;

namespace tactooth {

/// Starts Qt for a program with windows: quiet audio libraries, OpenGL 4.1 core for each window, and the same look on
/// each desktop. `argc` and `argv` must outlive the application. Call it first, before there are threads.
[[nodiscard]] std::unique_ptr<QApplication> startApplication(int& argc, char** argv);

/// Switches all windows to light or dark colours at once.
void applyColours(bool dark);

/// Scales the font of all windows, relative to its default size, at once.
void applyTextScale(double scale);

/// Sets the language of new windows and their number format: "en", "ja", or empty for that of the system.
void applyLanguage(QApplication& application, const QString& language);

}  // namespace tactooth
