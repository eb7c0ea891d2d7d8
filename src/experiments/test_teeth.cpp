// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/test_teeth.h"

namespace tactooth {

Expected<const StandardTooth*> TestTeeth::tooth(StandardToothKind kind) {
    if (const auto found = teeth_.find(kind); found != teeth_.end()) return &found->second;
    auto made = standardTooth(kind);
    if (!made) return Unexpected{made.error()};
    return &teeth_.emplace(kind, std::move(*made)).first->second;
}

Expected<const std::vector<Resolution>*> TestTeeth::ladder(StandardToothKind kind) {
    if (const auto found = ladders_.find(kind); found != ladders_.end()) return &found->second;
    const auto whole = tooth(kind);
    if (!whole) return Unexpected{whole.error()};
    return &ladders_.emplace(kind, resolutionLadder((*whole)->mesh, kResolutions)).first->second;
}

std::vector<const StandardTooth*> TestTeeth::used() const {
    std::vector<const StandardTooth*> teeth;
    for (const auto& [kind, tooth] : teeth_) teeth.push_back(&tooth);
    return teeth;
}

}  // namespace tactooth
