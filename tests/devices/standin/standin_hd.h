// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tactooth::test {

/// What goes wrong in the stand-in library.
enum class HdFault : int {
    None,
    InitError,      ///< the device reports a fault when it is started
    InUse,          ///< another program holds it
    GarbageHandle,  ///< a handle that is none, and no error
    LinkFault,      ///< an error of the link at every frame, until it is mended
    Unplugged,      ///< no callback comes any more
    WarmMotors,     ///< one error a frame
    TooMuchForce,   ///< one error
    NeedsInkwell,   ///< the pen has to be docked
    Stall,          ///< one pause of the callbacks of 5 ms
    NanPose,
    Jump,          ///< of 50 mm
    DeviceFault,   ///< an error at every frame, while the motors go on
    CrashAtStart,  ///< the library crashes when a device is started
    BentAxes,      ///< three axes that are no turn
    FlippingTurn,  ///< a quarter turn, to and fro
    Jitter,        ///< of 4.9 mm, to and fro
    Drift,         ///< of 3 m/s
    NanHeat,       ///< temperatures that are no number
    Flood,         ///< 20,000 callbacks a second
    ErrorFlood,    ///< as many errors of the link at each frame as nobody takes
    Boast,         ///< a device that says that it makes 50 N, and 40 for ever
    Weak,          ///< a device that says that it makes 1 N, and 0.4 for ever
};

/// The stand-in's own door, beside HDAPI's functions: found by dlsym as "standinControl".
struct HdStandinControl {
    void (*reset)();
    void (*setFault)(int fault);
    void (*setFaultyPen)(int pen);                       ///< whose link a fault takes; -1: all
    void (*wantPosition)(double x, double y, double z);  ///< where its hand wants to be, mm, HDAPI's frame
    void (*setButtons)(int buttons);                     ///< of the first pen
    void (*lastForce)(double* xyz);                      ///< N, HDAPI's frame, of the first pen
    double (*forceOf)(int pen);                          ///< N; 0 the first, 1 the one called Left
    double (*strongestForce)();                          ///< N, since the reset
    double (*strongestWhileFaulty)();                    ///< N, later than 5 ms after a fault was set
    long (*ticks)();
    /// Of the first pen: in which tick after a fault was set it was last given a force that its motors made; the first
    /// such tick is the one whose reading is bad. 0: in none.
    long (*lastForceSinceFault)();
    int (*startedPens)();
    int (*schedulerStarts)();
};

}  // namespace tactooth::test
