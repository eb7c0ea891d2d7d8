// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/util/pose.h"
#include "haptics/wrench.h"
#include "tooth/model/material_registry.h"

namespace tactooth {

/// All results of one tick, for the device, the recorder, the plots and the sound. Lengths in mm, forces in N, in the
/// tooth's frame.
struct Tick {
    /// What the step took from the user.
    struct Input {
        Pose device;           ///< of the tool, as the device asks for it
        double speed = 0;      ///< of the device's tip, mm/s
        bool cutting = false;  ///< as OperatorInput::cutting; never for an instrument in the hand
        double pedal = 0;      ///< 0 up .. 1 down
    };
    /// Where the tool is and what holds it there.
    struct Contact {
        Pose proxy;
        double depth = 0;                  ///< distance between the device pose and the proxy
        Vec3 normal = Vec3::Zero();        ///< unit, out of the tooth; zero without contact
        int triangles = 0;                 ///< that hold the proxy
        bool placed = false;               ///< false: the device pose is faulty, or no free pose is known; no force
        MaterialId material{};             ///< where the multiplier is largest; undefined without contact
        std::optional<MaterialId> around;  ///< of a body of the surroundings, if one holds the tool
        std::uint32_t onsets = 0;          ///< number of contact onsets so far
        double impactSpeed = 0;            ///< along the normal at the last onset, mm/s
        double slideSpeed = 0;             ///< of the proxy along the surface, mm/s; 0 without contact
        std::uint32_t pullOuts = 0;        ///< number of times so far that an explorer's tip came free of soft decay
        double pullOutForce = 0;           ///< of the hold that was overcome at the last one, N
    };
    struct Force {
        Wrench wrench;              ///< computed; the force pipeline comes after it
        Vec3 drive = Vec3::Zero();  ///< the pull of the spinning bur: its energy comes from the drive
        double stiffness = 0;       ///< of the contact spring, N/mm; 0 without contact
        double deflection = 0;      ///< of the contact spring, inwards and against friction, mm
        double tipHold = 0;         ///< what draws an explorer's tip out of soft decay; 0: nothing holds it
    };
    struct Spindle {
        double speedRpm = 0;      ///< of the bur
        double load = 0;          ///< torque on the bur, N*mm
        double removalPower = 0;  ///< tangential force times rim speed, W
        double cutWork = 0;       ///< normal force times rim travel since the start, N*m: what the removal law spends;
                                  ///< of an excavator, normal force times the path of the hand
    };
    struct Diagnostics {
        std::uint32_t ownListRebuilds = 0;  ///< number of ticks that had to rebuild the neighbour list themselves
        double micros = 0;                  ///< computing time of the tick, us; the caller fills it in
    };

    std::uint32_t number = 0;  ///< since the start, from 1; the caller fills it in; 0: not counted
    double time = 0;           ///< s since the start of the simulation
    Input input;
    Contact contact;
    Force force;
    Spindle spindle;
    Diagnostics diagnostics;
};

}  // namespace tactooth
