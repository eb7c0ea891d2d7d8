// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// M. Garland, P. S. Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997. Ours collapses an
// edge onto one of its two vertices, so that no new vertex is made. T. K. Dey et al., "Topology preserving edge
// contraction", 1999: a collapse keeps the topology of a closed surface if the two ends have exactly two neighbours in
// common.
#include "geometry/mesh/simplify.h"

#include <algorithm>
#include <iterator>
#include <queue>
#include <tuple>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

/// Sum of squared distances to planes, weighted by area: p^T A p + 2 b^T p + c.
struct Quadric {
    Mat3 a = Mat3::Zero();
    Vec3 b = Vec3::Zero();
    double c = 0;

    void addPlane(const Vec3& normal, double offset, double weight) {
        a += weight * normal * normal.transpose();
        b += weight * offset * normal;
        c += weight * offset * offset;
    }
    void add(const Quadric& other) {
        a += other.a;
        b += other.b;
        c += other.c;
    }
    [[nodiscard]] double at(const Vec3& p) const { return std::max(0.0, p.dot(a * p) + 2 * b.dot(p) + c); }
};

/// The collapse of a vertex onto its neighbour `to`. The stamp shows whether that vertex has changed since the cost was
/// computed.
struct Collapse {
    double cost;
    std::uint32_t to, stampTo;

    [[nodiscard]] bool operator<(const Collapse& other) const {
        return std::tie(cost, to) < std::tie(other.cost, other.to);
    }
};

/// The cheapest collapse of vertex `from` that has not been tried. One entry for each vertex keeps the queue short.
struct Waiting {
    double cost;
    std::uint32_t from, to, stampFrom;

    [[nodiscard]] bool operator>(const Waiting& other) const {
        return std::tie(cost, from, to) > std::tie(other.cost, other.from, other.to);
    }
};

class Simplifier {
public:
    explicit Simplifier(const TriangleMesh& mesh)
        : mesh_(mesh),
          at_(mesh.vertices.size()),
          quadrics_(at_.size()),
          around_(at_.size()),
          stamps_(at_.size(), 0),
          offers_(at_.size()),
          alive_(mesh.triangles.size(), true),
          left_(mesh.triangles.size()) {
        constexpr std::size_t kUsualTriangles = 6;  // at a vertex
        for (std::size_t v = 0; v < at_.size(); ++v) {
            at_[v] = mesh.vertices[v].cast<double>();
            around_[v].reserve(2 * kUsualTriangles);
        }
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) addTriangle(t);
        for (std::uint32_t v = 0; v < at_.size(); ++v) offerCollapses(v);
    }

    void reduceTo(std::size_t triangles) {
        while (left_ > triangles && !queue_.empty()) {
            const Waiting next = queue_.top();
            queue_.pop();
            if (stamps_[next.from] != next.stampFrom) continue;
            TACTOOTH_ASSERT(!offers_[next.from].empty() && offers_[next.from].back().to == next.to);
            const std::uint32_t stampTo = offers_[next.from].back().stampTo;
            offers_[next.from].pop_back();
            if (stamps_[next.to] == stampTo && keepsTopology(next.from, next.to) && keepsNormals(next.from, next.to)) {
                collapse(next.from, next.to);
            } else {
                awaitCheapest(next.from);
            }
        }
    }

    [[nodiscard]] TriangleMesh result() const {
        constexpr auto kUnused = static_cast<std::uint32_t>(-1);
        std::vector<std::uint32_t> number(at_.size(), kUnused);
        TriangleMesh out;
        for (std::size_t t = 0; t < alive_.size(); ++t) {
            if (!alive_[t]) continue;
            Triangle triangle = mesh_.triangles[t];
            for (std::uint32_t& v : triangle) {
                if (number[v] == kUnused) {
                    number[v] = static_cast<std::uint32_t>(out.vertices.size());
                    out.vertices.push_back(mesh_.vertices[v]);
                }
                v = number[v];
            }
            out.triangles.push_back(triangle);
        }
        TACTOOTH_ASSERT(out.triangles.size() == left_);
        return out;
    }

