// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace tactooth {

/// The sound of a material when it is cut and when it is tapped, in plain numbers: the sound layer knows no teeth.
struct SoundCharacter {
    double bandCentreHz = 4200.0;  ///< middle of the cutting noise's band
    double bandOctaves = 1.0;      ///< width of that band between its half-power points
    double level = 1.0;            ///< loudness of the cutting noise relative to enamel at equal power, 0..1
    double graininess = 0.3;       ///< 0: even hiss; 1: separate crackling grains
    double tapHz = 2200.0;         ///< lowest tone of the ring after a tap
    double tapDecay = 0.004;       ///< time constant of that ring, s
    double tapBrightness = 0.5;    ///< 0: that lowest tone alone ("thud"); 1: two higher ones as strong ("tick")
    std::size_t kind = 0;          ///< identifies the material: a recording may replace its cutting noise
    std::size_t standIn = 0;       ///< the kind whose recording does so where there is none of the material itself
};

/// The drive of the spindle, which decides the tones that accompany the rotation.
enum class MotorKind : std::uint8_t { AirTurbine, Electric, LowSpeed };

/// Input of the sound for one moment of the simulation. A number that is not finite or out of range is clamped when it
/// is used.
struct DrillSoundState {
    MotorKind motor = MotorKind::AirTurbine;
    double speedRpm = 0.0;           ///< of the bur, now
    double freeSpeedRpm = 400000.0;  ///< without load at full pedal: the speed at which the motor is loudest
    double pedal = 0.0;              ///< 0 released .. 1 fully pressed: the drive air
    double load = 0.0;               ///< torque on the bur as a share of the torque that stalls it, 0..1
    double removalPower = 0.0;       ///< power that goes into the cut: tangential force times rim speed
    SoundCharacter material;         ///< of what is being cut or was touched
    std::uint32_t contactCount = 0;  ///< number of contact onsets
    double contactSpeed = 0.0;       ///< at the last contact onset, along the normal of the surface, mm/s
    std::uint32_t pullOutCount = 0;  ///< number of times that an explorer's tip came free of soft decay
    double pullOutForce = 0.0;       ///< of the hold that was overcome at the last one, N
    double contactForce = 0.0;       ///< of the tooth on the tool, N
    double slideSpeed = 0.0;         ///< of the tool along the surface that it touches, mm/s
    double water = 0.0;              ///< flow of the cooling spray, 0 off .. 1 full
    double suction = 0.0;            ///< of the tube in the mouth, 0 off .. 1 full
    int blades = 0;                  ///< of the bur; 0: a diamond, whose grains pass too fast and unevenly for a tone
};

/// `state` with every number finite and within the range of the synthesis.
[[nodiscard]] DrillSoundState sanitised(const DrillSoundState& state);

}  // namespace tactooth
