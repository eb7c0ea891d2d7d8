// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/felt_surface.h"

namespace tactooth {
namespace {

constexpr std::size_t kCapacity = 1 << 14;  // clusters; it grows where more are near

// How far beyond the way expected the list reaches: what a hand of 20 mm/s strays until it feels the surface, mm ...
constexpr double kAround = 0.025;
// ... and that it turns at 50 degrees/s for 10 ms: a chord, as in Skin.
constexpr double kTurn = 0.008;

}  // namespace

FeltSurface* FeltSurfaces::make(std::shared_ptr<const Surface> surface, const Pose& from, const Pose& to) {
    if (free_.empty()) {
        all_.push_back(std::make_unique<FeltSurface>(FeltSurface{nullptr, PairList(*tool_, kCapacity)}));
        free_.push_back(all_.back().get());
    }
    FeltSurface* felt = free_.back();
    free_.pop_back();
    felt->surface = std::move(surface);
    felt->reach = to.position;
    felt->near.makeAll(*felt->surface, from, {to.position - from.position, kAround, kTurn});
    return felt;
}

void FeltSurfaces::giveBack(FeltSurface* felt) {
    felt->surface = nullptr;
    free_.push_back(felt);
}

}  // namespace tactooth
