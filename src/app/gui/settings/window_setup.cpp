// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/settings/window_setup.h"

#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <QFont>
#include <QLibraryInfo>
#include <QLocale>
#include <QPalette>
#include <QSurfaceFormat>
#include <QTranslator>

#include "app/gui/icons/line_icon.h"
#include "app/gui/settings/window_style.h"
#include "sound/output/audio_libraries.h"

namespace tactooth {
namespace {

/// Call it before there is an application.
void useOpenGl41() {
    QSurfaceFormat format;
    format.setVersion(4, 1);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(0);  // the renderer has its own depth buffer
    format.setSwapInterval(0);     // the window draws on a change; waiting for the screen would delay the hand
    QSurfaceFormat::setDefaultFormat(format);
}

/// Returns the keyboard to the window when a dialog ends, as window managers do. Without a window manager (a kiosk)
/// nobody does. Qt lends the keyboard to each menu; without an active window it would think that the user has left, and
/// close all menus when the next menu opens more than 0.1 s after the last.
class KeyboardReturns : public QObject {
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Hide) {
            const auto* const dialog = qobject_cast<QDialog*>(watched);
            if (dialog != nullptr && dialog->parentWidget() != nullptr && nobodyHasIt()) {
                dialog->parentWidget()->activateWindow();
            }
        }
        return QObject::eventFilter(watched, event);
    }

private:
    /// Neither a window of this program nor another program has the keyboard.
    [[nodiscard]] static bool nobodyHasIt() {
        return QApplication::activeWindow() == nullptr && QApplication::applicationState() == Qt::ApplicationActive;
    }
};

}  // namespace

std::unique_ptr<QApplication> startApplication(int& argc, char** argv) {
    prepareAudioLibraries();
    useOpenGl41();
    auto application = std::make_unique<QApplication>(argc, argv);
    application->installEventFilter(new KeyboardReturns(application.get()));
    QApplication::setStyle(new WindowStyle);
    applyColours(false);
    QApplication::setApplicationName("Tactooth");
    QApplication::setWindowIcon(programIcon());
    QGuiApplication::setDesktopFileName("tactooth");
    QApplication::setApplicationDisplayName(QString());
    return application;
}

void applyColours(bool dark) {
    QPalette palette;
    const QColor text = dark ? QColor(226, 230, 234) : Qt::black;
    palette.setColor(QPalette::Window, dark ? QColor(38, 42, 47) : QColor(240, 242, 244));
    palette.setColor(QPalette::Base, dark ? QColor(28, 31, 35) : Qt::white);
    palette.setColor(QPalette::AlternateBase, dark ? QColor(34, 38, 42) : QColor(246, 247, 248));
    palette.setColor(QPalette::Button, dark ? QColor(52, 57, 63) : QColor(232, 235, 238));
    palette.setColor(QPalette::ToolTipBase, dark ? QColor(52, 57, 63) : QColor(255, 255, 238));
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        palette.setColor(role, text);
    }
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, QColor(130, 136, 142));
    }
    palette.setColor(QPalette::PlaceholderText, QColor(130, 136, 142));
    palette.setColor(QPalette::Highlight, dark ? QColor(40, 140, 190) : QColor(0, 106, 153));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Light, dark ? QColor(80, 87, 95) : Qt::white);
    palette.setColor(QPalette::Dark, dark ? QColor(20, 22, 25) : QColor(140, 146, 152));
    palette.setColor(QPalette::Shadow, dark ? Qt::black : QColor(105, 110, 116));
    palette.setColor(QPalette::Midlight, dark ? QColor(66, 72, 79) : QColor(215, 220, 225));
    palette.setColor(QPalette::Mid, dark ? QColor(96, 103, 110) : QColor(160, 166, 172));
    palette.setColor(QPalette::Link, dark ? QColor(110, 190, 235) : QColor(0, 106, 153));
    QApplication::setPalette(palette);
}

void applyTextScale(double scale) {
    static const QFont usual = QApplication::font();  // the default font: of the first call
    QFont font = usual;
    font.setPointSizeF(scale * usual.pointSizeF());
    QApplication::setFont(font);
}

void applyLanguage(QApplication& application, const QString& language) {
    for (QTranslator* before : application.findChildren<QTranslator*>())
        delete before;  // its destructor removes it from the application
    const QLocale locale = language.isEmpty() ? QLocale::system() : QLocale(language);
    QLocale::setDefault(locale);
    const std::pair<QString, QString> catalogues[] = {{"tactooth", ":/translations"},
                                                      {"qtbase", QLibraryInfo::path(QLibraryInfo::TranslationsPath)}};
    for (const auto& [name, folder] : catalogues) {
        auto* translator = new QTranslator(&application);
        if (translator->load(locale, name, "_", folder)) QApplication::installTranslator(translator);
    }
}

}  // namespace tactooth
