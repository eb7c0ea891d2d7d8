// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>

/// The library's public face: what another program needs to let a hand feel a tool against a tooth. Everything else
/// below src/ may change at any time. Lengths in mm, times in s, forces in N.
namespace tactooth {

/// Where a body stands in another frame.
struct RigidPose {
    std::array<double, 3> position{0, 0, 0};     ///< mm
    std::array<double, 4> rotation{1, 0, 0, 0};  ///< unit quaternion, w first
};

/// The spring and damper that the hand feels.
struct TouchSettings {
    double stiffness = 1.0;  ///< N/mm
    double damping = 0.002;  ///< N*s/mm
    double friction = 0;     ///< Coulomb coefficient
};

/// What the hand feels at one moment, in the tooth's frame.
struct TouchResult {
    bool touching = false;
    double depth = 0;                       ///< from the hand's pose to the proxy's, mm
    std::array<double, 3> normal{0, 0, 0};  ///< unit, out of the tooth; zero without contact
    std::array<double, 3> force{0, 0, 0};   ///< on the hand, N; pass it through your own limits before a motor
    std::array<double, 3> torque{0, 0, 0};  ///< about the tool's origin, N*mm
    RigidPose proxy;                        ///< the tool's pose that never enters the tooth
};

/// A tool in a hand, against a tooth, both from STL files. The tool's file has its tip at the origin and its shaft
/// along +z. One thread at a time; `follow` neither allocates, locks nor throws once the first pose has been found.
class Touch {
public:
    /// Loads both files. On failure returns null, and `error` holds one sentence that says what is wrong.
    [[nodiscard]] static std::unique_ptr<Touch> load(const std::filesystem::path& tooth,
                                                     const std::filesystem::path& tool, const TouchSettings& settings,
                                                     std::string& error);
    ~Touch();
    Touch(const Touch&) = delete;
    Touch& operator=(const Touch&) = delete;

    /// The hand holds the tool at `toolInTooth`, `dt` seconds after the call before.
    TouchResult follow(const RigidPose& toolInTooth, double dt);

private:
    class Impl;
    explicit Touch(std::unique_ptr<Impl> hidden);
    std::unique_ptr<Impl> impl_;
};

}  // namespace tactooth
