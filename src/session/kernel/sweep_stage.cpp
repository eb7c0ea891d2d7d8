// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/kernel/sweep_stage.h"

#include <numbers>
#include <utility>

#include "geometry/util/assert.h"
#include "session/kernel/servo_stage.h"

namespace tactooth {

SweepStage::SweepStage(std::shared_ptr<CutModel> model, const CuttingTool& tool, double speedRpm,
                       MaterialTable materials)
    : model_(std::move(model)),
      tool_(tool),
      rimSpeed_(speedRpm / 60 * 2 * std::numbers::pi * tool.envelope.maxRadius() * 1e-3),
      materials_(std::move(materials)) {
    TACTOOTH_ASSERT(model_ != nullptr);
    TACTOOTH_ASSERT(rimSpeed_ >= 0);
}

Tick SweepStage::step(const Pose& tool, double time, double elapsed, bool spins) {
    TACTOOTH_ASSERT(isRigid(tool));
    const Pose before = last_.value_or(tool);
    const Vec3 step = tool.position - before.position;
    last_ = tool;
    Tick tick;
    tick.number = ++ticks_;
    tick.time = time;
    tick.input.device = tick.contact.proxy = tool;
    tick.contact.placed = tick.input.cutting = true;
    tick.input.speed = elapsed > 0 ? step.norm() / elapsed : 0;
    if (spins) {
        const MaterialVolumes volumes = model_->sweep(tool_, before, tool);
        const double travel = rimSpeed_ * elapsed;
        if (travel > 0 && step.norm() > 0) {
            tick.contact.normal = -step.normalized();
            tick.force.wrench.force = workFor(volumes, materials_, tool_.sharpness) / travel * tick.contact.normal;
        }
    }
    addToHash(hash_, tick);
    return tick;
}

}  // namespace tactooth
