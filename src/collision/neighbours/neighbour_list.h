// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "collision/narrow/triangle3.h"
#include "collision/neighbours/near_clusters.h"
#include "collision/neighbours/work_cost.h"

namespace tactooth {

/// The turn from one orientation to another as a chord: twice the sine of half the angle. A point at distance r from
/// the origin moves by r times as much at most.
[[nodiscard]] inline double chordBetween(const Quat& a, const Quat& b) { return 2 * (a * b.conjugate()).vec().norm(); }

/// A triangle of the tooth and one of the tool.
struct NearPair {
    std::uint32_t part;   ///< see partOf
    std::uint32_t tooth;  ///< triangle of that part
    std::uint32_t tool;   ///< triangle of the tool

    friend bool operator==(const NearPair&, const NearPair&) = default;
};

/// How a tool stands at the start and the end of a step, in its own frame at the listing.
struct ToolMotion {
    /// The way of point p of the tool (in the tool's frame) is turn * p + shift.
    struct Displacement {
        Eigen::Matrix3f turn;
        Vec3f shift;
        float perLength;  ///< two points of the tool 1 mm apart differ in their ways by this much at most: a chord
        float spare;      ///< what a slab must leave, mm
    };
    Displacement start, end;
    /// The same side by side: lanes 0-3 of the start, 4-7 of the end, with the point itself added to its way.
    Vec3x8 column[3];
    Vec3x8 shift;
    /// Directions worth a try for every pair: those of the planes that hold the tool.
    std::array<Vec3f, 6> known;
    int knownCount = 0;
};

/// The pairs of triangles near a tool, kept while the tool moves within a skin, on three levels, each with slabs that
/// were free when it was listed. A branch of the tooth's tree has one against the whole tool; a cluster (a leaf of the
/// tooth against a triangle of the tool) and a pair of triangles have their own. Eight at a time tell which of them a
/// step could bring together: only those are opened.
class NeighbourList {
public:
    /// Clusters: a bur that fills its own slot in a 25 um mesh lists some 4,000.
    static constexpr std::size_t kUsualCapacity = 1 << 14;

    explicit NeighbourList(const ToolShape& tool, std::size_t capacity = kUsualCapacity);

    /// Begins a list of what is within `wanted`, or within less where much was met lately: what is near is looked into
    /// where a step brings it in doubt (see within). `surface` must stay as long as the list does. Allocates nothing.
    void make(const Surface& surface, const Pose& toolInTooth, const ContactMargin& wanted);
    /// Lists what is within `contactMargin`, however much it is: allocates where there is no room.
    void buildAll(const Surface& surface, const Pose& toolInTooth, const ContactMargin& contactMargin);
    /// Lists what is within `wanted`, of which no more than a contactMargin as long as `most` (mm), or within less
    /// where that is more than there is room for, down to a skin as long as `least`: to make room takes longer than a
    /// long list is worth.
    void buildWithinCapacity(const Surface& surface, const Pose& toolInTooth, const ContactMargin& wanted, double least,
                             double most);
    /// Lists what the tool meets where it stands, and stops beyond `limit` clusters; allocates where there is no room
    /// for so many. True if nothing was left out.
    bool buildUpTo(const Surface& surface, const Pose& toolInTooth, std::size_t limit);
    void clear() { made_ = false; }
    /// There was more to list than there is room for, or than a list is worth: it does not tell what is near. One with
    /// a shorter skin may.
    [[nodiscard]] bool isFull() const { return made_ && !near_.complete; }
    /// Clears a full list, and makes the next one shorter. False if it was as short as a list can be.
    bool shorten();
    /// What looking into the tooth has cost since this was last asked.
    [[nodiscard]] Work takeWork() { return std::exchange(work_, 0); }
    /// Clears it, and forgets how long a list may well be.
    void forget();

    [[nodiscard]] bool made() const { return made_; }
    /// Everything within this was listed.
    [[nodiscard]] const ContactMargin& contactMargin() const { return contactMargin_; }
    /// No list covers less around its segment, however much is near (but where there is no room at all: then 0), mm.
    [[nodiscard]] double leastAround() const;
    /// No list covers less of a turn.
    [[nodiscard]] static double leastRotation();
    [[nodiscard]] std::size_t clusters() const { return near_.count; }
    /// A new one would reach hardly further.
    [[nodiscard]] bool isLong() const;
    /// How far a pose of the tool's origin strays from where the list was made for, mm.
    [[nodiscard]] double deviation(const Vec3& position) const {
        return contactMargin_.deviation(position - at_.position);
    }
    /// How far an orientation is from that at the listing (a chord, as in Skin).
    [[nodiscard]] double chordTo(const Quat& rotation) const { return chordBetween(rotation, at_.rotation); }
    [[nodiscard]] ToolMotion motion(const Pose& start, const Pose& end, double margin,
                                    std::span<const Vec3> known) const;

