// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/neighbours/neighbour_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include "collision/contact_oracle.h"
#include "collision/narrow/gjk.h"
#include "geometry/util/pose.h"
#include "support/expect_assert.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using PairKey = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();  // mm
constexpr std::size_t kCapacity = 1 << 14;
constexpr double kMargin = 1e-6;  // mm

PairKey keyOf(const NearPair& pair) { return {pair.part, pair.tooth, pair.tool}; }

Box3 boxOf(const Triangle3& triangle) {
    Box3 box;
    for (const Vec3& corner : triangle) box.extend(corner);
    return box;
}

/// Every pair of triangles that is nearer than `distance` (mm) with the tool at `pose`, by brute force.
std::set<PairKey> pairsWithin(const TriangleMesh& tooth, const ToolShape& tool, const Pose& pose, double distance) {
    std::set<PairKey> pairs;
    std::vector<Box3> boxes;
    for (std::uint32_t i = 0; i < tooth.triangles.size(); ++i) boxes.push_back(boxOf(cornersOf(tooth, i)));
    for (std::uint32_t k = 0; k < tool.mesh().triangles.size(); ++k) {
        const Triangle3 moved = tool.cornersAt(pose, k);
        const Box3 box = boxOf(moved);
        for (std::uint32_t i = 0; i < tooth.triangles.size(); ++i) {
            if (boxes[i].exteriorDistance(box) > distance) continue;
            const GjkResult gjk = distanceBetween(cornersOf(tooth, i), moved, moved[0] - tooth.corner(i, 0));
            if (!gjk.separated || gjk.distance < distance) pairs.insert({0, i, k});
        }
    }
    return pairs;
}

/// The pairs that the list does not prove to be separated during a step. `known`: the normals of active constraints.
std::set<PairKey> uncertainPairsOf(NeighbourList& list, const Pose& start, const Pose& end,
                                   std::span<const Vec3> known = {}) {
    const ToolMotion motion = list.motion(start, end, kMargin, known);
    std::ignore = list.within(motion);  // opens uncertain nodes
    EXPECT_FALSE(list.isFull());
    std::set<PairKey> pairs;
    for (std::size_t first = 0; first < list.clusters(); first += 8) {
        for (std::uint32_t near = list.uncertainClusters(first, motion); near != 0; near &= near - 1) {
            const std::size_t cluster = first + static_cast<std::size_t>(std::countr_zero(near));
            for (std::uint32_t uncertain = list.uncertainPairs(cluster, motion); uncertain != 0;
                 uncertain &= uncertain - 1)
                pairs.insert(keyOf(list[NeighbourList::placeOf(cluster, std::countr_zero(uncertain))]));
        }
    }
    return pairs;
}

Vec3 randomVector(std::mt19937& random, double length) {
    std::normal_distribution<double> normal;
    const double x = normal(random);
    const double y = normal(random);
    return length * Vec3(x, y, normal(random)).normalized();
}

/// The orientation rotated about a random axis, by an angle with this chord.
Quat rotated(const Quat& rotation, std::mt19937& random, double chord) {
    return (Quat(Eigen::AngleAxisd(2 * std::asin(chord / 2), randomVector(random, 1))) * rotation).normalized();
}

struct Scene {
    TriangleMesh tooth = test::sphere(Vec3::Zero(), 3, 60, 40);
    std::shared_ptr<const Surface> surface = test::surfaceOf(tooth);
    std::shared_ptr<const ToolShape> tool = test::toolOf(test::sphere(Vec3(0, 0, 0.6), 0.6, 16, 10));

    [[nodiscard]] Pose poseAbove(std::mt19937& random, double height) const {
        const Vec3 up = randomVector(random, 1);
        return {(3 + height) * up, shortestRotation(Vec3::UnitZ(), up)};
    }
};

}  // namespace

