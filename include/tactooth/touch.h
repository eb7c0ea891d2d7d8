// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>

/// The public interface of the library: what another program needs for touch of a tooth with a tool. Everything else
/// below src/ may change at any time. Lengths in mm, times in s, forces in N.
namespace tactooth {

/// A rigid transform: the frame of a body in another frame.
struct RigidPose {
    std::array<double, 3> position{0, 0, 0};     ///< mm
    std::array<double, 4> rotation{1, 0, 0, 0};  ///< unit quaternion, w first
};

/// The spring and damper of the contact. None of the numbers is negative.
struct TouchSettings {
    double stiffness = 1.0;  ///< N/mm
    double damping = 0.002;  ///< N*s/mm
    double friction = 0;     ///< Coulomb coefficient
};

/// The contact at one moment, in the tooth's frame.
struct TouchResult {
    bool touching = false;
    double depth = 0;                       ///< distance between the device pose and the proxy, mm
    std::array<double, 3> normal{0, 0, 0};  ///< unit, out of the tooth; zero without contact
    std::array<double, 3> force{0, 0, 0};   ///< on the hand, N; apply limits of your own before you send it to a motor
    std::array<double, 3> torque{0, 0, 0};  ///< about the tool's origin, N*mm
    RigidPose proxy;                        ///< the pose of the tool that never enters the tooth
};

/// A tool against a tooth, both from STL files. In the tool's file the tip is at the origin, and the shaft along +z.
/// One thread at a time. `follow` neither allocates, locks nor throws once the first pose has been found.
class Touch {
public:
    /// Loads both files. On failure it returns null, and `error` holds one sentence that says what is wrong.
    [[nodiscard]] static std::unique_ptr<Touch> load(const std::filesystem::path& tooth,
                                                     const std::filesystem::path& tool, const TouchSettings& settings,
                                                     std::string& error);
    ~Touch();
    Touch(const Touch&) = delete;
    Touch& operator=(const Touch&) = delete;

    /// The device pose is `toolInTooth`, `dt` seconds after the last call; `dt` is not negative.
    TouchResult follow(const RigidPose& toolInTooth, double dt);

private:
    class Impl;
    explicit Touch(std::unique_ptr<Impl> hidden);
    std::unique_ptr<Impl> impl_;
};

}  // namespace tactooth
