// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The same script gives the same bits: on every run, on any number of threads, in Debug and in Release. If a change
// means to alter forces or cuts, the literal below changes with it, and the commit says why.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <bit>
#include <string>

#include "devices/simulated/scripted_device.h"
#include "geometry/util/fnv1a.h"
#include "instruments/builtin_tooth.h"
#include "instruments/bur_shape.h"
#include "session/scripts/cut_run.h"
#include "support/servo_tick.h"

namespace tactooth {
namespace {

constexpr std::uint64_t kGolden = 0x8b23c6fb2bc809ffULL;

using test::kTick;
constexpr double kVoxel = 0.05;
constexpr std::uint32_t kCutButton = 2;

/// FNV-1a, 64 bit, over the bits of doubles.
class Fingerprint {
public:
    void add(double value) { hash_.addBytesOf(std::bit_cast<std::uint64_t>(value)); }
    void add(const Vec3& v) {
        for (const double component : {v.x(), v.y(), v.z()}) add(component);
    }
    void add(const Quat& q) {
        for (const double component : {q.w(), q.x(), q.y(), q.z()}) add(component);
    }
    void add(std::uint64_t value) { hash_.addBytesOf(value); }
    [[nodiscard]] std::uint64_t value() const { return hash_.value(); }

private:
    Fnv1a hash_;
};

/// What a replay has come to.
struct Outcome {
    std::uint64_t hash = 0;
    std::uint64_t tooth = 0;  // hash of the outer surface, to tell where a difference begins
    std::uint64_t touch = 0;  // hash up to the first cut
    double removed = 0;       // mm^3
    int touched = 0;          // ticks in contact while the bur stands still
    int cut = 0;              // ticks in contact while it spins
};

/// Touches the fissure of a crown whose highest point is at `top`, strokes it, lifts off while the turbine starts, and
/// cuts into it, leaning a little.
std::vector<DeviceKeyframe> script(double top) {
    const auto moment = [&](double time, const Vec3& tip, double lean, std::uint32_t buttons) {
        const Quat rotation(Eigen::AngleAxisd(lean, Vec3::UnitX()));
        return DeviceKeyframe{time, {{tip + Vec3(0, 0, top), rotation}, buttons ? 1.0 : 0.0, buttons, true}};
    };
    return {moment(0.00, Vec3(-0.2, 0.1, 0.3), 0, 0),          moment(0.08, Vec3(-0.2, 0.1, -2.4), 0, 0),
            moment(0.16, Vec3(-1.2, -0.4, -2.4), 0.2, 0),      moment(0.18, Vec3(-0.4, 0, 0.3), 0.1, kCutButton),
            moment(0.48, Vec3(-0.4, 0, 0.3), 0.1, kCutButton), moment(0.52, Vec3(-0.4, 0, -3.4), 0.1, kCutButton),
            moment(0.64, Vec3(-0.9, 0.2, -3.7), 0, kCutButton)};
}

std::uint64_t hashOf(const TriangleMesh& mesh) {
    Fingerprint fingerprint;
    for (const Vec3f& vertex : mesh.vertices) fingerprint.add(Vec3(vertex.cast<double>()));
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) fingerprint.add(std::uint64_t{corner});
    }
    return fingerprint.value();
}

Outcome replay(const BuiltinTooth& molar) {
    const double top = boundingBox(molar.outer).max().z();
    auto tooth = LayeredTooth::make(molar.outer, layersOf(molar));
    EXPECT_TRUE(tooth);
    CutModel piece(std::make_shared<const LayeredTooth>(std::move(*tooth)), kVoxel);
    const Bur bur = makeBur(*findBur("4"));
    const CuttingTool cutting{*RevolutionEnvelope::make(bur.surface), bur.spec.sharpness};
    HapticSimulation simulation(std::make_shared<const ToolShape>(bur.surface), cutting.envelope.maxRadius(),
                                piece.surface(), HapticSettings());
    HapticSurfaceBuilder surfaces(simulation.tool(), piece.contactSurface());
    const std::vector<DeviceKeyframe> moments = script(top);
    ScriptedDevice hand(moments);

    Outcome outcome;
    outcome.tooth = hashOf(molar.outer);
    Fingerprint fingerprint;
    const int ticks = static_cast<int>(moments.back().time / kTick);
    for (int i = 0; i < ticks; ++i) {
        const DeviceSample sample = hand.read(kTick);
        const bool cuts = sample.buttons == kCutButton;
        const Tick tick = simulation.step({sample.hand, sample.pedal, cuts}, kTick);
        updateHapticSurface(piece, tick, cuts && piece.feed(cutting, tick, MaterialTable()), surfaces, simulation);
        fingerprint.add(tick.force.wrench.force);
        fingerprint.add(tick.force.wrench.torque);
        fingerprint.add(tick.contact.proxy.position);
        fingerprint.add(tick.contact.proxy.rotation);
        if (!cuts) outcome.touch = fingerprint.value();
        (cuts ? outcome.cut : outcome.touched) += tick.contact.triangles > 0;
    }
    fingerprint.add(piece.hash());
    outcome.hash = fingerprint.value();
    outcome.removed = total(piece.removed());
    return outcome;
}

TEST(Replay, GivesTheSameBitsOnAnyRunAnyBuildAndAnyNumberOfThreads) {
    const BuiltinTooth molar = makeBuiltinTooth(BuiltinToothKind::LowerFirstMolar, 4000);
    const Outcome first = replay(molar);
    RecordProperty("hash", std::to_string(first.hash));  // compared across compilers by .github/workflows/ci.yml
    EXPECT_GT(first.touched, 50);
    EXPECT_GT(first.cut, 80);
    EXPECT_GT(first.removed, 0.005);
    EXPECT_EQ(replay(molar).hash, first.hash);
    const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(replay(molar).hash, first.hash);
    EXPECT_EQ(first.hash, kGolden) << std::hex << "hash 0x" << first.hash << ", tooth 0x" << first.tooth << ", touch 0x"
                                   << first.touch;
}

}  // namespace
}  // namespace tactooth
