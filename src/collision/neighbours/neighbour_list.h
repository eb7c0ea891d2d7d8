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
#include "geometry/util/assert.h"

namespace tactooth {

/// The rotation from one orientation to another as a chord: twice the sine of half the angle. A point at distance r
/// from the origin moves by at most r times the chord.
[[nodiscard]] inline double chordBetween(const Quat& a, const Quat& b) { return 2 * (a * b.conjugate()).vec().norm(); }

/// A triangle of the tooth and a triangle of the tool.
struct NearPair {
    std::uint32_t part;   ///< see partOf
    std::uint32_t tooth;  ///< triangle of that part
    std::uint32_t tool;   ///< triangle of the tool

    friend bool operator==(const NearPair&, const NearPair&) = default;
};

/// The motion of a tool in a step, relative to the pose at which the neighbour list was built and in the tool's frame
/// at that pose.
struct ToolMotion {
    /// The displacement of each point of the tool from that pose: point p (tool's frame, mm) moves by turn * p + shift.
    struct Displacement {
        Eigen::Matrix3f turn;
        Vec3f shift;
        float perLength;  ///< chord: the displacements of two points 1 mm apart differ by at most this, mm
        float spare;      ///< least width that a slab must keep to count as safe, mm
    };
    Displacement start, end;  ///< at the start and at the end of the step
    /// Both displacements, with the point itself added: lanes 0-3 of the start, lanes 4-7 of the end.
    Vec3x8 column[3];
    Vec3x8 shift;
    /// Directions to try for every pair: the normals of the active constraints.
    std::array<Vec3f, 6> known;
    int knownCount = 0;
};

/// The pairs of triangles near a tool (a Verlet list), valid while the tool moves within a contact margin.
///
/// The list has three levels: nodes of the tooth's tree against the whole tool, clusters (a leaf of the tooth against a
/// triangle of the tool), and pairs of triangles. Each entry has a slab that was empty when the list was built. A step
/// that leaves the slab wide enough is safe for the entry; else the entry is uncertain. Slabs are tested eight at a
/// time, and only uncertain entries are opened: a node into clusters, a cluster into pairs.
class NeighbourList {
public:
    /// In clusters. A bur in the slot that it has cut, in a mesh of 25 um, has some 4,000 near it.
    static constexpr std::size_t kUsualCapacity = 1 << 14;

    explicit NeighbourList(const ToolShape& tool, std::size_t capacity = kUsualCapacity);

    /// Begins a list of all that is within `wanted`, or within less if the last lists were long. Nodes are opened when
    /// a step makes them uncertain (see within). `surface` must outlive the list. Allocates nothing.
    void make(const Surface& surface, const Pose& toolInTooth, const ContactMargin& wanted);
    /// Lists all that is within `contactMargin`. Allocates if the list exceeds its capacity.
    void buildAll(const Surface& surface, const Pose& toolInTooth, const ContactMargin& contactMargin);
    /// Lists all that is within `wanted`, shortened to a length of `most` (mm). If the list exceeds its capacity,
    /// shortens the margin further, down to a length of `least` (mm), since an allocation takes longer than a long list
    /// saves. Allocates if the shortest one exceeds the capacity too.
    void buildWithinCapacity(const Surface& surface, const Pose& toolInTooth, const ContactMargin& wanted, double least,
                             double most);
    /// Lists the clusters that the tool touches at its pose, at most `limit` of them. Allocates if the capacity is less
    /// than `limit`. True if nothing was left out.
    bool buildUpTo(const Surface& surface, const Pose& toolInTooth, std::size_t limit);
    /// Empties the list.
    void clear() { made_ = false; }
    /// Whether the list has reached its capacity, or the length beyond which it costs more than it saves. Then it is
    /// not complete; one with a shorter contact margin may be.
    [[nodiscard]] bool isFull() const { return made_ && !near_.complete; }
    /// Empties a full list, and halves the margin of the next one. False if the margin is the shortest possible
    /// already.
    bool shorten();
    /// The work of opening nodes since the last call.
    [[nodiscard]] Work takeWork() { return std::exchange(work_, 0); }
    /// Empties the list, and allows the next one any length again.
    void forget();

    /// Whether a list was built and not cleared since.
    [[nodiscard]] bool made() const { return made_; }
    /// The motion for which the list is complete.
    [[nodiscard]] const ContactMargin& contactMargin() const { return contactMargin_; }
    /// The least `around` of a contact margin that make() uses, mm.
    [[nodiscard]] double leastAround() const;
    /// The least `turn` of a contact margin that make() uses, a chord.
    [[nodiscard]] static double leastRotation();
    /// The number of clusters found so far.
    [[nodiscard]] std::size_t clusters() const { return near_.count; }
    /// Whether the list is so long that a new one would hardly cover more.
    [[nodiscard]] bool isLong() const;
    /// How far a position of the tool's origin is from the segment of the contact margin, mm.
    [[nodiscard]] double deviation(const Vec3& position) const {
        return contactMargin_.deviation(position - at_.position);
    }
    /// The rotation to an orientation from that at which the list was built, as a chord.
    [[nodiscard]] double chordTo(const Quat& rotation) const { return chordBetween(rotation, at_.rotation); }
    /// The motion of a step between two poses of the tool in the tooth. `margin`: the least width that slabs must keep
    /// at its end, mm. `known`: at most six unit directions of the tooth's frame, tried for every pair.
    [[nodiscard]] ToolMotion motion(const Pose& start, const Pose& end, double margin,
                                    std::span<const Vec3> known) const;

