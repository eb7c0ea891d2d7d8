// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace tactooth {

/// The surgery around the chair, as an effect of OpenAL (EFX) that all sources are sent to. The model is a treatment
/// room of 4 x 3 x 2.7 m that reverberates for 0.5 s, with a listener 0.4 m from the tooth: there its
/// sound, a diffuse field, has 1.9 dB less energy than the direct sound (docs/sound.md). Every call needs the context
/// of the sources to be current.
class RoomReverb {
public:
    static constexpr double kReverberationTime = 0.5;  ///< s: until the energy has fallen by 60 dB
    static constexpr double kLevel = -1.9;             ///< dB: energy of the room's sound against the direct one
    /// Gain of the sources that keeps the energy of both together that of the direct sound alone.
    static constexpr float kSourceGain = 0.78f;

    RoomReverb() = default;
    ~RoomReverb();
    RoomReverb(const RoomReverb&) = delete;
    RoomReverb& operator=(const RoomReverb&) = delete;

    /// Sends the sources to the room. False if this OpenAL has no such effect: then nothing has changed.
    [[nodiscard]] bool surround(std::span<const unsigned> sources);

private:
    unsigned slot_ = 0;    // 0: none
    unsigned effect_ = 0;  // 0: none
};

}  // namespace tactooth
