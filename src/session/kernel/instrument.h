// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "collision/neighbours/tool_shape.h"
#include "instruments/bur_catalogue.h"
#include "instruments/hand_instruments.h"
#include "session/simulation/cut_model.h"

namespace tactooth {

/// The instrument in the hand.
struct Instrument {
    std::shared_ptr<const ToolShape> shape;
    CuttingTool cutting;
    BurEdge edge = {};
    bool cuts = true;  ///< false: a tool that only touches
    std::optional<HandInstrument> hand =
        {};  ///< held without a handpiece: no drive, no spray; none: a bur, or any tool

    /// Whether the carving thread has work with it: the tooth can be cut, and cuts taken back.
    [[nodiscard]] bool carves() const { return cuts || hand; }
    /// Whether it takes tissue away by the hand alone.
    [[nodiscard]] bool scrapes() const { return hand == HandInstrument::Excavator; }
};

/// A tool that only touches: it may have any shape. Not null.
[[nodiscard]] Instrument touchingTool(std::shared_ptr<const ToolShape> shape);

/// A hand instrument: its surface touches; only an excavator takes something away.
[[nodiscard]] Instrument handTool(HandInstrument kind);
/// The same with another surface, not null.
[[nodiscard]] Instrument handTool(HandInstrument kind, std::shared_ptr<const ToolShape> shape);

}  // namespace tactooth
