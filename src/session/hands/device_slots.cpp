// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/device_slots.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "session/hands/instrument_poses.h"
#include "session/hands/mouse_manipulator.h"

namespace tactooth {

void DeviceSlots::set(DeviceSlot slot, std::unique_ptr<HapticDevice> device) {
    (slot == DeviceSlot::First ? first_ : second_) = std::move(device);
}

void DeviceSlots::suspendInput(bool suspended) {
    if (first_) first_->suspendInput(suspended);
}

std::optional<const Message*> DeviceSlots::changedFault() {
    const Message* fault = first_ ? first_->faultMessage() : nullptr;
    if (fault == nullptr && second_) fault = second_->faultMessage();
    if (fault == std::exchange(reportedFault_, fault)) return std::nullopt;
    return fault;
}

std::optional<WorkspaceFit> DeviceSlots::fit(const Box3& workspace, const Quat& deviceInTooth) const {
    std::optional<WorkspaceFit> fit;
    if (!first_) return fit;
    const Vec3 size = sizeInDeviceFrame(workspace.sizes(), deviceInTooth);
    for (const HapticDevice* const device : {first_.get(), second_.get()}) {
        if (device == nullptr || device->info().workspace.isZero()) continue;
        const WorkspaceFit one = fitWorkspace(device->info().workspace, size);
        fit =
            fit ? WorkspaceFit{std::min(fit->motionScaling, one.motionScaling), fit->coversBox && one.coversBox} : one;
    }
    return fit;
}

std::optional<DeviceRegistration> DeviceSlots::registration(const Pose& tool, const Box3& workspace,
                                                            const Quat& deviceInTooth, bool fitted) const {
    if (!first_ || first_->info().isInToothFrame) return {};
    const std::optional<Vec3>& centre = first_->info().workspaceCentre;
    if (!fitted || !centre) return DeviceRegistration{tool, deviceInTooth};
    return DeviceRegistration{{workspace.center(), tool.rotation}, deviceInTooth, centre};
}

Quat deviceRotation(double mesialX) {
    return Quat(Eigen::AngleAxisd(dentistView(mesialX).azimuth + std::numbers::pi / 2, Vec3::UnitZ()));
}

Box3 handWorkspace(const Box3& tooth) {
    const Vec3 margin = Vec3::Constant(MouseManipulator::kWorkspaceMargin);
    return {tooth.min() - margin, tooth.max() + margin};
}

}  // namespace tactooth