private:
    void addTriangle(std::uint32_t t) {
        const Vec3 areaVector = mesh_.areaVector(t);
        const double twiceArea = areaVector.norm();
        for (const std::uint32_t v : mesh_.triangles[t]) {
            around_[v].push_back(t);
            if (twiceArea == 0) continue;
            const Vec3 normal = areaVector / twiceArea;
            quadrics_[v].addPlane(normal, -normal.dot(mesh_.corner(t, 0)), twiceArea);
        }
    }

    /// Writes the neighbours of a vertex, in the order of their numbers.
    void findNeighbours(std::uint32_t vertex, std::vector<std::uint32_t>& found) const {
        found.clear();
        for (const std::uint32_t t : around_[vertex]) {
            for (const std::uint32_t v : mesh_.triangles[t]) {
                if (v != vertex) found.push_back(v);
            }
        }
        std::ranges::sort(found);
        found.erase(std::unique(found.begin(), found.end()), found.end());
    }

    void offerCollapses(std::uint32_t from) {
        // A small share of the length keeps triangles of flat regions well shaped: all errors are zero there.
        constexpr double kLengthShare = 1e-6;
        std::vector<Collapse>& offers = offers_[from];
        offers.clear();
        findNeighbours(from, ofFrom_);
        for (const std::uint32_t to : ofFrom_) {
            Quadric sum = quadrics_[from];
            sum.add(quadrics_[to]);
            const double cost = sum.at(at_[to]) + kLengthShare * (at_[to] - at_[from]).squaredNorm();
            offers.push_back({cost, to, stamps_[to]});
        }
        std::sort(offers.rbegin(), offers.rend());
        awaitCheapest(from);
    }

    void awaitCheapest(std::uint32_t from) {
        if (offers_[from].empty()) return;
        const Collapse& next = offers_[from].back();
        queue_.push({next.cost, from, next.to, stamps_[from]});
    }

    [[nodiscard]] bool keepsTopology(std::uint32_t from, std::uint32_t to) {
        findNeighbours(from, ofFrom_);
        findNeighbours(to, ofTo_);
        common_.clear();
        std::ranges::set_intersection(ofFrom_, ofTo_, std::back_inserter(common_));
        constexpr std::size_t kTetrahedron = 4;
        return common_.size() == 2 && left_ > kTetrahedron && std::ranges::all_of(common_, [&](std::uint32_t v) {
                   return around_[v].size() > 3;  // otherwise two triangles would coincide
               });
    }

    /// No triangle rotates by more than about 60 degrees or becomes a needle.
    [[nodiscard]] bool keepsNormals(std::uint32_t from, std::uint32_t to) const {
        constexpr double kLeastCosine = 0.5, kLeastShape = 0.06;
        return std::ranges::all_of(around_[from], [&](std::uint32_t t) {
            std::array<Vec3, 3> now, then;
            for (int i = 0; i < 3; ++i) {
                const std::uint32_t v = mesh_.triangles[t][i];
                if (v == to) return true;  // this triangle is removed
                now[i] = at_[v];
                then[i] = at_[v == from ? to : v];
            }
            const Vec3 before = (now[1] - now[0]).cross(now[2] - now[0]);
            const Vec3 after = (then[1] - then[0]).cross(then[2] - then[0]);
            const double longest = std::max({(then[1] - then[0]).squaredNorm(), (then[2] - then[1]).squaredNorm(),
                                             (then[0] - then[2]).squaredNorm()});
            const double area = after.norm();
            return before.dot(after) > kLeastCosine * before.norm() * area && area > kLeastShape * longest;
        });
    }

    void collapse(std::uint32_t from, std::uint32_t to) {
        TACTOOTH_ASSERT(from != to);
        for (const std::uint32_t t : around_[from]) {
            TACTOOTH_ASSERT(alive_[t] && left_ > 0);
            Triangle& triangle = mesh_.triangles[t];
            if (std::ranges::find(triangle, to) == triangle.end()) {
                std::ranges::replace(triangle, from, to);
                around_[to].push_back(t);
                continue;
            }
            alive_[t] = false;
            --left_;
            for (const std::uint32_t v : triangle) {
                if (v != from) std::erase(around_[v], t);
            }
        }
        around_[from].clear();
        quadrics_[to].add(quadrics_[from]);
        ++stamps_[from];
        findNeighbours(to, ofTo_);
        ++stamps_[to];
        for (const std::uint32_t v : ofTo_) ++stamps_[v];
        offerCollapses(to);
        for (const std::uint32_t v : ofTo_) offerCollapses(v);
    }

    TriangleMesh mesh_;
    std::vector<Vec3> at_;
    std::vector<Quadric> quadrics_;
    std::vector<std::vector<std::uint32_t>> around_;  // triangles at each vertex
    std::vector<std::uint32_t> stamps_;
    std::vector<std::vector<Collapse>> offers_;  // of each vertex, the cheapest last
    std::vector<bool> alive_;
    std::size_t left_;
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> queue_;
    std::vector<std::uint32_t> ofFrom_, ofTo_, common_;  // vertices, for the moment
};

}  // namespace

TriangleMesh simplified(const TriangleMesh& closed, std::size_t triangles) {
    if (closed.triangles.size() <= triangles) return closed;
    Simplifier simplifier(closed);
    simplifier.reduceTo(triangles);
    return simplifier.result();
}

}  // namespace tactooth
