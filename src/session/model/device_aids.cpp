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
    bur_.reset();
    if (!bur.isHandInstrument()) bur_ = bur.instrument.cutting.envelope;
    makeGuide();
}

void DeviceAids::makeGuide() {
    guide_ = walls_ != nullptr && bur_ ? std::make_shared<const WallGuide>(walls_, *bur_) : nullptr;
}

void DeviceAids::addTo(SessionControls& controls, const DepthControl& depth) const {
    if (stops_ && bur_) controls.depthStop = std::make_shared<const DepthControl>(depth);
    if (guides_) controls.guide = guide_;
}

}  // namespace tactooth
