// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tactooth/touch.h"

#include "geometry/util/assert.h"
#include "haptics/haptic_simulation.h"
#include "haptics/load_surface.h"

namespace tactooth {
namespace {

std::array<double, 3> arrayOf(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Pose poseOf(const RigidPose& pose) {
    const auto& [w, x, y, z] = pose.rotation;
    return {Vec3(pose.position[0], pose.position[1], pose.position[2]), Quat(w, x, y, z).normalized()};
}

RigidPose rigidPoseOf(const Pose& pose) {
    return {arrayOf(pose.position), {pose.rotation.w(), pose.rotation.x(), pose.rotation.y(), pose.rotation.z()}};
}

HapticSettings settingsFor(const TouchSettings& settings) {
    HapticSettings result;
    result.force = {settings.stiffness, settings.damping, settings.friction};
    return result;
}

}  // namespace

class Touch::Impl {
public:
    Impl(std::shared_ptr<const Surface> tooth, const std::shared_ptr<const ToolShape>& tool,
         const TouchSettings& settings)
        : simulation_(tool, tool->radius(), std::move(tooth), settingsFor(settings)) {}

    TouchResult follow(const RigidPose& toolInTooth, double dt) {
        const Tick tick = simulation_.step({poseOf(toolInTooth), 0, false}, dt);
        return {tick.contact.triangles > 0,        tick.contact.depth,
                arrayOf(tick.contact.normal),      arrayOf(tick.force.wrench.force),
                arrayOf(tick.force.wrench.torque), rigidPoseOf(tick.contact.proxy)};
    }

private:
    HapticSimulation simulation_;
};

std::unique_ptr<Touch> Touch::load(const std::filesystem::path& tooth, const std::filesystem::path& tool,
                                   const TouchSettings& settings, std::string& error) {
    const auto surface = loadSurface(tooth);
    if (!surface) return error = surface.error().message(), nullptr;
    const auto shape = loadTool(tool);
    if (!shape) return error = shape.error().message(), nullptr;
    return std::unique_ptr<Touch>(new Touch(std::make_unique<Impl>(*surface, *shape, settings)));
}

Touch::Touch(std::unique_ptr<Impl> hidden) : impl_(std::move(hidden)) { TACTOOTH_ASSERT(impl_ != nullptr); }
Touch::~Touch() = default;

TouchResult Touch::follow(const RigidPose& toolInTooth, double dt) { return impl_->follow(toolInTooth, dt); }

}  // namespace tactooth
