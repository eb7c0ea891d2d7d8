// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "collision/bvh/surface.h"

namespace tactooth {

/// Finds where a tooth has changed between two snapshots.
class SurfaceChange {
public:
    /// The box around the patches that differ between `tooth` and the tooth of the last call, mm. All removed and
    /// restored volume lies in it. Empty if nothing has changed. The first call compares with the uncut tooth.
    [[nodiscard]] Box3 changedBox(const Surface& tooth);

private:
    std::vector<std::shared_ptr<const SurfacePart>> patches_;  // of the last call, in the order of their addresses
};

}  // namespace tactooth
