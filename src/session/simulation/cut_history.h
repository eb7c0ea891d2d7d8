// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace tactooth {

/// A step of cutting that can be undone.
struct CutStep {
    enum class Kind : std::uint8_t {
        Stroke,  ///< from the first touch of a turning bur until it was lifted
        Reset    ///< the whole tooth was restored
    };
    Kind kind = Kind::Stroke;
    double time = 0;  ///< when it began: Tick::time of the simulation at that time, s

    friend bool operator==(const CutStep&, const CutStep&) = default;
};

/// The steps of a tooth.
struct CutHistory {
    std::vector<CutStep> done;    ///< that can be undone, oldest first
    std::vector<CutStep> undone;  ///< that can be done again; the next one to redo is at the end

    friend bool operator==(const CutHistory&, const CutHistory&) = default;
};

}  // namespace tactooth
