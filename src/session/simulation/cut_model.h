// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "haptics/haptic_simulation.h"
#include "session/simulation/cut_history.h"
#include "session/simulation/step_losses.h"
#include "session/simulation/tooth_loss.h"
#include "tooth/file/exported_mesh.h"
#include "tooth/surface/incremental_surface.h"
#include "tooth/volume/bur_feed.h"

namespace tactooth {

/// The bur as cutting needs it.
struct CuttingTool {
    RevolutionEnvelope envelope;
    double sharpness = 1;
};

/// Bodies that are touched but never cut: neighbours of the tooth, gums. In the tooth frame.
using Surroundings = std::vector<std::shared_ptr<const SurfacePart>>;

/// `surface` with the bodies around it as further patches; the same one if there are none.
[[nodiscard]] std::shared_ptr<const Surface> surrounded(std::shared_ptr<const Surface> surface,
                                                        const Surroundings& bodies);

/// A tooth that is cut: its volume, its surface and the removed volumes. One thread cuts; any thread may hold the
/// surface snapshots.
class CutModel {
public:
    /// `voxel`: spacing of the cut volume, mm.
    CutModel(std::shared_ptr<const LayeredTooth> tooth, double voxel);

    [[nodiscard]] const std::shared_ptr<const Surface>& surface() const { return incremental_.snapshot(); }
    /// The surface for files: see exportedMesh.
    [[nodiscard]] TaggedMesh exported() const { return exportedMesh(*surface(), volume_.lattice().spacing()); }
    /// The surface that is touched: with the bodies around it as further patches.
    [[nodiscard]] std::shared_ptr<const Surface> contactSurface() const { return surrounded(surface(), surroundings_); }
    [[nodiscard]] const MaterialVolumes& removed() const { return loss_.removed; }
    [[nodiscard]] const ToothLoss& loss() const { return loss_; }
    [[nodiscard]] const LayeredTooth& tooth() const { return *tooth_; }
    [[nodiscard]] const CutVolume& volume() const { return volume_; }

    /// Puts the tooth among other bodies. Call it before anything is touched.
    void surroundBy(Surroundings bodies) { surroundings_ = std::move(bodies); }
    [[nodiscard]] const Surroundings& surroundings() const { return surroundings_; }

    /// From now on the volume takes bricks from a pool that another thread may fill (BrickPool::makeAround). Call it
    /// before anything is cut. A second call returns the same pool.
    [[nodiscard]] const std::shared_ptr<BrickPool>& pool();

    /// Removes all that the bur sweeps between two poses, without the removal law. Returns the removed volumes.
    MaterialVolumes sweep(const CuttingTool& tool, const Pose& from, const Pose& to);

    /// Cuts from the proxy toward the device pose of `tick`, as far as the work since the last call suffices. Returns
    /// true if the surface has changed.
    bool feed(const CuttingTool& tool, const Tick& tick, const MaterialTable& materials);

    /// Takes soft tissue away with a blade in the hand, from the proxy toward the device pose of `tick`, as far as the
    /// work since the last call suffices. Tissue without `removal` stays, every voxel of it. Returns true if the
    /// surface has changed.
    bool scrape(const CuttingTool& blade, const Tick& tick, const MaterialTable& materials);

    /// Removes detached pieces and flakes thinner than a voxel, once the bur has been lifted. `tick` is the newest one.
    /// Returns true if the surface has changed.
    bool removeDetachedPieces(const Tick& tick);
    /// The same, at once.
    bool removeDetachedPieces();

    /// The end of the last `feed`; nothing before the first one and after the bur was lifted.
    [[nodiscard]] const std::optional<Pose>& reached() const { return reached_; }

    /// Brings `surface()` up to date with the cuts made by `sweep`.
    void refreshSurface();

    /// CutVolume::hash: equal cuts give equal bits.
    [[nodiscard]] std::uint64_t hash() const { return volume_.hash(); }

    /// Memory of the cut volume.
    [[nodiscard]] std::size_t bytes() const { return volume_.bytes(); }

    /// Takes over a saved cut of the same tooth (CutVolume::adopt).
    void adopt(const std::map<BrickKey, CutField>& fields, const MaterialVolumes& removed);

    /// Leaves only what the file of the tooth holds, so that an exact recording can begin now: from here on this tooth
    /// and one that is opened from its file (toothFileBytes) answer equal calls with equal bits. The tooth stays as it
    /// is, and what could be undone or redone still can; only a tooth from the file cannot undo that. The number of
    /// fallen pieces begins anew.
    void reopen();

    /// Goes to another moment of the same tooth: replaces the fields of some bricks (CutVolume::replace). `loss`: at
    /// that moment. Nothing can be undone or redone then. It is for looking: a cut does not go on from here as it did
    /// then.
    void replace(const std::map<BrickKey, CutField>& fields, const ToothLoss& loss);
    /// CutVolume::noteTouched and CutVolume::takeTouched.
    void noteTouched() { volume_.noteTouched(); }
    [[nodiscard]] std::vector<BrickKey> takeTouched() { return volume_.takeTouched(); }

    /// The next change begins a step of its own. `time`: Tick::time, s.
    void mark(double time);
    /// Restores the tooth before the last step, bit for bit. Returns false if there is none.
    bool undo();
    /// Restores the tooth after the step that was undone last, bit for bit. Returns false if there is none: something
    /// was cut since.
    bool redo();
    /// Restores the whole tooth, as a step of its own. `time` as in `mark`. Returns false if nothing was cut.
    bool reset(double time);
    [[nodiscard]] CutHistory history();

private:
    /// A step that requires more work than there was.
    struct DeferredStep {
        Pose start;
        Vec3 path;                // mm
        double requiredWork = 0;  // N*m
        std::uint64_t edits = 0;  // CutVolume::edits at that time
    };

    [[nodiscard]] Pose startOf(const Tick& tick) const;
    [[nodiscard]] std::optional<double> newWork(const Tick& tick);
    void addRemoved(const CarveResult& carve);
    void watchPulp(const CuttingTool& tool, const Pose& at);
    void updateContact(const Tick& tick);
    void addFallen(const CarveResult& carve);
    [[nodiscard]] bool isDeferred(const Pose& start, const Pose& goal, double work) const;
    [[nodiscard]] double enoughLength(double work) const;
    void keepWorkOf(const FeedResult& result, const Pose& start, const Pose& goal);
    void markStep(const CutStep& step);
    void followSteps();
    void restore(const std::vector<ChangedBrick>& changed, const ToothLoss& loss);

    std::shared_ptr<const LayeredTooth> tooth_;
    CutVolume volume_;
    std::shared_ptr<BrickPool> pool_;
    IncrementalSurface incremental_;
    Surroundings surroundings_;
    ToothLoss loss_;
    std::vector<ChangedBrick> changed_;  // since the last refresh
    StepLosses steps_;
    std::optional<Pose> reached_;
    std::optional<DeferredStep> deferred_;
    std::optional<double> lastWork_;  // of the last step that was cut, N*m for each mm
    bool mayBeDetached_ = false;      // something was cut since the last search for pieces
    double touchedAt_ = 0;            // Tick::time of the last contact seen, s
    double workSpent_ = 0;            // of Tick::cutWork, N*m
    double workSeen_ = 0;             // Tick::cutWork at the last feed, N*m
};

}  // namespace tactooth
