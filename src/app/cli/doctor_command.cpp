// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/doctor_command.h"

#include <fmt/core.h>

#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

#include "app/cli/exit_code.h"
#include "devices/child_probe.h"
#include "devices/device_survey.h"
#include "haptics/real_time.h"
#include "sound/audio_libraries.h"
#include "sound/openal_output.h"
#include "view/egl_context.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kPatience = 20;  // s for a graphics or sound driver to answer

enum class Verdict {
    Fine,
    Optional,  ///< works without
    Missing,   ///< the window does not open
};
constexpr std::array<const char*, 3> kVerdicts = {"fine", "optional", "missing"};

struct Finding {
    const char* area;
    Verdict verdict;
    std::string text;
};

Finding lookAtDisplay() {
    const bool there = std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
    if (there) return {"display", Verdict::Fine, "There is a display."};
    return {"display", Verdict::Missing,
            "There is no display: the window needs one; 'tactooth demo' and the other commands do not."};
}

Finding lookAtOpenGl() {
    const auto answer = inChildProcess(
        [] {
            const auto context = EglContext::create();
            return context ? std::string() : context.error().message;
        },
        kPatience);
    if (!answer) {
        return {"OpenGL", Verdict::Missing,
                "The graphics driver is broken, " + answer.error().message + ": install it anew."};
    }
    if (!answer->empty()) return {"OpenGL", Verdict::Missing, *answer};
    return {"OpenGL", Verdict::Fine, "OpenGL 4.1 works."};
}

std::string tryToPlay() {
    prepareAudioLibraries();
    const OpenAlOutput output;
    for (int i = 0; i < 100 && output.status() == SoundStatus::Starting; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return output.status() == SoundStatus::Playing ? "+" : "-";
}

Finding lookAtSound() {
    const auto answer = inChildProcess(tryToPlay, kPatience);
    if (!answer) {
        return {"sound", Verdict::Optional,
                "The sound system is broken, " + answer.error().message + "; the window stays silent."};
    }
    if (*answer == "+") return {"sound", Verdict::Fine, "The sound card plays."};
    return {"sound", Verdict::Optional,
            "No sound card: the window stays silent; plug one in or choose it in the system's settings."};
}

Finding lookAtRealTime() {
    const RealTimeRights rights = realTimeRights();
    const std::string missing = missingRights(rights);
    if (missing.empty()) {
        return {"real time", Verdict::Fine,
                "Real-time priority, locked memory and keeping the processors from deep sleep are allowed."};
    }
    return {"real time", Verdict::Optional, "Not allowed: " + missing + ". " + realTimeHint(rights)};
}

std::vector<Finding> examine() {
    std::vector<Finding> findings = {lookAtDisplay(), lookAtOpenGl(), lookAtSound(), lookAtRealTime()};
    for (const SurveyedDevice& device : surveyDevices()) {
        findings.push_back(
            {"device", device.ready ? Verdict::Fine : Verdict::Optional, device.backend + ": " + device.text});
    }
    return findings;
}

}  // namespace

int runDevices(const DevicesOptions& options) {
    Json json = Json::array();
    for (const SurveyedDevice& device : surveyDevices()) {
        if (options.json) {
            json.push_back(
                {{"name", device.name}, {"backend", device.backend}, {"ready", device.ready}, {"text", device.text}});
        } else {
            fmt::print("{:<11} {:<30} {:<10} {}\n", device.name, device.backend, device.ready ? "ready" : "not there",
                       device.text);
        }
    }
    if (options.json) fmt::print("{}\n", json.dump(1, ' ', false, Json::error_handler_t::replace));
    return kExitOk;
}

int runDoctor(const DoctorOptions& options) {
    Json json = Json::array();
    bool usable = true;
    for (const Finding& finding : examine()) {
        const char* const verdict = kVerdicts[static_cast<std::size_t>(finding.verdict)];
        usable &= finding.verdict != Verdict::Missing;
        if (options.json) {
            json.push_back({{"area", finding.area}, {"verdict", verdict}, {"text", finding.text}});
        } else {
            fmt::print("{:<10} {:<9} {}\n", finding.area, verdict, finding.text);
        }
    }
    if (options.json) fmt::print("{}\n", json.dump(1, ' ', false, Json::error_handler_t::replace));
    return usable ? kExitOk : kExitNegative;
}

}  // namespace tactooth
