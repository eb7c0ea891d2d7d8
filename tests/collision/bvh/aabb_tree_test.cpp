// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/bvh/aabb_tree.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "support/expect_assert.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

/// Visits the whole tree: checks that every box encloses its sub-tree, and collects the triangles.
void walk(const AabbTree& tree, AabbTree::Link link, const Vec3f& low, const Vec3f& high, int depth,
          std::multiset<std::uint32_t>& triangles) {
    ASSERT_LE(depth, AabbTree::kMaxDepth);
    if (link.isLeaf()) {
        const AabbTree::Leaf& leaf = tree.leaf(link);
        for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
            triangles.insert(leaf.triangle[lane]);
            for (int corner = 0; corner < 3; ++corner) {
                for (int axis = 0; axis < 3; ++axis) {
                    ASSERT_GE(leaf.corner[corner][axis][lane], low[axis]);
                    ASSERT_LE(leaf.corner[corner][axis][lane], high[axis]);
                }
            }
        }
        return;
    }
    const AabbTree::Node& node = tree.node(link);
    for (int i = 0; i < AabbTree::kWidth; ++i) {
        if (node.low[0][i] > node.high[0][i]) continue;
        const Vec3f childLow(node.low[0][i], node.low[1][i], node.low[2][i]);
        const Vec3f childHigh(node.high[0][i], node.high[1][i], node.high[2][i]);
        ASSERT_TRUE((childLow.array() >= low.array()).all() && (childHigh.array() <= high.array()).all());
        walk(tree, node.child[i], childLow, childHigh, depth + 1, triangles);
    }
}

/// Whether the disc of child `i` of a node encloses all corners below it.
void expectDiscHolds(const AabbTree& tree, const AabbTree::Node& node, int i, AabbTree::Link link) {
    if (!link.isLeaf()) {
        for (int k = 0; k < AabbTree::kWidth; ++k) {
            const AabbTree::Node& below = tree.node(link);
            if (below.low[0][k] <= below.high[0][k]) expectDiscHolds(tree, node, i, below.child[k]);
        }
        return;
    }
    const auto of = [](const auto& axis, int lane) { return Vec3(axis[0][lane], axis[1][lane], axis[2][lane]); };
    const Vec3 centre = of(node.centre, i), normal = of(node.normal, i);
    for (const auto& corner : tree.leaf(link).corner) {
        for (int lane = 0; lane < AabbTree::kWidth; ++lane) {
            const Vec3 away = of(corner, lane) - centre;
            const double along = normal.dot(away);
            EXPECT_LE(std::abs(along), node.halfThickness[i] + 1e-6);
            EXPECT_LE((away - along * normal).norm(), node.discRadius[i] + 1e-6);
        }
    }
}

void expectHoldsEachTriangleOnce(const TriangleMesh& mesh, TreeBuild build) {
    const AabbTree tree(mesh, build);
    std::multiset<std::uint32_t> triangles;
    walk(tree, tree.rootLink(), tree.box().min().cast<float>(), tree.box().max().cast<float>(), 0, triangles);
    ASSERT_EQ(triangles.size(), mesh.triangles.size());
    ASSERT_EQ(std::set<std::uint32_t>(triangles.begin(), triangles.end()).size(), mesh.triangles.size());
}
void expectHoldsEachTriangleOnce(const TriangleMesh& mesh) {
    for (const TreeBuild build : {TreeBuild::Best, TreeBuild::Quick}) expectHoldsEachTriangleOnce(mesh, build);
}

/// Every box and every triangle of a tree, in depth-first order.
void describe(const AabbTree& tree, AabbTree::Link link, std::vector<std::vector<float>>& boxes,
              std::vector<std::uint32_t>& triangles) {
    if (link.isLeaf()) {
        const AabbTree::Leaf& leaf = tree.leaf(link);
        triangles.insert(triangles.end(), leaf.triangle, leaf.triangle + leaf.count);
        return;
    }
    const AabbTree::Node& node = tree.node(link);
    boxes.emplace_back(&node.low[0][0], &node.low[0][0] + 3 * AabbTree::kWidth);
    boxes.emplace_back(&node.high[0][0], &node.high[0][0] + 3 * AabbTree::kWidth);
    for (int i = 0; i < AabbTree::kWidth && node.low[0][i] <= node.high[0][i]; ++i)
        describe(tree, node.child[i], boxes, triangles);
}

void expectEqual(const AabbTree& a, const AabbTree& b) {
    std::vector<std::vector<float>> boxesOfA, boxesOfB;
    std::vector<std::uint32_t> trianglesOfA, trianglesOfB;
    describe(a, a.rootLink(), boxesOfA, trianglesOfA);
    describe(b, b.rootLink(), boxesOfB, trianglesOfB);
    EXPECT_EQ(boxesOfA, boxesOfB);
    EXPECT_EQ(trianglesOfA, trianglesOfB);
}

}  // namespace

