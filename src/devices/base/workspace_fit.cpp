// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/workspace_fit.h"

#include <algorithm>
#include <cmath>

namespace tactooth {

WorkspaceFit fitWorkspace(const Vec3& workspace, const Vec3& box) {
    constexpr double kSteps = 10;       // steps in each unit of motion scaling
    constexpr double kRounding = 1e-9;  // tolerance for a workspace that is only just large enough
    const double most = workspace.cwiseQuotient(box).minCoeff();
    if (!(most >= kMinMotionScaling - kRounding)) return {kMinMotionScaling, false};
    return {std::clamp(std::floor(kSteps * most + kRounding) / kSteps, kMinMotionScaling, kMaxMotionScaling), true};
}

Vec3 sizeInDeviceFrame(const Vec3& size, const Quat& turn) {
    return turn.toRotationMatrix().transpose().cwiseAbs() * size;
}

bool isNearWorkspaceLimit(const DeviceInfo& device, const Vec3& hand, double margin) {
    if (!device.workspaceCentre) return false;
    const Vec3 left = 0.5 * device.workspace - (hand - *device.workspaceCentre).cwiseAbs();
    return left.minCoeff() < margin;
}

}  // namespace tactooth
