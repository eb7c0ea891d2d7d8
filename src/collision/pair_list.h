// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "collision/near_pairs.h"

namespace tactooth {

/// Sine of half the angle between two orientations.
[[nodiscard]] inline double sineOfHalfAngle(const Quat& a, const Quat& b) { return (a * b.conjugate()).vec().norm(); }

/// How a tool stands at the start and the end of a step, against the pose at which its near pairs were listed.
struct Excursion {
    /// The way of point p of the tool (in the tool's frame) is turn * p + shift, in the tool's frame at the listing.
    struct Way {
        Eigen::Matrix3f turn;
        Vec3f shift;
        float perLength;  ///< two points of the tool 1 mm apart differ in their ways by this much at most
        float spare;      ///< what a certificate must leave, mm
    };
    Way start, end;
    double greatest;  ///< no point of the tool gets further than this, mm
};

/// The pairs of triangles near a tool, kept while the tool moves within a skin. Each pair has a certificate: a
/// direction along which its two triangles were a known gap apart when the list was made. Eight certificates at a time
/// tell which pairs a step could bring together; only those deserve an exact look.
class PairList {
public:
    explicit PairList(const ToolShape& tool);

    /// Lists the pairs within `wantedReach` mm, or within less where they are too many. Allocates nothing.
    void make(const Surface& surface, const ToolShape& tool, const Pose& toolInTooth, double wantedReach);
    void clear() { made_ = false; }

    [[nodiscard]] bool made() const { return made_; }
    /// Every pair nearer than this was listed, mm.
    [[nodiscard]] double reach() const { return reach_; }
    /// No list reaches less far, however many pairs there are, mm.
    [[nodiscard]] double leastReach() const;
    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] const NearPair& operator[](std::size_t i) const { return found_[order_[i]]; }
    /// No point of the tool has moved further than this since the pairs were listed.
    [[nodiscard]] double travelTo(const Quat& rotation, const Vec3& position) const;
    [[nodiscard]] Excursion excursion(const Pose& start, const Pose& end, double margin) const;

    /// How many pairs, from the nearest on, the step could matter to; the rest is too far away.
    [[nodiscard]] std::size_t withinReachOf(const Excursion& excursion) const;
    /// Of the eight pairs from number `first` on (a multiple of eight), one bit for each whose certificate does not
    /// hold at both ends of the step.
    [[nodiscard]] std::uint32_t inDoubt(std::size_t first, const Excursion& excursion) const;
    /// The certificate's direction in the tooth's frame, of length 1 or almost; zero: none is known.
    [[nodiscard]] Vec3 direction(std::size_t i) const;
    /// Takes the plane with this unit normal and offset (of the tooth's frame) for the pair's certificate.
    void certify(std::size_t i, const Triangle3& tool, const Vec3& normal, double offset);

private:
    static constexpr int kBuckets = 32;

    void sortByDistance(const ToolShape& tool, std::size_t count);
    [[nodiscard]] Excursion::Way wayTo(const Pose& pose, double spare) const;
    [[nodiscard]] std::uint32_t holds(std::size_t first, const Excursion::Way& way) const;

    std::vector<NearPair> found_;       // as the walk writes them
    std::vector<std::uint32_t> order_;  // numbers of pairs, sorted by bucket of distanceAtLeast
    std::array<std::uint32_t, kBuckets + 1> bucketStart_{};
    /// Certificates of eight pairs in the sorted order, in the tool's frame at the listing.
    struct alignas(32) Certificates {
        float normal[3][8];
        float gap[8];
        float centre[3][8];  // ball around the tool's triangle
        float radius[8];
    };
    std::vector<Certificates> certificates_;
    std::size_t count_ = 0;
    bool made_ = false;
    Pose at_;
    Mat3 rotation_;  // of at_
    double reach_ = 0;
    double reachCap_ = 0;  // of the next list, mm: where the last one met many pairs, it stays short
    Vec3 centre_;          // of the tool, in its own frame
    double radius_ = 0;
};

}  // namespace tactooth
