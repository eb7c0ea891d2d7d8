// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/doctor_command.h"

#include <array>
#include <nlohmann/json.hpp>

#include "app/cli/runs/doctor_finding.h"
#include "app/cli/runs/doctor_sound.h"
#include "app/common/exit_code.h"
#include "app/cli/terminal/output.h"
#include "app/common/display_check.h"
#include "devices/child_probe.h"
#include "devices/device_survey.h"
#include "geometry/util/shown_text.h"
#include "haptics/real_time.h"
#include "view/gl/egl_context.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> kVerdicts = {"fine", "optional", "missing"};

Finding lookAtDisplay() {
    const Expected<void> display = checkDisplay();
    if (!display) return {"display", Verdict::Missing, asSentence(display.error().message)};
    return {"display", Verdict::Fine, "A window can be opened."};
}

Finding lookAtOpenGl() {
    const auto answer = inChildProcess(
        [] {
            const auto context = EglContext::create();
            return context ? std::string() : context.error().message;
        },
        kDriverPatience);
    if (!answer) {
        return {"OpenGL", Verdict::Missing,
                "The graphics driver is broken, " + answer.error().message + ": install it anew."};
    }
    if (!answer->empty()) return {"OpenGL", Verdict::Missing, asSentence(*answer)};
    return {"OpenGL", Verdict::Fine, "OpenGL 4.1 works."};
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

/// One of several of its kind is told from the others by the name that --device takes.
std::string titleOf(const SurveyedDevice& device) {
    const bool isOneOfSeveral = device.name.find(':') != std::string::npos;
    return isOneOfSeveral ? device.name + ", " + device.backend : device.backend;
}

std::vector<Finding> examine() {
    std::vector<Finding> findings = {lookAtDisplay(), lookAtOpenGl()};
    for (Finding& finding : lookAtSound()) findings.push_back(std::move(finding));
    findings.push_back(lookAtRealTime());
    for (const SurveyedDevice& device : surveyDevices()) {
        const bool isReady = device.state == DeviceState::Ready;
        findings.push_back(
            {"device", isReady ? Verdict::Fine : Verdict::Optional, titleOf(device) + ": " + device.text});
    }
    return findings;
}

}  // namespace

int runDoctor(const DoctorOptions& options) {
    Json json = Json::array();
    bool usable = true;
    for (const Finding& finding : examine()) {
        const char* const verdict = kVerdicts[static_cast<std::size_t>(finding.verdict)];
        usable &= finding.verdict != Verdict::Missing;
        if (options.json) {
            json.push_back({{"area", finding.area}, {"verdict", verdict}, {"text", shownText(finding.text)}});
        } else {
            say("{:<12}  {:<8}  {}\n", finding.area, verdict, finding.text);
        }
    }
    if (options.json) say("{}\n", json.dump(1, ' ', false, Json::error_handler_t::replace));
    return usable ? kExitOk : kExitNegative;
}

}  // namespace tactooth