TEST(NeighbourList, APairThatAMotionWithinTheMarginBringsTogetherIsUncertain) {
    const Scene scene;
    NeighbourList list(*scene.tool, kCapacity);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    int nearPairs = 0;
    for (int i = 0; i < 60; ++i) {
        const Pose at = scene.poseAbove(random, 0.05 * unit(random));
        list.make(*scene.surface, at, {randomVector(random, 0.15 * unit(random)), 0.05, 0.1 * unit(random)});
        const ContactMargin& contactMargin = list.contactMargin();  // shortened if the list is long
        ASSERT_GT(contactMargin.around, 0.01);
        const double share = unit(random);
        const Vec3 shift = share * contactMargin.along + randomVector(random, 0.99 * contactMargin.around);
        const Pose end{at.position + shift, rotated(at.rotation, random, 0.99 * contactMargin.turn)};
        EXPECT_LE(list.deviation(end.position), contactMargin.around);
        EXPECT_LE(list.chordTo(end.rotation), contactMargin.turn);
        const std::set<PairKey> uncertain = uncertainPairsOf(list, at, end);
        for (const PairKey& pair : pairsWithin(scene.tooth, *scene.tool, end, kMargin)) {
            EXPECT_TRUE(uncertain.contains(pair)) << i;
            ++nearPairs;
        }
    }
    EXPECT_GT(nearPairs, 200);
}

TEST(NeighbourList, TheLocalCandidatesContainEveryUncertainCluster) {
    const Scene scene;
    NeighbourList list(*scene.tool, kCapacity);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    std::size_t uncertainPackets = 0;
    std::size_t candidatePackets = 0;
    std::size_t allPackets = 0;
    for (int i = 0; i < 60; ++i) {
        Pose pose = scene.poseAbove(random, 0.02 * unit(random));
        const Vec3 along = randomVector(random, 0.1);
        list.buildAll(*scene.surface, pose, {along, 0.05, 0.02});
        for (int step = 0; step < 12; ++step) {  // further along the path, with some deviation and rotation
            const Vec3 shift = 0.008 * along.normalized() + randomVector(random, 0.004 * unit(random));
            const Pose end{pose.position + shift, rotated(pose.rotation, random, 0.001 * unit(random))};
            const ToolMotion motion = list.motion(pose, end, kMargin, {});
            const auto candidates = list.within(motion);
            EXPECT_TRUE(std::is_sorted(candidates.begin(), candidates.end()));
            for (std::uint32_t first = 0; first < list.clusters(); first += 8) {
                if (list.uncertainClusters(first, motion) == 0) continue;
                EXPECT_TRUE(std::binary_search(candidates.begin(), candidates.end(), first)) << i << ", step " << step;
                ++uncertainPackets;
            }
            candidatePackets += candidates.size();
            allPackets += (list.clusters() + 7) / 8;
            pose = end;
        }
    }
    EXPECT_GT(uncertainPackets, 1000U);
    EXPECT_LT(candidatePackets, allPackets - allPackets / 4) << "else the search saves little";
}

