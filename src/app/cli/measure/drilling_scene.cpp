// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measure/drilling_scene.h"

#include <algorithm>
#include <cmath>

#include "app/common/inspection.h"
#include "app/common/spray_particles.h"
#include "app/common/tooth_zones.h"
#include "geometry/util/pose.h"
#include "instruments/bur_catalogue.h"
#include "instruments/bur_shape.h"
#include "instruments/mirror.h"
#include "instruments/turbine.h"
#include "session/simulation/session_voxel.h"
#include "session/simulation/tooth_source.h"

namespace tactooth {
namespace {

constexpr double kStep = 0.1;              // mm per frame: 3 mm/s at 30 frames a second
constexpr double kPictureTime = 1.0 / 30;  // s
constexpr int kBefore = 2;                 // frames that are not measured (FrameTimer)
constexpr double kSpeed = 300000;          // rev/min
constexpr double kMaxDepth = 2;            // mm below the surface in the middle of the crown
constexpr double kSlot = 3;                // mm

/// The bur's tip after `length` mm of its path from `start`: straight down, then to and fro along x.
Vec3 tipAfter(const Vec3& start, double length) {
    const double along = std::max(0.0, length - kMaxDepth);
    const double phase = std::fmod(along + kSlot / 2, 2 * kSlot);
    const double x = (phase < kSlot ? phase : 2 * kSlot - phase) - kSlot / 2;
    return start + Vec3(x, 0, -std::min(length, kMaxDepth));
}

/// The highest point of the surface above the centre of its box.
Vec3 topInTheMiddle(const TriangleMesh& mesh) {
    const Box3 box = boundingBox(mesh);
    constexpr double kReach = 1;  // mm
    Vec3 top = box.center();
    for (const Vec3f& vertex : mesh.vertices) {
        const Vec3 place = vertex.cast<double>();
        if ((place - box.center()).head<2>().norm() < kReach) top.z() = std::max(top.z(), place.z());
    }
    return top;
}

}  // namespace

Expected<DrillingScene> DrillingScene::make(std::shared_ptr<const LayeredTooth> tooth,
                                            const std::optional<TriangleMesh>& target, ImageSize size, int pictures) {
    const BurSpec spec = *findBur("58");
    const Expected<CuttingTool> tool = makeCuttingTool(makeBur(spec).surface);
    if (!tool) return Unexpected{tool.error()};
    DrillingScene work;
    work.tooth_ = std::move(tooth);
    work.target_ = target;
    const Box3 box = work.tooth_->outer()->tree().box();
    OrbitCamera eye;
    constexpr double kAbove = 13;  // mm, as in the window
    eye.fit(crownBox(box, kAbove), size.aspect());
    eye.setView({1.25, 0.62});
    work.contents_.camera = eye.camera();
    work.contents_.tool = ShownTool{.bur = std::make_shared<const TriangleMesh>(makeBur(spec, 6000).surface),
                                    .turbine = std::make_shared<const TriangleMesh>(makeTurbine()),
                                    .toolInTooth = {Vec3::Zero(), uprightGrip(1, 0.5)},
                                    .speedRpm = kSpeed,
                                    .edge = spec.edge()};
    work.contents_.tool->head = burHeadOf(*work.contents_.tool->bur);
    work.contents_.tool->cap = std::make_shared<const TriangleMesh>(headCap(work.contents_.tool->head));
    work.contents_.glass = true;  // as in the window
    DentalMirror mirror = makeMirror();
    const Vec3 toEye = (eye.camera().cameraInWorld.position - box.center()).normalized();
    const Pose held = parkedMirror(box, toEye, 1);
    work.contents_.mirror =
        ShownMirror{std::make_shared<const TriangleMesh>(std::move(mirror.surface)), mirror.disc, held};
    CutModel piece(work.tooth_, kSessionVoxel);
    work.play(piece, *tool, pictures + kBefore);
    return work;
}

void DrillingScene::play(CutModel& piece, const CuttingTool& tool, int pictures) {
    const Vec3 start = topInTheMiddle(tooth_->outer()->mesh());
    SprayParticleSystem spray(tool.envelope.maxRadius());
    Pose before{start, contents_.tool->toolInTooth.rotation};
    for (int i = 0; i < pictures; ++i) {
        const Pose now{tipAfter(start, kStep * i), before.rotation};
        piece.sweep(tool, before, now);
        piece.refreshSurface();
        before = now;
        spray.advance({now, Vec3::UnitZ(), kSpeed, 1, false, piece.removed()}, kPictureTime);
        moments_.push_back({now, piece.surface(), particlesOf(spray.particles(), contents_.materials)});
    }
}

const DrillingScene::Moment& DrillingScene::momentOf(int picture) const {
    return moments_[static_cast<std::size_t>(picture + kBefore) % moments_.size()];
}

Scene DrillingScene::sceneAt(int picture, bool cuts) const {
    SceneContents contents = contents_;
    const Moment& moment = momentOf(picture);
    contents.zones = toothZones(*tooth_, contents.materials);
    contents.tooth = cuts ? moment.surface : moments_.front().surface;
    contents.tool->toolInTooth = moment.toolInTooth;
    contents.flying = moment.flying;
    return makeScene(contents);
}

FrameTimer::SceneSequence DrillingScene::moving() const {
    return [this](int picture) { return sceneAt(picture, false); };
}

FrameTimer::SceneSequence DrillingScene::cutting() const {
    return [this](int picture) { return sceneAt(picture, true); };
}

FrameTimer::SceneSequence DrillingScene::withSecondView() const {
    return [this](int picture) {
        Scene scene = sceneAt(picture, true);
        scene.second = SecondView{crownCamera(StandardView::Occlusal, 1, tooth_->outer()->tree().box())};
        return scene;
    };
}

FrameTimer::SceneSequence DrillingScene::withGhost() const {
    if (!target_) return cutting();
    return [this, ghost = std::make_shared<CavityGhost>(*target_, *tooth_->ownOuter())](int picture) {
        Scene scene = sceneAt(picture, true);
        Inspection inspection;
        inspection.ghost = ghost;
        applyInspection(scene, *tooth_, inspection);
        return scene;
    };
}

}  // namespace tactooth
