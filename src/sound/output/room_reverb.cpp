// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/output/room_reverb.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/efx.h>

#include <array>
#include <utility>

namespace tactooth {
namespace {

template <class Function>
Function entryPoint(const char* name) {
    return reinterpret_cast<Function>(alGetProcAddress(name));
}

/// The functions of the extension; all of them are there if one is.
struct EffectFunctions {
    LPALGENEFFECTS genEffects = entryPoint<LPALGENEFFECTS>("alGenEffects");
    LPALDELETEEFFECTS deleteEffects = entryPoint<LPALDELETEEFFECTS>("alDeleteEffects");
    LPALEFFECTI effecti = entryPoint<LPALEFFECTI>("alEffecti");
    LPALEFFECTF effectf = entryPoint<LPALEFFECTF>("alEffectf");
    LPALGENAUXILIARYEFFECTSLOTS genSlots = entryPoint<LPALGENAUXILIARYEFFECTSLOTS>("alGenAuxiliaryEffectSlots");
    LPALDELETEAUXILIARYEFFECTSLOTS deleteSlots =
        entryPoint<LPALDELETEAUXILIARYEFFECTSLOTS>("alDeleteAuxiliaryEffectSlots");
    LPALAUXILIARYEFFECTSLOTI sloti = entryPoint<LPALAUXILIARYEFFECTSLOTI>("alAuxiliaryEffectSloti");
};

bool hasEffects() {
    ALCdevice* device = alcGetContextsDevice(alcGetCurrentContext());
    return device != nullptr && alcIsExtensionPresent(device, ALC_EXT_EFX_NAME) == ALC_TRUE;
}

// Sound takes 9 ms to the nearest wall and back, 1.5 m away each, and 20 ms around the room. Hard walls and cupboards
// scatter well; air and skin swallow the high frequencies first.
constexpr std::array<std::pair<ALenum, float>, 10> kRoom = {{
    {AL_REVERB_DENSITY, 0.4f},
    {AL_REVERB_DIFFUSION, 1.0f},
    {AL_REVERB_DECAY_TIME, static_cast<float>(RoomReverb::kReverberationTime)},
    {AL_REVERB_DECAY_HFRATIO, 0.8f},
    {AL_REVERB_GAIN, 0.757f},  // calibrated to kLevel
    {AL_REVERB_GAINHF, 0.9f},
    {AL_REVERB_REFLECTIONS_GAIN, 1.0f},
    {AL_REVERB_REFLECTIONS_DELAY, 0.009f},
    {AL_REVERB_LATE_REVERB_GAIN, 2.4f},
    {AL_REVERB_LATE_REVERB_DELAY, 0.011f},
}};

}  // namespace

bool RoomReverb::surround(std::span<const unsigned> sources) {
    if (!hasEffects()) return false;
    const EffectFunctions al;
    if (al.genEffects == nullptr || al.genSlots == nullptr) return false;
    alGetError();
    al.genEffects(1, &effect_);
    al.genSlots(1, &slot_);
    al.effecti(effect_, AL_EFFECT_TYPE, AL_EFFECT_REVERB);
    for (const auto& [parameter, value] : kRoom) al.effectf(effect_, parameter, value);
    al.sloti(slot_, AL_EFFECTSLOT_EFFECT, static_cast<ALint>(effect_));
    if (alGetError() != AL_NO_ERROR) return false;
    for (const unsigned source : sources) {
        alSource3i(source, AL_AUXILIARY_SEND_FILTER, static_cast<ALint>(slot_), 0, AL_FILTER_NULL);
    }
    return alGetError() == AL_NO_ERROR;
}

RoomReverb::~RoomReverb() {
    if (effect_ == 0 && slot_ == 0) return;
    const EffectFunctions al;
    al.deleteSlots(1, &slot_);
    al.deleteEffects(1, &effect_);
}

}  // namespace tactooth