TEST(NeighbourList, NodesThatAStepDoesNotOpenHoldNoPairThatItBringsTogether) {
    TriangleMesh plate;  // rough
    std::mt19937 random(13);
    std::uniform_real_distribution<double> unit(0, 1);
    for (std::uint32_t i = 0; i < 41 * 41; ++i) {
        const double x = 0.1 * (i % 41) - 2, y = 0.1 * (i / 41) - 2;
        plate.vertices.push_back(Vec3(x, y, 0.1 * x * x + 0.03 * unit(random)).cast<float>());
    }
    plate.triangles = test::gridTriangles(41);
    // Two balls and a thin neck: a tool much smaller than its convex hull.
    TriangleMesh dumbbell = test::sphere(Vec3(0, 0, 0.4), 0.4, 16, 10);
    for (const TriangleMesh& more :
         {test::cylinder(Vec3(0, 0, 0.4), 0.1, 2, 12), test::sphere(Vec3(0, 0, 2.4), 0.5, 16, 10)}) {
        const auto first = static_cast<std::uint32_t>(dumbbell.vertices.size());
        dumbbell.vertices.insert(dumbbell.vertices.end(), more.vertices.begin(), more.vertices.end());
        for (const Triangle& t : more.triangles)
            dumbbell.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    const auto surface = test::surfaceOf(plate);
    const auto tool = test::toolOf(dumbbell);
    NeighbourList list(*tool, kCapacity);
    int nearPairs = 0;
    for (int i = 0; i < 20; ++i) {
        const Quat tilt = rotated(Quat(Eigen::AngleAxisd(-unit(random), Vec3::UnitX())), random, 0.3);
        const Pose at{Vec3(unit(random) - 0.5, 0.5, 0.05 + 0.1 * unit(random)), tilt};
        list.make(*surface, at, {randomVector(random, 0.1), 0.05, 0.02});
        for (int step = 0; step < 6; ++step) {  // a later step finds the nodes open that earlier ones opened
            const auto poseWithinMargin = [&](double share) {
                const Vec3 shift =
                    share * list.contactMargin().along + randomVector(random, 0.99 * list.contactMargin().around);
                return Pose{at.position + shift,
                            rotated(at.rotation, random, 0.99 * list.contactMargin().turn * unit(random))};
            };
            const Pose start = poseWithinMargin(unit(random)), end = poseWithinMargin(unit(random));
            const Vec3 up = Vec3::UnitZ();
            const std::set<PairKey> uncertain = uncertainPairsOf(list, start, end, {&up, 1});
            for (const Pose& pose : {start, end}) {
                for (const PairKey& pair : pairsWithin(plate, *tool, pose, kMargin)) {
                    EXPECT_TRUE(uncertain.contains(pair)) << i << ", step " << step;
                    ++nearPairs;
                }
            }
        }
    }
    EXPECT_GT(nearPairs, 1000);
}

TEST(NeighbourList, OpensNoMoreNodesThanAStepNeeds) {
    const Scene scene;
    NeighbourList some(*scene.tool, kCapacity), all(*scene.tool, kCapacity);
    const Pose at{Vec3(0, 0, 3.05), Quat::Identity()};
    const ContactMargin contactMargin{Vec3(0.3, 0, 0), 0.1, 0.01};
    all.buildAll(*scene.surface, at, contactMargin);
    some.make(*scene.surface, at, contactMargin);
    EXPECT_EQ(some.clusters(), 0U);
    std::ignore = some.within(some.motion(at, {at.position + Vec3(0.01, 0, 0), at.rotation}, kMargin, {}));
    EXPECT_EQ(some.clusters(), 0U) << "no triangle is as near as 10 um";
    std::ignore = some.within(some.motion(at, {at.position - Vec3(0, 0, 0.06), at.rotation}, kMargin, {}));
    EXPECT_GT(some.clusters(), 0U);
    EXPECT_LT(some.clusters(), all.clusters() / 2);
}

TEST(NeighbourList, AListWithTooLittleRoomCoversLessAndIsComplete) {
    const Scene scene;
    const Pose at{Vec3(0, 0, 3.01), Quat::Identity()};
    const ContactMargin wanted{Vec3(0.6, 0, 0), 0.3, 0.02};
    NeighbourList all(*scene.tool, kCapacity);
    all.buildAll(*scene.surface, at, wanted);
    const std::size_t fewClusters = all.clusters() / 4 / 8 * 8;
    ASSERT_GT(fewClusters, 0U);
    NeighbourList some(*scene.tool, fewClusters);
    some.buildWithinCapacity(*scene.surface, at, wanted, 0.1, kNoLimit);
    EXPECT_TRUE(some.made());
    EXPECT_LE(some.clusters(), fewClusters);
    const double reach = some.contactMargin().along.norm() + some.contactMargin().around;
    EXPECT_LT(reach, 0.9);
    EXPECT_GE(reach, 0.1);
    NeighbourList same(*scene.tool, kCapacity);
    same.buildAll(*scene.surface, at, some.contactMargin());
    EXPECT_EQ(some.clusters(), same.clusters());

    for (const std::size_t capacity : {kCapacity, fewClusters}) {  // more than enough, and too few
        NeighbourList whole(*scene.tool, capacity);
        whole.buildWithinCapacity(*scene.surface, at, wanted, capacity == fewClusters ? 0.9 : 0.1, kNoLimit);
        EXPECT_EQ(whole.clusters(), all.clusters());
        EXPECT_EQ(whole.contactMargin().along, wanted.along);
    }
}

TEST(NeighbourList, AListIsNoLongerThanRequested) {
    const Scene scene;
    const Pose at{Vec3(0, 0, 3.01), Quat::Identity()};
    const ContactMargin wanted{Vec3(0.6, 0, 0), 0.3, 0.02};
    NeighbourList list(*scene.tool, kCapacity);
    for (const double most : {0.5, 0.2, 0.05}) {
        list.buildWithinCapacity(*scene.surface, at, wanted, 0.1, most);
        EXPECT_NEAR(list.contactMargin().length(), std::max(most, 0.1), 1e-12);
        EXPECT_NEAR(list.contactMargin().around / wanted.around, list.contactMargin().length() / wanted.length(),
                    1e-12);
        NeighbourList same(*scene.tool, kCapacity);
        same.buildAll(*scene.surface, at, list.contactMargin());
        EXPECT_EQ(list.clusters(), same.clusters());
    }
}

TEST(NeighbourList, AKnownPlaneClearsAllPairsThatItSeparates) {
    const auto plate = test::surfaceOf(test::box(Vec3(-5, -5, -1), Vec3(5, 5, 0)));
    const auto tool = test::toolOf(test::sphere(Vec3(0, 0, 0.6), 0.6, 16, 10));
    NeighbourList list(*tool, kCapacity);
    const Pose at{Vec3(0.3, 0.2, 1e-3), Quat::Identity()};
    list.make(*plate, at, {Vec3(0.1, 0, 0), 0.05, 0});
    const Pose end{at.position + Vec3(0.08, 0, 0), at.rotation};
    const Vec3 up = Vec3::UnitZ();
    EXPECT_FALSE(uncertainPairsOf(list, at, {at.position - 0.04 * up, at.rotation}, {&up, 1}).empty());
    EXPECT_GT(list.clusters(), 0U);
    EXPECT_TRUE(uncertainPairsOf(list, at, end, {&up, 1}).empty());
}

TEST(NeighbourList, ACertifiedPairIsNotUncertainWhileItsPlaneSeparatesIt) {
    const auto plate = test::surfaceOf(test::box(Vec3(-5, -5, -1), Vec3(5, 5, 0)));
    const auto tool = test::toolOf(test::box(Vec3(0, -0.5, 0), Vec3(1, 0.5, 1)));
    NeighbourList list(*tool, kCapacity);
    const Pose at{Vec3(0, 0, 0.01), Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY()))};
    const Pose above{Vec3(0, 0, 0.5), at.rotation};
    list.make(*plate, above, {Vec3(0, 0, -0.6), 0.05, 0});
    const ToolMotion motion = list.motion(above, {Vec3(0, 0, -0.05), at.rotation}, kMargin, {});
    std::ignore = list.within(motion);
    int certified = 0;
    for (std::size_t cluster = 0; cluster < list.clusters(); ++cluster) {
        const std::uint32_t uncertain = list.uncertainPairs(cluster, motion);
        if (uncertain == 0) continue;
        const int lane = std::countr_zero(uncertain);
        list.certify(NeighbourList::placeOf(cluster, lane), Vec3::UnitZ(), -2);  // as if the tooth were far below
        EXPECT_EQ(list.uncertainPairs(cluster, motion), uncertain & ~(1U << lane));
        EXPECT_NEAR((list.direction(NeighbourList::placeOf(cluster, lane)) - Vec3::UnitZ()).norm(), 0, 1e-6);
        ++certified;
    }
    EXPECT_GT(certified, 0);
}

