// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "haptics/haptic_simulation.h"
#include "tooth/file/exported_mesh.h"
#include "tooth/surface/incremental_surface.h"
#include "tooth/volume/bur_feed.h"

namespace tactooth {

/// The bur as far as cutting knows it.
struct CuttingTool {
    RevolutionEnvelope envelope;
    double sharpness = 1;
};

/// Bodies that are felt as they are and never cut: the neighbours of a tooth, the gums. In the tooth's frame.
using Surroundings = std::vector<std::shared_ptr<const SurfacePart>>;

/// `surface` with the bodies around it as further patches; the same one if there are none.
[[nodiscard]] std::shared_ptr<const Surface> surrounded(std::shared_ptr<const Surface> surface,
                                                        const Surroundings& bodies);

/// What a tooth has lost since it was whole.
struct ToothLoss {
    MaterialVolumes removed{};   ///< all of it, mm^3
    MaterialVolumes detached{};  ///< of that, what burs had cut off all around, mm^3
    std::size_t pieces = 0;      ///< of what has fallen, those that an eye can see (kVisiblePiece)
    double beside = 0;           ///< of all, what bodies around the tooth have lost, mm^3

    /// What burs have ground to chips.
    [[nodiscard]] MaterialVolumes ground() const {
        MaterialVolumes volumes = removed;
        for (std::size_t i = 0; i < kMaxMaterials; ++i) volumes[i] -= detached[i];
        return volumes;
    }
};

/// mm^3; a piece that came loose and is smaller, a cube of 0.2 mm, is dust.
inline constexpr double kVisiblePiece = 0.008;

/// A tooth on the bench: its volume, its surface and what has been removed from it. One thread cuts; the surface
/// snapshots go anywhere.
class CutModel {
public:
    /// `voxel`: spacing of the cut volume, mm.
    CutModel(std::shared_ptr<const LayeredTooth> tooth, double voxel);

    [[nodiscard]] const std::shared_ptr<const Surface>& surface() const { return live_.snapshot(); }
    /// The surface as files have it: see exportedMesh.
    [[nodiscard]] TaggedMesh exported() const { return exportedMesh(*surface(), volume_.lattice().spacing()); }
    /// What a hand feels: the surface, and the bodies around it as further patches.
    [[nodiscard]] std::shared_ptr<const Surface> felt() const { return surrounded(surface(), surroundings_); }
    [[nodiscard]] const MaterialVolumes& removed() const { return loss_.removed; }
    [[nodiscard]] const ToothLoss& loss() const { return loss_; }
    [[nodiscard]] const LayeredTooth& tooth() const { return *tooth_; }
    [[nodiscard]] const CutVolume& volume() const { return volume_; }

    /// Puts the tooth among other bodies. To be called before anything is felt.
    void surroundBy(Surroundings bodies) { surroundings_ = std::move(bodies); }
    [[nodiscard]] const Surroundings& surroundings() const { return surroundings_; }

    /// Begins to take bricks from a stock that another thread may fill (BrickPool::makeAround). To be called before
    /// anything is cut; a second call returns the same one.
    [[nodiscard]] const std::shared_ptr<BrickPool>& pool();

    /// Removes all that the bur sweeps between two poses, whatever it takes. Returns what was removed.
    MaterialVolumes sweep(const CuttingTool& tool, const Pose& from, const Pose& to);

    /// Lets the bur go on from the proxy toward the hand of `tick` as far as the work booked since the last call pays
    /// for. True if the surface has changed.
    bool feed(const CuttingTool& tool, const Tick& tick, const MaterialTable& materials);

    /// Lets fall what the cuts since the last look have set free, once the bur has been lifted: a piece that nothing
    /// holds is gone, and so are flakes thinner than a voxel. `tick` is the newest one. True if the surface has
    /// changed.
    bool removeLoosePieces(const Tick& tick);
    /// The same, at once.
    bool removeLoosePieces();

    /// Where the last `feed` lets the bur go to; nothing before the first, and after the bur was lifted.
    [[nodiscard]] const std::optional<Pose>& reached() const { return reached_; }

    /// Brings `surface()` up to date with the cuts made by `sweep`.
    void refreshSurface();

    /// Of all that has been cut (CutVolume::hash): equal bits for equal cuts.
    [[nodiscard]] std::uint64_t hash() const { return volume_.hash(); }

    /// Memory of the cut volume.
    [[nodiscard]] std::size_t bytes() const { return volume_.bytes(); }

    /// Takes over what was cut from the same tooth before (CutVolume::adopt).
    void adopt(const std::map<BrickKey, CutField>& fields, const MaterialVolumes& removed);

    /// Sets a mark that `undo` goes back to.
    void mark();
    /// How many times `undo` can go back.
    [[nodiscard]] std::size_t marks() const { return volume_.marks(); }
    /// The tooth as it was at the last mark, bit for bit; false if there is none.
    bool undo();

    /// The whole tooth again; no mark is left.
    void reset();

private:
    [[nodiscard]] Pose startOf(const Tick& tick) const;
    void addRemoved(const CarveResult& carve);
    void updateContact(const Tick& tick);
    void addFallen(const CarveResult& carve);

    std::shared_ptr<const LayeredTooth> tooth_;
    CutVolume volume_;
    std::shared_ptr<BrickPool> pool_;
    IncrementalSurface live_;
    Surroundings surroundings_;
    ToothLoss loss_;
    std::vector<ChangedBrick> changed_;  // since the last refresh
    std::vector<ToothLoss> lossAt_;      // the marks
    std::optional<Pose> reached_;
    double lastFeedLength_ = 0;   // of the last feed, mm
    bool mayBeDetached_ = false;  // something was cut since the last look
    double touchedAt_ = 0;        // Tick::time of the last contact seen, s
    double workSpent_ = 0;        // of Tick::cutWork, N*m
    double workSeen_ = 0;         // Tick::cutWork at the last feed, N*m
};

}  // namespace tactooth
