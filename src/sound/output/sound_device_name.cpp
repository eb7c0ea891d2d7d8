// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/output/sound_device_name.h"

#include <AL/alc.h>
#include <AL/alext.h>

#include "sound/output/audio_libraries.h"
#include "sound/output/sound_system_search.h"

namespace tactooth {

std::string defaultSoundDevice() {
    if (!hasSoundSystem()) return {};
    silenceAlsaMessages();
    ALCdevice* const device = alcOpenDevice(nullptr);
    if (device == nullptr) return {};
    const ALCchar* const name = alcGetString(device, ALC_ALL_DEVICES_SPECIFIER);
    std::string text = name == nullptr ? "" : name;
    alcCloseDevice(device);
    return text;
}

bool isNullSoundDevice(const std::string& name) { return name == "No Output"; }

}  // namespace tactooth
