// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/device_aids.h"

#include <utility>

namespace tactooth {

void DeviceAids::setWalls(std::shared_ptr<const DistanceGrid> walls) {
    walls_ = std::move(walls);
    makeGuide();
}

void DeviceAids::setBur(const SessionBur& bur) {
    bur_ =
        bur.isHandInstrument() ? nullptr : std::make_shared<const RevolutionEnvelope>(bur.instrument.cutting.envelope);
    makeGuide();
}

void DeviceAids::makeGuide() {
    guide_ = walls_ != nullptr && bur_ != nullptr ? std::make_shared<const WallGuide>(walls_, *bur_) : nullptr;
}

void DeviceAids::addTo(SessionControls& controls, const DepthControl& depth) const {
    if (stops_ && bur_ != nullptr) controls.depthStop = std::make_shared<const DepthControl>(depth);
    if (guides_) controls.guide = guide_;
}

}  // namespace tactooth
