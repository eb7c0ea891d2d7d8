// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/display_check.h"

#include <unistd.h>

#include <QGuiApplication>
#include <QLibraryInfo>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "app/common/display_server.h"
#include "app/common/messages.h"
#include "devices/probe/child_probe.h"

namespace tactooth {
namespace {

constexpr double kTimeout = 20;         // s for all of Qt's work: a display on another computer may be far away
constexpr double kServerTimeout = 1.5;  // s for the server's first answer; through ssh it takes a tenth of that
constexpr double kShortTimeout = 0.5;   // s for Qt if one of two servers does not answer

std::string valueOf(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr ? std::string() : std::string(value);
}

/// Handles Qt's last message before it aborts. An exit leaves no core file and no entry in the system's list of
/// crashes.
void exitOnFatal(QtMsgType type, const QMessageLogContext&, const QString&) {
    if (type == QtFatalMsg) _exit(1);
}

/// Does all that Qt does before the first window, so that this code need not know any platform or connection.
std::string startQt() {
    qInstallMessageHandler(exitOnFatal);
    int argc = 1;
    char name[] = "tactooth";
    char* argv[] = {name, nullptr};
    const QGuiApplication application(argc, argv);
    return {};
}

/// Qt searches for a Wayland compositor only if it has a plugin for one.
bool hasWaylandPlugin() {
    const std::filesystem::path folder = QLibraryInfo::path(QLibraryInfo::PluginsPath).toStdString();
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "platforms", ignored)) {
        if (entry.path().filename().string().starts_with("libqwayland")) return true;
    }
    return false;
}

/// A display that the environment names.
struct Server {
    const char* variable;
    bool (*answers)();
};

/// The servers that Qt may connect to.
std::vector<Server> serversAskedFor() {
    const std::string platform = valueOf("QT_QPA_PLATFORM");
    std::vector<Server> servers;
    if (!valueOf("DISPLAY").empty() && (platform.empty() || platform.starts_with("xcb"))) {
        servers.push_back({"DISPLAY", xServerAnswers});
    }
    if (!valueOf("WAYLAND_DISPLAY").empty() && (platform.empty() || platform.starts_with("wayland")) &&
        hasWaylandPlugin()) {
        servers.push_back({"WAYLAND_DISPLAY", waylandServerAnswers});
    }
    return servers;
}

/// The variable of the server that does not answer in time; null if all answer. A refusal is an answer.
const char* silentServer(const std::vector<Server>& servers) {
    for (const Server& server : servers) {
        const auto probe = [&] { return std::string(server.answers() ? "ok" : ""); };
        if (!inChildProcess(probe, kServerTimeout)) return server.variable;
    }
    return nullptr;
}

/// States which display of the environment is not available, and the remedy, as the first part of the message.
Message whatIsWrong() {
    if (const std::string platform = valueOf("QT_QPA_PLATFORM"); !platform.empty())
        return {msg::kNoWindowOnPlatform, platform};
    if (const std::string display = valueOf("DISPLAY"); !display.empty()) return {msg::kDisplayNotReached, display};
    if (const std::string display = valueOf("WAYLAND_DISPLAY"); !display.empty())
        return {msg::kWaylandNotUsed, display};
    return msg::kNoDisplay;
}

}  // namespace

Expected<void> checkDisplay() {
    const std::vector<Server> servers = serversAskedFor();
    const char* const silent = silentServer(servers);
    const bool isHopeless = silent != nullptr && servers.size() == 1;
    if (!isHopeless && inChildProcess(startQt, silent == nullptr ? kTimeout : kShortTimeout)) return {};
    const Message why = silent == nullptr ? whatIsWrong() : Message(msg::kDisplaySilent, valueOf(silent), silent);
    return unexpected(msg::kDisplayAdvice, why);
}

}  // namespace tactooth
