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
#include "app/gui/model/current_work.h"
#include "app/gui/model/exercise_tooth.h"
#include "app/gui/model/recent_file.h"
#include "app/gui/settings/settings_autosave.h"
#include "app/gui/settings/window_setup.h"
#include "app/gui/text/messages.h"
#include "app/gui/text/translation.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/window_owner.h"
#include "assessment/exercise_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/unfinished_files.h"
#include "haptics/real_time.h"
#include "session/live/live_stream.h"
#include "session/recording/session_recording.h"
#include "session/recording/station_key.h"
#include "sound/output/openal_output.h"

namespace tactooth {
namespace {

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

/// The settings of the file with those of the command line.
Expected<WindowSettings> withFlags(WindowSettings settings, const WindowOptions& options) {
    for (const WindowOption& option : windowOptions()) {
        const auto given = options.settings.find(flagOf(option));
        if (given == options.settings.end()) continue;
        if (auto done = setWindowOption(settings, option, given->second); !done) return Unexpected{done.error()};
    }
    if (settings.bur.empty()) settings.bur = WindowSettings().bur;
    return settings;
}

Expected<SessionTooth> toothOfExercise(const std::string& nameOrFile) {
    if (auto builtin = builtinExercise(nameOrFile)) return makeSessionTooth(builtin);
    Expected<Exercise> found = findExercise(nameOrFile);
    if (!found) return Unexpected{found.error()};
    return makeSessionTooth(std::make_shared<const Exercise>(std::move(*found)));
}

std::vector<std::filesystem::path> recentFiles(const WindowSettings& settings) {
    return openedFiles(QString::fromStdString(settings.recent).split('\n', Qt::SkipEmptyParts));
}

/// The tooth of the command line, if it names one.
Expected<std::optional<SessionTooth>> toothFor(const WindowOptions& options,
                                               const std::vector<std::filesystem::path>& recent) {
    if (!options.tooth && !options.exercise) return std::optional<SessionTooth>();
    Expected<SessionTooth> tooth = options.exercise ? toothOfExercise(*options.exercise)
                                                    : openSessionTooth(*options.tooth, options.workOn, recent);
    if (!tooth) return Unexpected{tooth.error()};
    return std::optional(std::move(*tooth));
}

/// The key that signs an examination; null if there is none.
Expected<std::shared_ptr<const SigningKey>> sealFor(const WindowOptions& options) {
    if (!options.sealed) return std::shared_ptr<const SigningKey>();
    Expected<StationKey> station = openStationKey();
    if (!station) return Unexpected{station.error()};
    return station->key;
}

/// Null if nothing is sent.
Expected<std::shared_ptr<LiveStream>> streamFor(const WindowOptions& options) {
    if (options.stream.empty()) return std::shared_ptr<LiveStream>();
    auto stream = LiveStream::open(options.stream);
    if (!stream) return Unexpected{stream.error()};
    return std::shared_ptr<LiveStream>(std::move(*stream));
}

/// What the user should know about the settings file. A file that is not TOML is renamed.
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

WindowOwner* shownWindow = nullptr;  // while the event loop runs

/// Saves what nobody can be asked about, and closes the window and its dialogs.
void closeAll() {
    if (shownWindow != nullptr) shownWindow->window().saveBeforeEnd();
    QApplication::closeAllWindows();
    QCoreApplication::exit(kExitOk);
}

/// Stops the force and closes the devices.
void releaseDevices(SessionModel& model) {
    model.stop();
    model.install(DeviceSlot::First, nullptr);
    model.install(DeviceSlot::Second, nullptr);
}

/// When the display goes, the X library calls exit inside Qt. The window can then neither be used nor destroyed. This
/// still releases the hand. Settings have been written as they changed.
void releaseWithoutDisplay() {
    if (shownWindow == nullptr) return;
    constexpr unsigned kTimeout = 5;  // s
    ::alarm(kTimeout);
    WindowOwner& holder = *std::exchange(shownWindow, nullptr);
    releaseDevices(holder.window().model());
    holder.window().saveBeforeEnd();
    removeAllUnfinished(kTimeout);
    (void)reportError(msg::kDisplayGone);
    ::_exit(kExitBadInput);
}

}  // namespace

int runWindow(const WindowOptions& options) {
    const Expected<void> display = checkDisplay();  // before there are threads; reported after errors in the files
    const std::filesystem::path settingsFile = windowSettingsFile();
    Expected<ParsedSettings> settings = readWindowSettings(settingsFile);
    const std::optional<Error> forgotten = settings ? resetUnknownDevices(settings->hand, settingsFile) : std::nullopt;
    Expected<WindowSettings> start = withFlags(settings ? *settings : WindowSettings(), options);
    if (!start) return reportError(start.error());
    Expected<std::optional<SessionTooth>> tooth = toothFor(options, recentFiles(*start));
    if (!tooth) return reportError(tooth.error());
    if (options.recording) {
        const auto readable = SessionRecording::open(*options.recording);
        if (!readable) return reportError(readable.error());
    }
    std::optional<SessionBur> bur;
    if (options.bur) {
        Expected<SessionBur> loaded = findOrLoadSessionBur(*options.bur);
        if (!loaded) return reportError(loaded.error());
        bur = std::move(*loaded);
    }
    const Expected<std::shared_ptr<const SigningKey>> seal = sealFor(options);
    if (!seal) return reportError(seal.error());
    Expected<std::shared_ptr<LiveStream>> stream = streamFor(options);
    if (!stream) return reportError(stream.error());
    if (!display) return reportError(display.error());
    int argc = 1;
    char name[] = "tactooth";
    char* argv[] = {name, nullptr};
    const auto application = startApplication(argc, argv);
    const GracefulShutdown closing(
        [&] { QMetaObject::invokeMethod(application.get(), closeAll, Qt::QueuedConnection); });
    if (const auto openGl = checkOpenGl(); !openGl) return reportError(openGl.error());

    lockMemory();  // if the system allows it: the timing panel shows that, and 'tactooth doctor' says how to get it
    OpenAlOutput sound;
    WindowOwner holder(*application, sound);
    int exitCode = kExitOk;
    QObject::connect(&holder, &WindowOwner::graphicsFailed, application.get(), [&](const QString& sentence) {
        exitCode = reportError(Message::verbatim(sentence.toStdString()));
        holder.window().saveBeforeEnd();
        QApplication::exit(exitCode);
    });
    if (bur || (*tooth && (*tooth)->bur)) start->bur.clear();  // the bur of the command line or of the case counts
    if (options.device) start->hand.device = *options.device;
    if (options.records) {
        holder.setRecordings(options.recordings.empty() ? defaultRecordingFolder() : options.recordings);
    }
    holder.setStream(std::move(*stream));
    holder.setExamination(*seal);
    MainWindow& window = holder.open(*start);
    const bool isOwnTooth = tooth->has_value();
    if (isOwnTooth) {
        window.model().install(std::move(**tooth));
    } else {
        window.teeth().loadMouth(options.mouth.value_or(MouthChoice()));
    }
    if (bur) window.model().install(std::move(*bur));
    window.show();
    if (const QString sentences = whatIsWrongWith(settings, settingsFile); !sentences.isEmpty()) {
        window.messages().showError(sentences);
    }
    if (forgotten) window.messages().showError(*forgotten);
    if (options.recording) window.teeth().openFile(QString::fromStdString(options.recording->string()));
    const bool hasWork = isOwnTooth || options.mouth || options.recording || options.sealed;
    if (!hasWork && window.welcome().comesAtStart()) window.welcome().open();
    window.restorer().offer();
    SettingsAutosave autosave([&] { return holder.window().settings(); }, settingsFile);
    std::atexit(releaseWithoutDisplay);
    shownWindow = &holder;
    QApplication::exec();
    shownWindow = nullptr;
    releaseDevices(holder.window().model());  // first: the rest of the shutdown may take time
    holder.window().model().finishRecording();
    if (const auto written = writeWindowSettings(holder.window().settings(), settingsFile); !written) {
        (void)reportError(written.error());  // only reported: the session itself went well
    }
    return exitCode;
}

}  // namespace tactooth
