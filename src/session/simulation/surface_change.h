// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "collision/bvh/surface.h"

namespace tactooth {

/// Tells where a tooth has changed from one snapshot to the next.
class SurfaceChange {
public:
    /// The box around the patches that only one of `tooth` and the last call's tooth has, mm: all that went or came
    /// back lies in it, the middle of a large piece, too. Empty: nothing has changed. The first call compares with the
    /// uncut tooth.
    [[nodiscard]] Box3 changedBox(const Surface& tooth);

private:
    std::vector<std::shared_ptr<const SurfacePart>> patches_;  // of the last call, in the order of their addresses
};

}  // namespace tactooth
