// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/window_setup.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>
#include <QSurfaceFormat>

namespace tactooth {

void prepareWindowSystem() {
    QSurfaceFormat format;
    format.setVersion(4, 1);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(0);  // the renderer has its own
    format.setSwapInterval(0);     // the window draws on change; waiting for the screen would hold up the hand
    QSurfaceFormat::setDefaultFormat(format);
}

void applyLook(QApplication& application) {
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    QPalette palette;
    palette.setColor(QPalette::Window, QColor(240, 242, 244));
    palette.setColor(QPalette::Base, Qt::white);
    palette.setColor(QPalette::Button, QColor(232, 235, 238));
    palette.setColor(QPalette::Highlight, QColor(0, 106, 153));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Midlight, QColor(215, 220, 225));
    application.setPalette(palette);
    QApplication::setApplicationName("Tactooth");
    QApplication::setApplicationDisplayName(QString());
}

}  // namespace tactooth
