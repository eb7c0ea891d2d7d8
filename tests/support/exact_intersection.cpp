// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "support/exact_intersection.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

namespace tactooth::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

struct ExactIntersection::Index {
    Triangles fixed;
    TriangleMesh moving;
    Tree tree;
};

ExactIntersection::ExactIntersection(const TriangleMesh& fixed, const TriangleMesh& moving) : index_(new Index) {
    for (std::size_t i = 0; i < fixed.triangles.size(); ++i) {
        const Kernel::Triangle_3 triangle(point(fixed.corner(i, 0)), point(fixed.corner(i, 1)),
                                          point(fixed.corner(i, 2)));
        if (!triangle.is_degenerate()) index_->fixed.push_back(triangle);
    }
    index_->moving = moving;
    index_->tree.insert(index_->fixed.begin(), index_->fixed.end());
    index_->tree.build();
}

ExactIntersection::~ExactIntersection() { delete index_; }

bool ExactIntersection::at(const Pose& pose) const {
    const TriangleMesh& moving = index_->moving;
    for (std::size_t i = 0; i < moving.triangles.size(); ++i) {
        const Kernel::Triangle_3 triangle(point(pose * moving.corner(i, 0)), point(pose * moving.corner(i, 1)),
                                          point(pose * moving.corner(i, 2)));
        if (!triangle.is_degenerate() && index_->tree.do_intersect(triangle)) return true;
    }
    return false;
}

}  // namespace tactooth::test
