// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bench_mouth.h"

#include <array>
#include <cmath>
#include <numbers>

#include "instruments/builtin_tooth.h"
#include "instruments/mirror.h"

namespace tactooth {
namespace {

constexpr int kTeethOfArch = 16;
constexpr double kArchWidth = 50;     // mm between the last molars
constexpr double kArchDepth = 45;     // mm from the incisors to the last molars
constexpr double kArchDistance = 34;  // mm from neck to neck of an open mouth

/// The middle line of an arch, a half ellipse from -90 degrees (last molar of one side) to 90 degrees.
Vec3 onArch(double angle) { return {kArchWidth / 2 * std::sin(angle), kArchDepth * std::cos(angle), 0}; }

double angleOf(int tooth) { return std::numbers::pi * ((tooth + 0.5) / kTeethOfArch - 0.5); }

/// A tube along the arch, 3 mm thick, of two triangles a piece.
TriangleMesh gum() {
    constexpr int kAlong = 400, kAround = 32;
    TriangleMesh mesh;
    for (int i = 0; i <= kAlong; ++i) {
        const double angle = std::numbers::pi * (static_cast<double>(i) / kAlong - 0.5);
        const Vec3 outward = onArch(angle).normalized();
        for (int j = 0; j < kAround; ++j) {
            const double turn = 2 * std::numbers::pi * j / kAround;
            const Vec3 point = onArch(angle) + 6 * std::cos(turn) * outward + Vec3(0, 0, 3 * std::sin(turn) - 3);
            mesh.vertices.push_back(point.cast<float>());
        }
    }
    for (std::uint32_t i = 0; i < kAlong; ++i) {
        for (std::uint32_t j = 0; j < kAround; ++j) {
            const std::uint32_t a = i * kAround + j;
            const std::uint32_t b = i * kAround + (j + 1) % kAround;
            mesh.triangles.push_back({a, a + kAround, b});
            mesh.triangles.push_back({b, a + kAround, b + kAround});
        }
    }
    return mesh;
}

SceneObject objectOf(std::shared_ptr<const TriangleMesh> mesh, const Pose& pose, const Look& look) {
    SceneObject object;
    object.shape = std::move(mesh);
    object.objectInWorld = pose;
    object.looks = {look};
    return object;
}

}  // namespace

Scene benchMouth() {
    std::array<std::shared_ptr<const TriangleMesh>, 3> kinds;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        kinds[i] = std::make_shared<const TriangleMesh>(makeBuiltinTooth(static_cast<BuiltinToothKind>(i)).outer);
    }
    Scene scene;
    const auto gums = std::make_shared<const TriangleMesh>(gum());
    for (const bool isUpper : {false, true}) {
        const Quat turnedOver(Eigen::AngleAxisd(isUpper ? std::numbers::pi : 0, Vec3::UnitY()));
        const Pose arch{Vec3(0, 0, isUpper ? kArchDistance : 0), turnedOver};
        scene.objects.push_back(objectOf(gums, arch, looks::gingiva()));
        scene.objects.back().closed = false;
        for (int tooth = 0; tooth < kTeethOfArch; ++tooth) {
            const int fromMiddle = std::abs(2 * tooth - kTeethOfArch + 1) / 2;  // 0 at the central incisors
            const std::size_t kind = fromMiddle < 2 ? 1 : fromMiddle == 2 ? 2 : 0;
            const Vec3 place = onArch(angleOf(tooth));
            const Pose pose{place, Quat::FromTwoVectors(Vec3::UnitY(), place.normalized())};
            scene.objects.push_back(objectOf(kinds[kind], arch * pose, looks::enamel()));
        }
    }
    const DentalMirror mirror = makeMirror();
    const Vec3 glass(-8, 18, 14);
    const Pose held{glass, Quat::FromTwoVectors(Vec3::UnitZ(), Vec3(-0.3, 0.6, -0.3).normalized())};
    scene.objects.push_back(objectOf(std::make_shared<const TriangleMesh>(mirror.surface), held, looks::steel()));
    scene.mirror = SceneMirror{.mirrorInWorld = held,
                               .centre = mirror.disc.centre,
                               .normal = mirror.disc.normal,
                               .radius = mirror.disc.radius};
    return scene;
}

}  // namespace tactooth