TEST(NeighbourList, FindsSeparatingPlanesAhead) {
    const Scene scene;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    std::size_t uncertainBefore = 0;
    std::size_t uncertainAfter = 0;
    int nearPairs = 0;
    for (int i = 0; i < 60; ++i) {
        const Pose at = scene.poseAbove(random, 0.02 * unit(random));
        const Vec3 shift = randomVector(random, 0.05);
        const Pose end{at.position + shift, rotated(at.rotation, random, 0.01)};
        NeighbourList list(*scene.tool, kCapacity);
        list.buildAll(*scene.surface, at, {shift, 0.05, 0.05});
        uncertainBefore += uncertainPairsOf(list, at, end).size();
        list.separateAhead(*scene.surface, at, end, kMargin);
        const std::set<PairKey> uncertain = uncertainPairsOf(list, at, end);
        uncertainAfter += uncertain.size();
        for (const Pose& pose : {at, end}) {
            for (const PairKey& pair : pairsWithin(scene.tooth, *scene.tool, pose, kMargin)) {
                EXPECT_TRUE(uncertain.contains(pair)) << i;
                ++nearPairs;
            }
        }
        for (const PairKey& pair : uncertain) {
            const Triangle3 tooth = cornersOf(scene.tooth, std::get<1>(pair));
            std::vector<Vec3> swept;
            for (const Pose& pose : {at, end}) {
                for (const Vec3& corner : scene.tool->cornersAt(pose, std::get<2>(pair))) swept.push_back(corner);
            }
            const GjkResult gjk = distanceBetween(tooth, swept, swept[0] - tooth[0]);
            EXPECT_LT(gjk.separated ? gjk.distance : 0, 1e-4) << "pairs that are clearly apart are separated";
        }
    }
    EXPECT_GT(nearPairs, 100);
    EXPECT_LT(uncertainAfter, uncertainBefore);
}

