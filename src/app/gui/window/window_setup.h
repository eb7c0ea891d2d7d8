// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

class QApplication;
class QString;

namespace tactooth {

/// Makes a program one with windows: quiet audio libraries, OpenGL 4.1 core for every window, and the same look on
/// every desktop. `argc` and `argv` must live as long as the application. To be called first of all, before there are
/// threads.
[[nodiscard]] std::unique_ptr<QApplication> startApplication(int& argc, char** argv);

/// Light or dark, for all windows, at once.
void applyColours(bool dark);

/// The letters of all windows, as a multiple of their usual size, at once.
void applyTextScale(double scale);

/// Windows made from now on speak `language` ("en", "ja"; empty: the system's) and write its numbers.
void applyLanguage(QApplication& application, const QString& language);

}  // namespace tactooth
