// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/window/run_window.h"

#include <unistd.h>

#include <QApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>
#include <cstdlib>
#include <utility>

#include "app/common/display_check.h"
#include "app/common/exit_code.h"
#include "app/common/termination.h"
#include "app/gui/settings/settings_autosave.h"
#include "app/gui/text/messages.h"
#include "app/gui/text/translation.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/window_owner.h"
#include "app/gui/window/window_setup.h"
#include "assessment/exercise_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/unfinished_files.h"
#include "haptics/real_time.h"
#include "sound/output/openal_output.h"

namespace tactooth {
namespace {

constexpr const char* kFirstBur = "4";  // round, 1.4 mm: what one opens a fissure with

Expected<void> checkOpenGl() {
    QOpenGLContext context;
    QOffscreenSurface surface;
    surface.create();
    if (context.create() && context.makeCurrent(&surface)) {
        const auto version = context.format().version();
        context.doneCurrent();
        if (version >= std::pair(4, 1)) return {};
    }
    return unexpected(msg::kWindowNeedsOpenGl);
}

/// The settings with those of the command line in their place.
Expected<WindowSettings> withFlags(WindowSettings settings, const WindowOptions& options) {
    for (const WindowOption& option : windowOptions()) {
        const auto given = options.settings.find(flagOf(option));
        if (given == options.settings.end()) continue;
        if (auto done = setWindowOption(settings, option, given->second); !done) return Unexpected{done.error()};
    }
    if (settings.bur.empty()) settings.bur = std::string(kFirstBur);
    return settings;
}

Expected<SessionTooth> exerciseOf(const std::filesystem::path& file) {
    Expected<Exercise> read = readExercise(file);
    if (!read) return Unexpected{read.error()};
    return makeSessionTooth(std::make_shared<const Exercise>(std::move(*read)));
}

/// What the person should know about the file of the settings, which is put aside if nothing of it could be read.
QString whatIsWrongWith(const Expected<ParsedSettings>& settings, const std::filesystem::path& file) {
    QStringList sentences;
    if (settings) {
        for (const Error& refused : settings->refused) sentences << translated(refused);
        if (!sentences.isEmpty()) sentences << MainWindow::tr("The usual values take their places.");
        return sentences.join(' ');
    }
    sentences << translated(settings.error());
    if (const auto aside = backUpInvalidSettings(file)) {
        sentences << MainWindow::tr("The window starts with its defaults; the file is kept as %1.")
                         .arg(QString::fromStdString(displayName(*aside)));
    } else {
        sentences << MainWindow::tr("The window starts with its defaults.");
    }
    return sentences.join(' ');
}

/// As if the person had closed the window and whatever stands before it.
void closeAll() {
    QApplication::closeAllWindows();
    QCoreApplication::exit(kExitOk);
}

/// Zero force, and the devices' ordinary farewell.
void letGo(SessionModel& model) {
    model.stop();
    model.useMouse();
    model.installSecond(nullptr);
}

WindowOwner* shownWindow = nullptr;  // while the event loop runs

/// Where the display goes, its library ends the program (exit) in the midst of Qt. No part of the window can be touched
/// then, nor destroyed, but the hand is still let go. The settings were kept as they changed.
void letGoWithoutDisplay() {
    if (shownWindow == nullptr) return;
    constexpr unsigned kTimeout = 5;  // s
    ::alarm(kTimeout);
    letGo(std::exchange(shownWindow, nullptr)->window().model());
    removeAllUnfinished(kTimeout);
    (void)reportError(msg::kDisplayGone);
    ::_exit(kExitBadInput);
}

}  // namespace

int runWindow(const WindowOptions& options) {
    const Expected<void> display = checkDisplay();  // before there are threads; said after what is wrong with the files
    const std::filesystem::path settingsFile = windowSettingsFile();
    std::error_code ignored;
    const bool isFirstTime = !std::filesystem::exists(settingsFile, ignored);
    Expected<ParsedSettings> settings = readWindowSettings(settingsFile);
    const std::optional<Error> forgotten = settings ? resetUnknownDevices(settings->hand, settingsFile) : std::nullopt;
    Expected<WindowSettings> start = withFlags(settings ? *settings : WindowSettings(), options);
    if (!start) return reportError(start.error());
    std::optional<SessionTooth> tooth;
    if (options.tooth) {
        Expected<SessionTooth> loaded = loadSessionTooth(*options.tooth, options.workOn);
        if (!loaded) return reportError(loaded.error());
        tooth = std::move(*loaded);
    }
    if (options.exercise) {
        Expected<SessionTooth> made = exerciseOf(*options.exercise);
        if (!made) return reportError(made.error());
        tooth = std::move(*made);
    }
    std::optional<SessionBur> bur;
    if (options.bur) {
        Expected<SessionBur> loaded = loadSessionBur(*options.bur);
        if (!loaded) return reportError(loaded.error());
        bur = std::move(*loaded);
    }
    if (!display) return reportError(display.error());
    int argc = 1;
    char name[] = "tactooth";
    char* argv[] = {name, nullptr};
    const auto application = startApplication(argc, argv);
    const GracefulShutdown closing(
        [&] { QMetaObject::invokeMethod(application.get(), closeAll, Qt::QueuedConnection); });
    if (const auto openGl = checkOpenGl(); !openGl) return reportError(openGl.error());

    lockMemory();  // where it is allowed: the timing panel says so, 'tactooth doctor' how to get it
    OpenAlOutput sound;
    WindowOwner holder(*application, sound);
    int exitCode = kExitOk;
    QObject::connect(&holder, &WindowOwner::graphicsFailed, application.get(), [&](const QString& sentence) {
        exitCode = reportError(Message::verbatim(sentence.toStdString()));
        QApplication::exit(exitCode);
    });
    if (bur || (tooth && tooth->bur)) start->bur.clear();  // the one of the command line counts, or of the case
    if (options.device) start->hand.device = *options.device;
    MainWindow& window = holder.open(*start);
    if (tooth) {
        window.model().install(std::move(*tooth));
    } else if (options.mouth) {
        window.loadMouth(*options.mouth);
    } else {
        window.loadBuiltinTooth(kBuiltinTeeth.front());
    }
    if (bur) window.model().install(std::move(*bur));
    window.show();
    if (const QString sentences = whatIsWrongWith(settings, settingsFile); !sentences.isEmpty()) {
        window.showError(sentences);
    }
    if (forgotten) window.showError(*forgotten);
    if (isFirstTime && !tooth && !options.mouth) window.welcome();
    SettingsAutosave autosave([&] { return holder.window().settings(); }, settingsFile);
    std::atexit(letGoWithoutDisplay);
    shownWindow = &holder;
    QApplication::exec();
    shownWindow = nullptr;
    letGo(holder.window().model());  // first of all: what else ends with the window may take its time
    if (const auto written = writeWindowSettings(holder.window().settings(), settingsFile); !written) {
        (void)reportError(written.error());  // a word about it; the session itself went well
    }
    return exitCode;
}

}  // namespace tactooth
