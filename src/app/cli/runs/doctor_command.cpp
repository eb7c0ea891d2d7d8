// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/doctor_command.h"

#include <array>
#include <nlohmann/json.hpp>

#include "app/cli/runs/doctor_devices.h"
#include "app/cli/runs/doctor_finding.h"
#include "app/cli/runs/doctor_sound.h"
#include "app/cli/terminal/output.h"
#include "app/common/display_check.h"
#include "app/common/exit_code.h"
#include "devices/probe/child_probe.h"
#include "geometry/util/display_text.h"
#include "haptics/real_time.h"
#include "view/gl/egl_context.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> kStateNames = {"fine", "optional", "missing"};

Finding checkDisplayServer() {
    const Expected<void> display = checkDisplay();
    if (!display) return {"display", FindingState::Missing, asSentence(display.error().message())};
    return {"display", FindingState::Fine, "A window can be opened."};
}

Finding checkOpenGlRenderer() {
    const auto answer = inChildProcess(
        [] {
            const auto context = EglContext::create();
            return context ? std::string() : context.error().message();
        },
        kDriverTimeout);
    if (!answer) {
        return {"OpenGL", FindingState::Missing,
                "The graphics driver is broken, " + answer.error().message() + ": install it anew."};
    }
    if (!answer->empty()) return {"OpenGL", FindingState::Missing, asSentence(*answer)};
    return {"OpenGL", FindingState::Fine, "OpenGL 4.1 works."};
}

Finding checkRealTime() {
    const RealTimeRights rights = realTimeRights();
    const std::string missing = missingRights(rights);
    if (missing.empty()) {
        return {"real time", FindingState::Fine,
                "Real-time priority, locked memory and keeping the processors from deep sleep are allowed."};
    }
    return {"real time", FindingState::Optional, "Not allowed: " + missing + ". " + realTimeHint(rights)};
}

std::vector<Finding> examine() {
    std::vector<Finding> findings = {checkDisplayServer(), checkOpenGlRenderer()};
    for (Finding& finding : checkSound()) findings.push_back(std::move(finding));
    findings.push_back(checkRealTime());
    for (Finding& finding : checkDevices()) findings.push_back(std::move(finding));
    return findings;
}

}  // namespace

int runDoctor(const DoctorOptions& options) {
    Json json = Json::array();
    bool usable = true;
    for (const Finding& finding : examine()) {
        const char* const state = kStateNames[static_cast<std::size_t>(finding.state)];
        usable &= finding.state != FindingState::Missing;
        if (options.json) {
            json.push_back({{"area", finding.area}, {"verdict", state}, {"text", displayText(finding.text)}});
        } else {
            print("{:<12}  {:<8}  {}\n", finding.area, state, finding.text);
        }
    }
    if (options.json) print("{}\n", json.dump(1, ' ', false, Json::error_handler_t::replace));
    return usable ? kExitOk : kExitNegative;
}

}  // namespace tactooth
