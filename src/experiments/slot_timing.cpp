// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/slot_timing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/quantile.h"
#include "experiments/thread_clock.h"
#include "geometry/util/assert.h"
#include "haptics/tool_proxy.h"
#include "instruments/bur_shape.h"
#include "instruments/hand_instruments.h"
#include "instruments/tool_trajectory.h"
#include "session/scripts/cut_run.h"
#include "session/scripts/softened_materials.h"

namespace tactooth {
namespace {

constexpr double kTick = ToolProxy::kTick;
constexpr double kRimSpeed = 300'000;  // rev/min
constexpr double kSoftened = 1000;     // times the materials' own removal: the bur keeps up with the hand
constexpr double kSlotLength = 3;      // mm
constexpr double kFeed = 10;           // mm/s, of the bur that cuts it
constexpr double kPress = 0.2;         // mm into the floor
constexpr double kSettle = 1;          // s: the hand arrives, the spindle comes to rest
constexpr double kMeasure = 5;         // s
constexpr double kLift = 5;            // mm, at kLiftSpeed
constexpr double kLiftSpeed = 10;      // mm/s

constexpr double kTremor = 0.02, kTremorHz = 9;      // mm; the physiological tremor of a hand
constexpr double kSlideSpeed = 5, kSlideLength = 1;  // mm/s, mm
constexpr double kTurnSpeed = 30, kTurn = 5;         // degrees

int ticksIn(double seconds) { return static_cast<int>(seconds / kTick); }

/// To and fro between 0 and `most` at unit speed.
double toAndFro(double distance, double most) { return most - std::abs(std::fmod(distance, 2 * most) - most); }

/// The tool's pose in a motion that begins at `start`, at the slot's end in the direction of +x.
Pose moved(const Pose& start, SlotMotion motion, double time) {
    Pose pose = start;
    const Vec3 shaft = start.rotation * Vec3::UnitZ();
    pose.position -= kPress * shaft;
    switch (motion) {
        case SlotMotion::Rest:
            break;
        case SlotMotion::Tremor:
            pose.position += kTremor * std::sin(2 * std::numbers::pi * kTremorHz * time) * Vec3::UnitY();
            break;
        case SlotMotion::Slide:
            pose.position -= toAndFro(kSlideSpeed * time, kSlideLength) * Vec3::UnitX();
            break;
        case SlotMotion::Turn: {
            const double degrees = toAndFro(kTurnSpeed * time, kTurn);
            pose.rotation = Quat(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, shaft)) * start.rotation;
            break;
        }
    }
    return pose;
}

/// Where a bur goes that cuts the slot: down beside the middle of the tooth's top and straight along, and there it
/// stays.
std::vector<TimedPose> slotPath(const TriangleMesh& tooth, double depth) {
    ToolTrajectory distance;
    distance.stroke = kSlotLength;
    const Pose above = toolTrajectory(tooth, distance).front();
    const Vec3 down(0, 0, -distance.approach - depth);
    const Vec3 along(kSlotLength, 0, 0);
    std::vector<TimedPose> rows;
    const auto go = [&](const Vec3& from, const Vec3& by) {
        const int ticks = ticksIn(by.norm() / kFeed);
        for (int i = 0; i <= ticks; ++i) {
            const Vec3 place = from + by * (static_cast<double>(i) / ticks);
            rows.push_back({kTick * static_cast<double>(rows.size()), {place, above.rotation}});
        }
    };
    go(above.position, down);
    go(above.position + down, along);
    return rows;
}

/// A still tool in a piece that is cut no more; its lists are made beside the ticks, as in the program.
class StillTool {
public:
    StillTool(const CutModel& piece, const std::shared_ptr<const ToolShape>& shape, double radius)
        : model_(piece),
          simulation_(shape, radius, piece.contactSurface(), HapticSettings()),
          surfaceBuilder_(simulation_.tool(), piece.contactSurface()) {}