    /// Where the eight clusters begin of which a step may bring some in doubt, ascending; all others are clear of it,
    /// and so is what of the tooth is no cluster yet (unless the list is full). Looks them all over once, for the steps
    /// to come as well, as long as these stay near. Allocates nothing.
    [[nodiscard]] std::span<const std::uint32_t> within(const ToolMotion& motion);
    /// Of the eight clusters from number `first` on (a multiple of eight), one bit for each whose slab does not hold
    /// at both ends of the step.
    [[nodiscard]] std::uint32_t uncertainClusters(std::size_t first, const ToolMotion& motion) const;
    /// The same of the pairs of one cluster. They are numbered from placeOf(cluster, 0) on.
    [[nodiscard]] std::uint32_t uncertainPairs(std::size_t cluster, const ToolMotion& motion);
    [[nodiscard]] static std::size_t placeOf(std::size_t cluster, int lane) {
        return cluster * 8 + static_cast<std::size_t>(lane);
    }

    /// Takes a direction of the tooth's frame for the slabs of those of `uncertain` in a cluster that it parts the
    /// whole way of the step that uncertainPairs was asked about. Returns those left in doubt.
    [[nodiscard]] std::uint32_t separateBy(const Vec3& direction, std::size_t cluster, std::uint32_t uncertain,
                                           const ToolMotion& motion);

    /// The leaf of the tooth in a cluster; clusters of the same leaf have the same number.
    [[nodiscard]] std::uint32_t leafOf(std::size_t cluster) const { return packetOf(cluster).leaf[cluster % 8]; }
    [[nodiscard]] const NearLeaf& leaf(std::uint32_t number) const { return near_.leaves[number]; }
    [[nodiscard]] std::uint32_t toolOf(std::size_t cluster) const { return packetOf(cluster).tool[cluster % 8]; }

    [[nodiscard]] NearPair operator[](std::size_t place) const;
    /// The direction of the pair's slab in the tooth's frame, of length 1 or almost; zero: none is known.
    [[nodiscard]] Vec3 direction(std::size_t place) const;
    /// Looks ahead for what parts the tool on its way from `start` to `end`, straight on, from each triangle listed of
    /// `surface`: a move on about this displacement then finds it here. `margin`: what it shall leave at the end, mm.
    void separateAhead(const Surface& surface, const Pose& start, const Pose& end, double margin);
    /// Takes the plane with this unit normal and offset (of the tooth's frame) for the pair's slab.
    void certify(std::size_t place, const Vec3& normal, double offset);

private:
    /// Slabs of a cluster's eight pairs, in the tool's frame at the listing.
    struct alignas(32) PairPacket {
        float normal[3][8];
        float high[8];              // no point of the tooth's triangle is further along the normal, mm
        std::uint32_t unseparable;  // one bit for each pair that none of its triangles' normals has parted
    };
    static constexpr std::uint32_t kClosed = ~0U;
    struct Swept;
    struct KnownPlanes;

    /// A few steps from a pose of the tool on, and the clusters that they may bring in doubt.
    struct LocalCandidates {
        ToolMotion::Displacement middle;
        Vec3f along = Vec3f::Zero();      // where they lead, mm
        float deviation = -1, turn = -1;  // and how far from this way, mm, and as a chord; negative: not known
        std::vector<std::uint32_t> packets;
        std::size_t count = 0;
        std::size_t looked = 0;  // clusters: those listed since are not among them

        [[nodiscard]] bool cover(const ToolMotion::Displacement& displacement) const;
    };

    void reserve(std::size_t capacity);
    void searchAround(const ToolMotion& motion);
    void testNewClusters();
    void openAll();
    void openUncertain(const ToolMotion& motion);
    [[nodiscard]] std::uint32_t uncertainNodes(std::size_t node, const ToolMotion& motion) const;
    [[nodiscard]] bool separateLeaf(std::size_t node, int child, const ToolMotion& motion, KnownPlanes& known);
    void openNode(const NearNode& node, int child);
    [[nodiscard]] bool isShortest() const;
    void shortenTo(double length);
    void list(const Surface& surface, const Pose& toolInTooth, std::size_t limit);
    PairPacket* open(std::size_t cluster);
    void separatePairAhead(const Surface& surface, std::size_t place, const Pose& start, const Pose& end);
    void fill(PairPacket& pairs, const NearLeaf& leaf, std::uint32_t tool) const;
    [[nodiscard]] Swept sweep(std::uint32_t tool, const ToolMotion& motion) const;
    [[nodiscard]] bool separateCluster(std::size_t cluster, const ToolMotion& motion, const Swept& swept);
    [[nodiscard]] static std::uint32_t part(const Vec3x8& directions, const NearLeaf& leaf, const Swept& tool,
                                            std::uint32_t uncertain, PairPacket& pairs);
    [[nodiscard]] const ClusterPacket& packetOf(std::size_t cluster) const { return near_.packets[cluster / 8]; }

    const ToolShape* tool_;
    BvhTraversal traversal_;
    NearClusters near_;
    LocalCandidates around_;
    std::vector<PairPacket> pairs_;
    std::vector<std::uint32_t> opened_;  // place in pairs_ of each cluster; kClosed: not opened
    std::size_t openedCount_ = 0;
    std::array<Vec3f, 4>
        recentDirections_;  // directions of planes taken last: what parts a pair often parts others near it
    std::size_t recentCount_ = 0;
    bool made_ = false;
    Pose at_;
    Mat3 rotation_;  // of at_
    ContactMargin contactMargin_;
    double cap_ = 0;         // of the next skin's length, mm: where the last list met much, it stays short
    std::size_t limit_ = 0;  // of clusters
    Work work_ = 0;
};

}  // namespace tactooth