TEST(AabbTree, HoldsEachTriangleOfASphereOnce) {
    expectHoldsEachTriangleOnce(test::sphere(Vec3(1, 2, 3), 5, 150, 100));
}

TEST(AabbTree, HoldsOneTriangle) {
    expectHoldsEachTriangleOnce({{Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)}, {{0, 1, 2}}});
}

TEST(AabbTree, StaysShallowWhenAllTrianglesCoincide) {
    TriangleMesh mesh{{Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)}, {}};
    mesh.triangles.assign(100000, Triangle{0, 1, 2});
    expectHoldsEachTriangleOnce(mesh);
}

TEST(AabbTree, StaysShallowWhenSizesGrowExponentially) {
    TriangleMesh mesh;
    for (int i = 0; i < 20000; ++i) {
        const float scale = std::pow(2.0F, static_cast<float>(i % 100) - 50.0F);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {Vec3f(scale, 0, 0), Vec3f(0, scale, 0), Vec3f(0, 0, scale)});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    expectHoldsEachTriangleOnce(mesh);
}

TEST(AabbTree, IsTheSameFromOneThread) {
    TriangleMesh mesh = test::sphere(Vec3(1, 2, 3), 5, 300, 150);
    ASSERT_GT(mesh.triangles.size(), 80000U);  // enough for every parallel branch of the build
    std::ranges::shuffle(mesh.triangles, std::mt19937(7));
    const AabbTree tree(mesh);
    const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
    expectEqual(AabbTree(mesh), tree);
}

TEST(AabbTree, BuiltQuicklyHasFullLeavesAndNodes) {
    for (const int around : {3, 5, 12, 40, 120}) {
        const TriangleMesh mesh = test::sphere(Vec3(1, 2, 3), 5, around, 10);
        const AabbTree tree(mesh, TreeBuild::Quick);
        const std::size_t leaves = (mesh.triangles.size() + 7) / 8;
        EXPECT_EQ(tree.leaves().size(), leaves);
        EXPECT_LE(tree.nodes().size(), 1 + (leaves + 7) / 8 + (leaves + 63) / 64);
        EXPECT_EQ(tree.box().min(), AabbTree(mesh).box().min());
        EXPECT_EQ(tree.box().max(), AabbTree(mesh).box().max());
    }
}

TEST(AabbTree, OfAnEmptyMeshIsEmpty) { EXPECT_TRUE(AabbTree(TriangleMesh{}).empty()); }

TEST(AabbTree, DiscsEncloseTheTrianglesOfEachChild) {
    TriangleMesh flat;  // a bumpy plate
    std::mt19937 random(9);
    std::uniform_real_distribution<float> height(0, 0.02F);
    for (std::uint32_t i = 0; i < 61 * 61; ++i)
        flat.vertices.emplace_back(0.1F * static_cast<float>(i % 61), 0.1F * static_cast<float>(i / 61),
                                   height(random));
    flat.triangles = test::gridTriangles(61);
    TriangleMesh points;  // triangles without area have no mean normal
    points.vertices = {{1, 2, 3}, {4, 5, 6}};
    points.triangles.assign(40, {0, 1, 1});
    for (const TriangleMesh& mesh : {flat, test::sphere(Vec3(3, 4, 5), 2, 90, 60), points}) {
        const AabbTree tree(mesh);
        float thinnest = 1;
        for (const AabbTree::Node& node : tree.nodes()) {
            for (int i = 0; i < AabbTree::kWidth; ++i) {
                if (node.low[0][i] > node.high[0][i]) continue;
                expectDiscHolds(tree, node, i, node.child[i]);
                thinnest = std::min(thinnest, node.halfThickness[i] / node.discRadius[i]);
            }
        }
        EXPECT_LT(thinnest, 0.1F);
    }
}

TEST(AabbTree, KeepsItsInvariantsOnRandomMeshes) {
    std::mt19937 random(12);
    std::normal_distribution<float> normal;
    for (const int count : {1, 7, 8, 9, 64, 65, 1000}) {
        TriangleMesh mesh;
        for (int i = 0; i < 3 * count; ++i) mesh.vertices.emplace_back(normal(random), normal(random), normal(random));
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i)
            mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        for (const TreeBuild build : {TreeBuild::Best, TreeBuild::Quick}) AabbTree(mesh, build).validate();
    }
    AabbTree().validate();
}

TEST(AabbTree, AssertsThatLinksAreOfTheRightKindAndInRange) {
    const AabbTree tree(test::sphere(Vec3(1, 2, 3), 5, 20, 10));
    EXPECT_ASSERT((void)tree.node(AabbTree::Link::toLeaf(0)));
    EXPECT_ASSERT((void)tree.leaf(AabbTree::Link::toNode(0)));
    EXPECT_ASSERT((void)tree.leaf(AabbTree::Link::toLeaf(static_cast<std::uint32_t>(tree.leaves().size()))));
    EXPECT_ASSERT((void)AabbTree().root());
}

}  // namespace tactooth
