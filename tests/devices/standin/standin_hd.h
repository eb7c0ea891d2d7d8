// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tactooth::test {

/// Faults of the stand-in library.
enum class HdFault : int {
    None,
    InitError,      ///< the device reports a fault when it is started
    InUse,          ///< another program uses it
    GarbageHandle,  ///< an invalid handle, and no error
    LinkFault,      ///< a link error at every frame, until the fault is cleared
    Unplugged,      ///< no callbacks any more
    WarmMotors,     ///< one error in each frame
    TooMuchForce,   ///< one error
    NeedsInkwell,   ///< the pen has to be docked
    Stall,          ///< one pause of the callbacks, 5 ms long
    NanPose,
    Jump,          ///< the position jumps by 50 mm, to and fro
    DeviceFault,   ///< an error at every frame, while the motors keep running
    CrashAtStart,  ///< the library crashes when a device is started
    BentAxes,      ///< three axes that are not a rotation
    FlippingTurn,  ///< a quarter rotation, to and fro
    Jitter,        ///< the position jumps by 4.9 mm, to and fro
    Drift,         ///< the position drifts at 3 m/s
    NanHeat,       ///< temperatures that are not a number
    Flood,         ///< 20,000 callbacks a second
    ErrorFlood,    ///< 1,000 link errors at each frame, more than a caller takes
    Boast,         ///< a device that reports a peak force of 50 N and a continuous force of 40 N
    Weak,          ///< a device that reports a peak force of 1 N and a continuous force of 0.4 N
};

/// The stand-in's control interface, in addition to HDAPI's functions: dlsym finds it as "standinControl".
struct HdStandinControl {
    void (*reset)();
    void (*setFault)(int fault);
    void (*setFaultyPen)(int pen);                       ///< the pen whose link a fault affects; -1: all
    void (*wantPosition)(double x, double y, double z);  ///< target position of its hand, mm, in HDAPI's frame
    void (*setButtons)(int buttons);                     ///< of the first pen
    void (*lastForce)(double* xyz);                      ///< N, HDAPI's frame, of the first pen
    double (*forceOf)(int pen);                          ///< N; pen 0 is the first, 1 the one named Left
    double (*strongestForce)();                          ///< N, since the reset
    double (*strongestWhileFaulty)();                    ///< N, more than 5 ms and 5 ticks after a fault was set
    long (*ticks)();
    /// The last tick after a fault was set in which the first pen received a force that its motors rendered. Tick 1 is
    /// the one with the bad reading. 0: in none.
    long (*lastForceSinceFault)();
    int (*startedPens)();
    int (*schedulerStarts)();
};

}  // namespace tactooth::test
