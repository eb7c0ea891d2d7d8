// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "geometry/mesh/triangle_mesh.h"
#include "instruments/mirror.h"
#include "session/model/task.h"
#include "session/simulation/mirror_glass.h"
#include "sound/voices/drill_sound_state.h"

namespace tactooth {

struct SpindlePreset;

/// The meshes of the handpieces, in the tool frame, mm. Null: not made, or not to be seen.
struct HandpieceMeshes {
    std::shared_ptr<const TriangleMesh> turbine;
    std::shared_ptr<const TriangleMesh> contraAngle;
    std::shared_ptr<const TriangleMesh> lowSpeed;

    /// All of them. The first call of a program makes them, which takes about a second.
    [[nodiscard]] static HandpieceMeshes make();
    /// The one that a drive needs.
    [[nodiscard]] const std::shared_ptr<const TriangleMesh>& of(const SpindlePreset& spindle) const;
};

/// Meshes of the instruments around the bur, each in its own frame, mm. They are the same for every tooth.
struct InstrumentMeshes {
    HandpieceMeshes handpieces;
    std::shared_ptr<const TriangleMesh> mirror;
    MirrorDisc disc;  ///< of the mirror
    std::shared_ptr<const TriangleMesh> suction;
};

/// The mouth mirror as the user sets it.
struct MirrorState {
    double diameter = 22;  ///< of its head, mm
    bool fogged = false;
    bool wet = false;
    bool dims = false;  ///< breath and dirt come by themselves
};

/// The instruments around the bur: handpieces, mirror, suction tube and water spray. Their meshes are made in the
/// background.
class InstrumentSet {
public:
    explicit InstrumentSet(const TaskExecutor& executor = runInThread);

    /// Takes over the meshes once they are made. Call it in every step.
    void poll();
    [[nodiscard]] bool isBusy() const { return task_.isBusy(); }
    /// None until they are made.
    [[nodiscard]] const std::optional<InstrumentMeshes>& meshes() const { return meshes_; }

    void setMirror(const MirrorState& mirror);
    [[nodiscard]] const MirrorState& mirror() const { return mirror_; }
    /// What has come onto the glass by itself; setMirror with other `fogged` or `dims` wipes it off.
    [[nodiscard]] const MirrorGlass& glass() const { return glass_; }
    /// The glass dims, if it does so by itself. Call it in every step.
    void advanceGlass(const MirrorGlass::Input& now, double dt) {
        if (mirror_.dims) glass_.advance(now, dt);
    }
    /// Whether water flows with the pedal.
    void setWater(bool flows) { water_ = flows; }
    [[nodiscard]] bool water() const { return water_; }
    /// Whether an assistant holds the suction tube in the mouth.
    void setSuction(bool draws) { suction_ = draws; }
    [[nodiscard]] bool suction() const { return suction_; }
    /// Removes the sound of water and suction where they are off. The servo thread calls this.
    void muteIdle(DrillSoundState& heard) const;

private:
    void updateMirror();

    Task<InstrumentMeshes> task_;
    std::optional<InstrumentMeshes> meshes_;
    MirrorState mirror_;
    MirrorGlass glass_;
    std::atomic<bool> water_{true}, suction_{false};  // the servo thread reads them for the sound
};

}  // namespace tactooth
