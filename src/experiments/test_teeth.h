// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>

#include "collision/neighbours/tool_shape.h"
#include "experiments/standard_teeth.h"

namespace tactooth {

/// The teeth that experiments share. Each is made at its first use.
class TestTeeth {
public:
    /// All standard teeth and their resolutions; fails if a file is there but cannot be read.
    [[nodiscard]] Expected<const StandardTooth*> tooth(StandardToothKind kind);
    [[nodiscard]] Expected<const std::vector<Resolution>*> ladder(StandardToothKind kind);

    /// The teeth used so far, in the order of StandardToothKind.
    [[nodiscard]] std::vector<const StandardTooth*> used() const;

    /// The standard bur as a tool shape.
    [[nodiscard]] const std::shared_ptr<const ToolShape>& bur() const { return bur_; }

private:
    std::map<StandardToothKind, StandardTooth> teeth_;
    std::map<StandardToothKind, std::vector<Resolution>> ladders_;
    std::shared_ptr<const ToolShape> bur_ = std::make_shared<const ToolShape>(standardBur());
};

}  // namespace tactooth