    Tick step(const Pose& device, double& micros) {
        const double start = threadMicros();
        const Tick tick = simulation_.step({device, 0, false}, kTick);
        micros = threadMicros() - start;
        updateHapticSurface(model_, tick, false, surfaceBuilder_, simulation_);
        return tick;
    }
    Tick step(const Pose& device) {
        double micros = 0;
        return step(device, micros);
    }

private:
    const CutModel& model_;
    HapticSimulation simulation_;
    HapticSurfaceBuilder surfaceBuilder_;
};

SlotTiming timeMotion(StillTool& tool, const Pose& start, SlotMotion motion) {
    SlotTiming timing{.motion = motion};
    const Vec3 shaft = start.rotation * Vec3::UnitZ();
    for (int i = ticksIn(kSettle); i > 0; --i) {  // from above, where it is free
        const double above = kLift * static_cast<double>(i) / ticksIn(kSettle);
        Pose device = moved(start, motion, 0);
        device.position += above * shaft;
        tool.step(device);
    }
    std::vector<double> micros;
    std::vector<Vec3> forces;
    Pose first, last;
    for (int i = 0; i < ticksIn(kSettle + kMeasure); ++i) {
        double took = 0;
        const Tick tick = tool.step(moved(start, motion, i * kTick), took);
        if (i < ticksIn(kSettle)) {
            first = tick.contact.proxy;
            continue;
        }
        last = tick.contact.proxy;
        micros.push_back(took);
        forces.push_back(tick.force.wrench.force);
        timing.force += tick.force.wrench.force.norm();
    }
    timing.ticks = micros.size();
    timing.force /= static_cast<double>(timing.ticks);
    Vec3 mean = Vec3::Zero();
    for (const Vec3& force : forces) mean += force / static_cast<double>(forces.size());
    for (const Vec3& force : forces) timing.noise = std::max(timing.noise, (force - mean).norm());
    timing.sunk = (first.position - last.position).dot(shaft);
    timing.p50 = quantile(micros, 0.5);
    timing.p99 = quantile(micros, 0.99);
    timing.p999 = quantile(micros, 0.999);
    timing.largest = quantile(micros, 1);

    Pose device = moved(start, motion, kTick * ticksIn(kSettle + kMeasure));
    Tick tick;
    for (int i = 0; i < ticksIn(kLift / kLiftSpeed); ++i) {
        device.position += kLiftSpeed * kTick * shaft;
        tick = tool.step(device);
    }
    timing.leaves = tick.contact.triangles == 0 && tick.force.wrench.force.isZero(0) &&
                    tick.contact.proxy.position == device.position;
    return timing;
}

}  // namespace

std::string_view slotMotionName(SlotMotion motion) {
    switch (motion) {
        case SlotMotion::Rest:
            return "rests";
        case SlotMotion::Tremor:
            return "trembles";
        case SlotMotion::Slide:
            return "slides";
        case SlotMotion::Turn:
            return "turns";
    }
    return {};
}

std::vector<SlotTiming> timeInSlot(const std::shared_ptr<const LayeredTooth>& tooth, const BurSpec& bur, double depth,
                                   double voxel, bool probe) {
    const auto piece = std::make_shared<CutModel>(tooth, voxel);
    TriangleMesh mesh = makeBur(bur).surface;
    const CuttingTool tool{*RevolutionEnvelope::make(mesh), bur.sharpness};
    const double radius = tool.envelope.maxRadius();
    auto shape = std::make_shared<const ToolShape>(std::move(mesh));
    HapticSettings settings;
    settings.materials = softenedMaterials(kSoftened);
    settings.spindle = constantSpeed(kRimSpeed);
    StepwiseSession cutting(piece, cutSetup({shape, tool}, settings));
    Pose end;
    const std::vector<TimedPose> path = slotPath(tooth->outer()->mesh(), depth);
    // Built-in shapes and a path of our own give finite ticks.
    [[maybe_unused]] const auto isCut =
        cutWithRemovalLaw(path, cutting, [&](double, const Tick& tick, const ToothLoss&) { end = tick.contact.proxy; });
    TACTOOTH_ASSERT(isCut);

    if (probe) shape = std::make_shared<const ToolShape>(makePeriodontalProbe());
    StillTool still(*piece, shape, radius);
    std::vector<SlotTiming> timings;
    for (const SlotMotion motion : kSlotMotions) timings.push_back(timeMotion(still, end, motion));
    return timings;
}

}  // namespace tactooth
