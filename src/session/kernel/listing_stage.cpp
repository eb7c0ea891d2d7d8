// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/kernel/listing_stage.h"

#include <utility>

namespace tactooth {

ListingStage::ListingStage(std::shared_ptr<const ToolShape> tool, const std::shared_ptr<const Surface>& surface,
                           Placement placement)
    : surfaces_(std::move(tool), surface), newest_(surface), placement_(placement) {}

HapticSurface* ListingStage::turn(const Tick& now, std::optional<CarvedSurface> cut) {
    if (cut) {
        newest_ = cut->surface;
        unsent_ = std::move(cut);
    }
    if (now.contact.placed) surfaces_.watch(now.time, now.contact.proxy, now.diagnostics.ownListRebuilds);
    if (unsent_)
        return surfaces_.make(unsent_->surface, now.contact.proxy, unsent_->reached.value_or(now.contact.proxy));
    const bool waits = !now.contact.placed && placement_ == Placement::Deferred;
    return waits ? surfaces_.place(newest_, now.input.device) : surfaces_.rebuild();
}

}  // namespace tactooth