    /// The packets of eight clusters that a step may make uncertain: the first cluster of each, ascending. All other
    /// clusters are safe, and so are all nodes that are not opened yet (unless the list is full). Tests all clusters
    /// once, also for later steps as long as these stay near. Allocates nothing.
    [[nodiscard]] std::span<const std::uint32_t> within(const ToolMotion& motion);
    /// Of the eight clusters from `first` on (a multiple of eight): one bit for each whose slab is not wide enough at
    /// both ends of the step.
    [[nodiscard]] std::uint32_t uncertainClusters(std::size_t first, const ToolMotion& motion) const;
    /// The same for the pairs of one cluster. Their numbers begin at placeOf(cluster, 0).
    [[nodiscard]] std::uint32_t uncertainPairs(std::size_t cluster, const ToolMotion& motion);
    /// The number of a pair: its cluster and its lane (0 to 7).
    [[nodiscard]] static std::size_t placeOf(std::size_t cluster, int lane) {
        TACTOOTH_ASSERT(lane >= 0 && lane < 8);
        return cluster * 8 + static_cast<std::size_t>(lane);
    }

    /// Uses a direction of the tooth's frame for the slabs of those `uncertain` pairs of a cluster that it separates
    /// during the whole step. `motion` is that of the last uncertainPairs. Returns the pairs that stay uncertain.
    [[nodiscard]] std::uint32_t separateBy(const Vec3& direction, std::size_t cluster, std::uint32_t uncertain,
                                           const ToolMotion& motion);

    /// The number of the tooth's leaf of a cluster.
    [[nodiscard]] std::uint32_t leafOf(std::size_t cluster) const { return packetOf(cluster).leaf[cluster % 8]; }
    [[nodiscard]] const NearLeaf& leaf(std::uint32_t number) const {
        TACTOOTH_ASSERT(number < near_.leafCount);
        return near_.leaves[number];
    }
    /// The tool's triangle of a cluster.
    [[nodiscard]] std::uint32_t toolOf(std::size_t cluster) const { return packetOf(cluster).tool[cluster % 8]; }

    /// The pair with this number.
    [[nodiscard]] NearPair operator[](std::size_t place) const;
    /// The direction of a pair's slab in the tooth's frame, of length 1 or almost; zero if the cluster is not opened.
    [[nodiscard]] Vec3 direction(std::size_t place) const;
    /// Finds in advance the planes that separate the tool from each listed triangle of `surface` on the straight step
    /// from `start` to `end`. A later move on about this displacement finds them here. `margin`: the least width at the
    /// end, mm.
    void separateAhead(const Surface& surface, const Pose& start, const Pose& end, double margin);
    /// Uses the plane with this unit normal and offset (mm), in the tooth's frame, for a pair's slab.
    void certify(std::size_t place, const Vec3& normal, double offset);

    /// Asserts every invariant, in O(n): counts within capacities, numbers within range, slabs as wide as stated when
    /// the list was built. `surface` is that of the list.
    void validate(const Surface& surface) const;

private:
    /// Slabs of a cluster's eight pairs, in the tool's frame at the pose at which the list was built.
    struct alignas(32) PairPacket {
        float normal[3][8];
        float high[8];              // greatest dot product of a corner of the tooth's triangle with the normal, mm
        std::uint32_t unseparable;  // one bit for each pair that no normal of its triangles has separated
    };
    static constexpr std::uint32_t kClosed = ~0U;
    struct Swept;
    struct KnownPlanes;

    /// A small range of motions, and the packets of clusters that steps within it may make uncertain.
    struct LocalCandidates {
        ToolMotion::Displacement middle;
        Vec3f along = Vec3f::Zero();      // shift of the range, mm
        float deviation = -1, turn = -1;  // distance from it, mm, and rotation, a chord; negative: none was searched
        std::vector<std::uint32_t> packets;
        std::size_t count = 0;
        std::size_t tested = 0;  // clusters: later ones are not tested yet

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
    void validateSlab(const ClusterPacket& packet, std::size_t lane) const;
    [[nodiscard]] bool isShortest() const;
    void shortenTo(double length);
    void list(const Surface& surface, const Pose& toolInTooth, std::size_t limit);
    PairPacket* open(std::size_t cluster);
    void separatePairAhead(const Surface& surface, std::size_t place, const Pose& start, const Pose& end);
    void fill(PairPacket& pairs, const NearLeaf& leaf, std::uint32_t tool) const;
    [[nodiscard]] Swept sweep(std::uint32_t tool, const ToolMotion& motion) const;
    [[nodiscard]] bool separateCluster(std::size_t cluster, const ToolMotion& motion, const Swept& swept);
    [[nodiscard]] static std::uint32_t separatePairs(const Vec3x8& directions, const NearLeaf& leaf, const Swept& tool,
                                                     std::uint32_t uncertain, PairPacket& pairs);
    [[nodiscard]] const ClusterPacket& packetOf(std::size_t cluster) const {
        TACTOOTH_ASSERT(cluster < near_.count);
        return near_.packets[cluster / 8];
    }

    const ToolShape* tool_;
    BvhTraversal traversal_;
    NearClusters near_;
    LocalCandidates around_;
    std::vector<PairPacket> pairs_;
    std::vector<std::uint32_t> opened_;  // index in pairs_ of each cluster; kClosed: not opened
    std::size_t openedCount_ = 0;
    std::array<Vec3f, 4>
        recentDirections_;  // of the last certified planes: what separates a pair often separates its neighbours
    std::size_t recentCount_ = 0;
    bool made_ = false;
    Pose at_;        // pose of the tool in the tooth at which the list was built
    Mat3 rotation_;  // of at_
    ContactMargin contactMargin_;
    double cap_ = 0;         // length of the next contact margin, mm: after a long list it stays short
    std::size_t limit_ = 0;  // of clusters
    Work work_ = 0;
};

}  // namespace tactooth
