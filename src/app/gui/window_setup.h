// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;
class QString;

namespace tactooth {

/// OpenGL 4.1 core for every window. Before the QApplication.
void prepareWindowSystem();

/// The same quiet look on every desktop.
void applyLook();

/// Light or dark, for all windows, at once.
void applyColours(bool dark);

/// The letters of all windows, as a multiple of their usual size, at once.
void applyTextScale(double scale);

/// Windows made from now on speak `language` ("en", "ja"; empty: the system's) and write its numbers.
void applyLanguage(QApplication& application, const QString& language);

}  // namespace tactooth
