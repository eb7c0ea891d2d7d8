// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/doctor_sound.h"

#include <chrono>
#include <cstdlib>
#include <thread>

#include "devices/probe/child_probe.h"
#include "sound/output/audio_libraries.h"
#include "sound/output/offline_render.h"
#include "sound/output/openal_output.h"
#include "sound/output/sound_device_name.h"

namespace tactooth {
namespace {

constexpr const char* kSystem = "sound system";
constexpr const char* kCard = "sound card";

/// Mixes with the library but without a sound card. Returns the error; empty if mixing works.
std::string tryToMix() {
    prepareAudioLibraries();
    constexpr double kShort = 0.01;  // s
    const TimedSoundState still;
    const auto rendered = renderOffline({&still, 1}, kShort);
    return rendered ? std::string() : rendered.error().message();
}

/// Returns '+' and the name of the sound device that plays; the name may be empty.
std::string tryToPlay() {
    prepareAudioLibraries();
    bool plays = false;
    {
        const OpenAlOutput output;
        for (int i = 0; i < 100 && output.status() == SoundStatus::Starting; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        plays = output.status() == SoundStatus::Playing;
    }
    return plays ? '+' + defaultSoundDevice() : "-";
}

std::string nullDriverText() {
    const char* const drivers = std::getenv("ALSOFT_DRIVERS");
    if (drivers != nullptr && *drivers != '\0') {
        return std::string(
                   "The sound goes to OpenAL's null driver, so that none is heard: unset ALSOFT_DRIVERS, which "
                   "is '") +
               drivers + "'.";
    }
    return "The sound goes to OpenAL's null driver, so that none is heard: start the sound server (PipeWire or "
           "PulseAudio), and see that 'drivers' in ~/.alsoftrc or /etc/openal/alsoft.conf does not choose it.";
}

Finding checkSoundCard() {
    const auto answer = inChildProcess(tryToPlay, kDriverTimeout);
    if (!answer) {
        return {kCard, FindingState::Missing,
                "The sound card's driver is broken, " + answer.error().message() +
                    ": choose another card in the system's settings or restart the sound server; until then start "
                    "Tactooth with ALSOFT_DRIVERS=null, without sound."};
    }
    if (*answer == "-") {
        return {kCard, FindingState::Optional,
                "No sound card: the window stays silent; plug one in or choose it in the system's settings."};
    }
    if (isNullSoundDevice(answer->substr(1))) return {kCard, FindingState::Optional, nullDriverText()};
    return {kCard, FindingState::Fine, "The sound card plays."};
}

}  // namespace

std::vector<Finding> checkSound() {
    const auto answer = inChildProcess(tryToMix, kDriverTimeout);
    if (!answer) {
        return {{kSystem, FindingState::Missing,
                 "The sound library (OpenAL) is broken, " + answer.error().message() +
                     ": install the package libopenal1 anew; until then it takes the window down with it."},
                {kCard, FindingState::Optional, "It was not tried: mend the sound system first."}};
    }
    const bool mixes = answer->empty();
    return {
        {kSystem, mixes ? FindingState::Fine : FindingState::Optional, mixes ? "OpenAL works." : asSentence(*answer)},
        checkSoundCard()};
}

}  // namespace tactooth
