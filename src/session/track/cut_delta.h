// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "session/simulation/cut_model.h"

namespace tactooth {

/// The difference of the cut tooth between two moments: for each brick the bits that differ, and those of the lost
/// volumes. The same difference leads forward and back, and differences may be applied in any order, because a bit that
/// is turned twice is as it was.
class CutDelta {
public:
    void add(const BrickKey& key, const CutField& before, const CutField& after);
    void add(const ToothLoss& before, const ToothLoss& after);

    [[nodiscard]] std::vector<std::byte> take() { return std::exchange(bytes_, {}); }
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }

private:
    std::vector<std::byte> bytes_;
};

/// Applies a difference, as CutDelta::take gave it. `fieldOf` gives the field of a brick to change.
void applyDelta(std::span<const std::byte> delta, const std::function<CutField&(const BrickKey&)>& fieldOf,
                ToothLoss& loss);

}  // namespace tactooth
