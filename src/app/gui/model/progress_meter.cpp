// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/progress_meter.h"

#include <utility>

namespace tactooth {

void ProgressMeter::restart(std::shared_ptr<CavityMetrics> metrics) {
    task_.cancel();
    progress_.reset();
    measured_.reset();
    metrics_ = std::move(metrics);
}

void ProgressMeter::update(const std::shared_ptr<const Surface>& tooth, double removed) {
    if (auto progress = task_.poll()) progress_ = **progress;
    if (metrics_ == nullptr || metrics_->empty() || tooth == nullptr) return;
    if (task_.isBusy() || tooth == measured_) return;
    if (began_ && clock_() - *began_ < kInterval) return;
    measured_ = tooth;
    began_ = clock_();
    task_.start(
        [metrics = metrics_, tooth, removed] { return Expected<CavityProgress>(metrics->of(*tooth, removed)); });
}

}  // namespace tactooth
