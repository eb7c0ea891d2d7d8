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
    Jump,  ///< of 50 mm
};

/// The stand-in's own door, beside HDAPI's functions: found by dlsym as "standinControl".
struct HdStandinControl {
    void (*reset)();
    void (*setFault)(int fault);
    void (*wantPosition)(double x, double y, double z);  ///< where its hand wants to be, mm, HDAPI's frame
    void (*setButtons)(int buttons);
    void (*lastForce)(double* xyz);    ///< N, HDAPI's frame, of the first pen
    double (*strongestForce)();        ///< N, since the reset
    double (*strongestWhileFaulty)();  ///< N, later than 5 ms after a fault was set
    /// Of the frames since a faulty reading was given (0: that reading's own), the last that still set a force on the
    /// first pen; -1: none did. One frame is one millisecond.
    int (*lastFrameWithForce)();
    double (*forceMsAfterFault)();  ///< from the faulty reading to the last force, as the clock saw it
    long (*ticks)();
    int (*startedPens)();
};

}  // namespace tactooth::test