TEST(NeighbourList, HiddenTrianglesAreNotListed) {
    const Scene scene;
    auto surface = std::make_shared<Surface>(*scene.surface);
    surface->hidden = std::make_shared<const TriangleMask>(scene.tooth.triangles.size() / 64 + 1, ~std::uint64_t{0});
    NeighbourList list(*scene.tool, kCapacity);
    const Pose at{Vec3(0, 0, 3), Quat::Identity()};
    list.make(*surface, at, {Vec3::Zero(), 0.1, 0});
    std::ignore = list.within(list.motion(at, at, kMargin, {}));
    EXPECT_EQ(list.clusters(), 0U);
}

TEST(NeighbourList, ShortensItsMarginIfTooManyPairsAreNear) {
    const TriangleMesh fine = test::sphere(Vec3::Zero(), 1, 400, 200);
    const auto tool = test::toolOf(test::sphere(Vec3::Zero(), 0.9, 100, 50));
    const auto inside = test::surfaceOf(fine);
    NeighbourList list(*tool, kCapacity);
    const Pose at{Vec3(0, 0, 0.05), Quat::Identity()};
    list.make(*inside, at, {Vec3(0.3, 0, 0), 0.3, 0.1});
    std::ignore = list.within(list.motion(at, {at.position + Vec3(0.3, 0, 0), at.rotation}, kMargin, {}));
    ASSERT_TRUE(list.isFull());
    while (list.isFull()) {
        ASSERT_TRUE(list.shorten());
        list.make(*inside, at, {Vec3(0.3, 0, 0), 0.3, 0.1});
        std::ignore =
            list.within(list.motion(at, {at.position + list.contactMargin().along, at.rotation}, kMargin, {}));
    }
    EXPECT_LT(list.contactMargin().around, 0.3);
    EXPECT_GT(list.contactMargin().around, 0);
    EXPECT_LT(list.contactMargin().along.norm(), 0.3);
}

