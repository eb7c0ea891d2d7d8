// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/surface_change.h"

#include <algorithm>
#include <functional>
#include <iterator>

namespace tactooth {
namespace {

bool isEarlier(const std::shared_ptr<const SurfacePart>& a, const std::shared_ptr<const SurfacePart>& b) {
    return std::less<const SurfacePart*>()(a.get(), b.get());
}

}  // namespace

Box3 SurfaceChange::changedBox(const Surface& tooth) {
    std::vector<std::shared_ptr<const SurfacePart>> patches = tooth.patches;
    std::sort(patches.begin(), patches.end(), isEarlier);
    std::vector<std::shared_ptr<const SurfacePart>> changed;
    std::set_symmetric_difference(patches_.begin(), patches_.end(), patches.begin(), patches.end(),
                                  std::back_inserter(changed), isEarlier);
    Box3 box;
    for (const auto& patch : changed) box.extend(patch->tree().box());
    patches_ = std::move(patches);
    return box;
}

}  // namespace tactooth
