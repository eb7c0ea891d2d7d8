// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "collision/neighbours/tool_shape.h"
#include "instruments/bur_catalogue.h"
#include "session/simulation/cut_model.h"

namespace tactooth {

/// The instrument in the hand.
struct Instrument {
    std::shared_ptr<const ToolShape> shape;
    CuttingTool cutting;
    BurEdge edge = {};
    bool cuts = true;  ///< false: a tool that only touches
};

/// A tool that only touches: it may have any shape. Not null.
[[nodiscard]] Instrument touchingTool(std::shared_ptr<const ToolShape> shape);

}  // namespace tactooth