TEST(NeighbourList, ListsAllThatIsRequestedHoweverMuch) {
    const Scene scene;
    NeighbourList list(*scene.tool, 64);
    const Pose inside{Vec3(0, 0, 2.4), Quat::Identity()};
    list.buildAll(*scene.surface, inside, {});
    const std::set<PairKey> uncertain = uncertainPairsOf(list, inside, inside);
    const std::set<PairKey> touching = pairsWithin(scene.tooth, *scene.tool, inside, 0);
    EXPECT_GT(touching.size(), 64U);
    for (const PairKey& pair : touching) EXPECT_TRUE(uncertain.contains(pair));
}

TEST(NeighbourList, KeepsItsInvariantsOverRandomSteps) {
    const Scene scene;
    NeighbourList list(*scene.tool, kCapacity);
    std::mt19937 random(15);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 12; ++i) {
        Pose pose = scene.poseAbove(random, 0.02 * unit(random));
        if (i % 3 == 0) list.buildAll(*scene.surface, pose, {randomVector(random, 0.1), 0.05, 0.02});
        if (i % 3 == 1) list.make(*scene.surface, pose, {randomVector(random, 0.1), 0.05, 0.02});
        if (i % 3 == 2) std::ignore = list.buildUpTo(*scene.surface, pose, 100);
        list.validate(*scene.surface);
        for (int step = 0; step < 4; ++step) {
            const Pose end{pose.position + randomVector(random, 0.01), rotated(pose.rotation, random, 0.001)};
            const Vec3 known[] = {randomVector(random, 1), Vec3::UnitZ()};
            const ToolMotion motion = list.motion(pose, end, kMargin, known);
            for (const std::uint32_t first : list.within(motion)) {
                for (std::uint32_t near = list.uncertainClusters(first, motion); near != 0; near &= near - 1) {
                    const std::size_t cluster = first + static_cast<std::size_t>(std::countr_zero(near));
                    const std::uint32_t uncertain = list.uncertainPairs(cluster, motion);
                    if (uncertain == 0) continue;
                    list.certify(NeighbourList::placeOf(cluster, std::countr_zero(uncertain)), Vec3::UnitZ(), 0);
                    std::ignore = list.separateBy(Vec3::UnitX(), cluster, uncertain, motion);
                }
            }
            list.validate(*scene.surface);
            pose = end;
        }
    }
}

TEST(NeighbourList, AssertsThatItIsMadeAndThatItsArgumentsMakeSense) {
    const Scene scene;
    NeighbourList list(*scene.tool, kCapacity);
    const Pose at{Vec3(0, 0, 3.01), Quat::Identity()};
    EXPECT_ASSERT((void)list.motion(at, at, kMargin, {}));
    EXPECT_ASSERT((void)list.shorten());
    EXPECT_ASSERT(list.make(*scene.surface, at, {Vec3::Zero(), -1, 0}));
    EXPECT_ASSERT(list.make(*scene.surface, {at.position / 0.0, at.rotation}, {}));
    EXPECT_ASSERT(list.make(*scene.surface, {at.position, Quat(2, 0, 0, 0)}, {}));
    list.buildAll(*scene.surface, at, {Vec3::Zero(), 0.05, 0.01});
    ASSERT_GT(list.clusters(), 8U);
    const ToolMotion motion = list.motion(at, at, kMargin, {});
    EXPECT_ASSERT((void)list.uncertainClusters(1, motion));
    EXPECT_ASSERT((void)list.uncertainPairs(list.clusters(), motion));
    EXPECT_ASSERT(list.certify(0, Vec3(0, 0, 2), 0));
    EXPECT_ASSERT((void)list.separateBy(Vec3::Zero(), 0, 1, motion));
    EXPECT_ASSERT((void)NeighbourList::placeOf(0, 8));
    EXPECT_ASSERT((void)list.motion(at, at, -1, {}));
}

}  // namespace tactooth
