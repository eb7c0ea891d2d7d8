// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/crown_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "instruments/measured_teeth.h"
#include "instruments/permanent_teeth.h"
#include "instruments/relief_map.h"

namespace tactooth::test {
namespace {

const AverageTooth& averageOf(int fdi) { return *std::ranges::find(kAverageTeeth, fdi, &AverageTooth::fdi); }

const MeasuredCrown* measuredCrown(int fdi) {
    const auto* const found = std::ranges::find(kMeasuredCrowns, fdi, &MeasuredCrown::fdi);
    return found == kMeasuredCrowns.end() ? nullptr : found;
}

/// Factors that give a measured tooth the diameters of the average one.
Vec3 stretchOf(int fdi) {
    const AverageTooth& average = averageOf(fdi);
    const MeasuredCrown& measured = *measuredCrown(fdi);
    return {average.mesiodistal / measured.mesiodistal, average.faciolingual / measured.buccolingual, 1};
}

/// The outline of a mesh at a height.
Box3 sectionAt(const TriangleMesh& mesh, double z) {
    Box3 box;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 from = mesh.corner(i, corner), to = mesh.corner(i, (corner + 1) % 3);
            if ((from.z() < z) != (to.z() < z)) box.extend(from + (z - from.z()) / (to.z() - from.z()) * (to - from));
        }
    }
    return box;
}

double sectionDeviation(const TriangleMesh& mesh, int fdi) {
    const MeasuredCrown& measured = *measuredCrown(fdi);
    const double top = boundingBox(mesh).max().z(), length = averageOf(fdi).crown;
    const Vec3 stretch = stretchOf(fdi);
    double largest = 0;
    for (std::size_t i = 0; i < kSectionDepths.size(); ++i) {
        const MeasuredSection& section = measured.sections[i];
        if (section.mesiodistal == 0) continue;
        const Vec3 size = sectionAt(mesh, top - kSectionDepths[i] * length).sizes();
        largest = std::max({largest, std::abs(size.x() - stretch.x() * section.mesiodistal),
                            std::abs(size.y() - stretch.y() * section.buccolingual)});
    }
    return largest;
}

/// The outline from above of a set of edges: distances from the middle of its box in equal directions.
class Outline {
public:
    using Points = std::vector<std::pair<Vec2, Vec2>>;
    explicit Outline(const Points& edges) {
        for (const auto& [a, b] : edges) box_.extend(a).extend(b);
        for (const auto& [a, b] : edges) add(a - box_.center(), b - box_.center());
    }

    [[nodiscard]] const Eigen::AlignedBox2d& box() const { return box_; }
    [[nodiscard]] double mean() const { return std::accumulate(radii_.begin(), radii_.end(), 0.0) / kDirections; }
    [[nodiscard]] Harmonic harmonic(int order) const {
        Harmonic sum{};
        for (int i = 0; i < kDirections; ++i) {
            sum.cosine += 2.0 / kDirections * radii_[static_cast<std::size_t>(i)] * std::cos(order * i * kStep);
            sum.sine += 2.0 / kDirections * radii_[static_cast<std::size_t>(i)] * std::sin(order * i * kStep);
        }
        return sum;
    }

    static constexpr int kDirections = 360;
    static constexpr double kStep = 2 * std::numbers::pi / kDirections;

private:
    /// The outermost place of the edge in each direction that it covers.
    void add(const Vec2& a, const Vec2& b) {
        const auto cross = [](const Vec2& p, const Vec2& q) { return p.x() * q.y() - p.y() * q.x(); };
        const double turn = cross(a, b);
        if (turn == 0) return;
        const Vec2& first = turn > 0 ? a : b;
        const Vec2& last = turn > 0 ? b : a;
        const double from = std::atan2(first.y(), first.x()) / kStep;
        const double angle = std::atan2(std::abs(turn), a.dot(b)) / kStep;
        for (int i = static_cast<int>(std::ceil(from)); i <= from + angle; ++i) {
            const Vec2 direction(std::cos(i * kStep), std::sin(i * kStep));
            double& radius = radii_[static_cast<std::size_t>((i + kDirections) % kDirections)];
            radius = std::max(radius, std::abs(turn) / cross(direction, Vec2(last - first)));
        }
    }

    Eigen::AlignedBox2d box_;
    std::array<double, kDirections> radii_{};
};

/// That of the upper 80 % of a crown, as the measured ones.
Outline outlineOf(const TriangleMesh& mesh, double length) {
    const double from = boundingBox(mesh).max().z() - 0.8 * length;
    Outline::Points edges;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 a = mesh.corner(i, corner), b = mesh.corner(i, (corner + 1) % 3);
            if (a.z() > from && b.z() > from) edges.emplace_back(a.head<2>(), b.head<2>());
        }
    }
    return Outline(edges);
}

/// A measured outline, stretched to the diameters of the average tooth.
Outline outlineOf(const MeasuredOutline& measured) {
    std::vector<Vec2> points;
    Eigen::AlignedBox2d box;
    for (int i = 0; i < Outline::kDirections; ++i) {
        const double angle = i * Outline::kStep;
        double radius = measured.mean;
        for (std::size_t m = 0; m < measured.harmonics.size(); ++m) {
            const double turned = static_cast<double>(m + 1) * angle;
            radius += measured.harmonics[m].cosine * std::cos(turned) + measured.harmonics[m].sine * std::sin(turned);
        }
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        box.extend(points.back());
    }
    const AverageTooth& average = averageOf(measured.fdi);
    const Eigen::Array2d stretch = Eigen::Array2d(average.mesiodistal, average.faciolingual) / box.sizes().array();
    Outline::Points edges;
    for (std::size_t i = 0; i < points.size(); ++i) {
        edges.emplace_back(stretch * points[i].array(), stretch * points[(i + 1) % points.size()].array());
    }
    return Outline(edges);
}

double outlineDeviation(const TriangleMesh& mesh, int fdi) {
    const Outline is = outlineOf(mesh, averageOf(fdi).crown);
    const Outline should = outlineOf(*std::ranges::find(kMeasuredOutlines, fdi, &MeasuredOutline::fdi));
    double largest = std::abs(is.mean() - should.mean());
    for (int order = 1; order <= static_cast<int>(MeasuredOutline{}.harmonics.size()); ++order) {
        const Harmonic a = is.harmonic(order), b = should.harmonic(order);
        largest = std::max({largest, std::abs(a.cosine - b.cosine), std::abs(a.sine - b.sine)});
    }
    return largest;
}

/// The highest place around one of a map: the tip of a cusp.
Vec3 tipNear(const ReliefMap& map, double u, double v) {
    constexpr int kReach = 3;  // cells: past the facets of the mesh
    Vec3 tip(u, v, map.at(u, v).value_or(-1e9));
    for (bool climbs = true; climbs;) {
        climbs = false;
        const Vec3 from = tip;
        for (int i = -kReach; i <= kReach; ++i) {
            for (int j = -kReach; j <= kReach; ++j) {
                const double x = from.x() + i * ReliefMap::kCell, y = from.y() + j * ReliefMap::kCell;
                const double height = map.at(x, y).value_or(-1e9);
                if (height <= tip.z()) continue;
                tip = {x, y, height};
                climbs = true;
            }
        }
    }
    return tip;
}

void compareTable(const TriangleMesh& mesh, const MeasuredTable& measured, CrownDeviation& deviation) {
    const ReliefMap above(mesh, 0, 1, 2);
    const double top = boundingBox(mesh).max().z();
    const AverageTooth& average = averageOf(measured.fdi);
    const Vec3 stretch(average.mesiodistal / measured.mesiodistal, average.faciolingual / measured.buccolingual, 1);
    deviation.tips = deviation.table = 0;
    for (const OcclusalPlace& place : measured.tips) {
        const Vec3 should = stretch.cwiseProduct(place);
        Vec3 is = tipNear(above, should.x(), should.y());
        is.z() = top - is.z();
        deviation.tips = std::max(*deviation.tips, (is - should).norm());
    }
    for (const OcclusalPlace& place : measured.places) {
        const Vec3 should = stretch.cwiseProduct(place);
        const double depth = top - above.at(should.x(), should.y()).value_or(-1e9);
        deviation.table = std::max(*deviation.table, std::abs(depth - should.z()));
    }
}

/// The highest place of a map over a line along `v`.
Vec3 crestAt(const ReliefMap& map, double u) {
    Vec3 crest(u, 0, -1e9);
    for (double v = map.box().min().y(); v < map.box().max().y(); v += ReliefMap::kCell) {
        const auto height = map.at(u, v);
        if (height && *height > crest.z()) crest = {u, v, *height};
    }
    return crest;
}

/// Places of the edge from distal to mesial, of which the outermost ones stand where the outline falls steeply: those
/// count with their distance in the plane of the edge alone.
double edgeDeviation(const TriangleMesh& mesh, const MeasuredEdge& measured) {
    const ReliefMap above(mesh, 0, 1, 2);
    const double top = boundingBox(mesh).max().z();
    const Vec3 stretch = stretchOf(measured.fdi);
    double largest = 0;
    for (std::size_t i = 1; i + 1 < measured.edge.size(); ++i) {
        const Vec3 place = stretch.cwiseProduct(measured.edge[i]);
        const Vec3 crest = crestAt(above, place.x());
        largest = std::max({largest, std::abs(top - crest.z() - place.z()), std::abs(crest.y() - place.y())});
    }
    return largest;
}

double thicknessDeviation(const TriangleMesh& mesh, const MeasuredEdge& measured) {
    const ReliefMap lip(mesh, 0, 2, 1), tongue(mesh, 0, 2, 1, -1);
    const double top = crestAt(ReliefMap(mesh, 0, 1, 2), 0).z(), stretch = stretchOf(measured.fdi).y();
    double squares = 0;
    for (std::size_t i = 0; i < kProfileDepths.size(); ++i) {
        const double z = top - kProfileDepths[i];
        const double thickness = lip.at(0, z).value_or(0) - tongue.at(0, z).value_or(0);
        const double difference = thickness - stretch * (measured.lip[i] - measured.tongue[i]);
        squares += difference * difference;
    }
    return std::sqrt(squares / static_cast<double>(kProfileDepths.size()));
}

}  // namespace

TriangleMesh mesialFrame(const BuiltinTooth& tooth) {
    TriangleMesh mesh = tooth.outer;
    if (mesialX(tooth.fdi) > 0) return mesh;
    for (Vec3f& vertex : mesh.vertices) vertex.x() = -vertex.x();
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
}

CrownDeviation deviationOf(const BuiltinTooth& tooth) {
    const TriangleMesh mesh = mesialFrame(tooth);
    const Box3 box = boundingBox(mesh);
    CrownDeviation deviation;
    if (isAnteriorTooth(tooth.fdi)) {
        const double length = averageOf(tooth.fdi).crown;
        deviation.mirrorCorrelation = mirrorCorrelation(ReliefMap(mesh, 0, 2, 1, -1), 0.15 * length, 0.97 * length);
    } else {
        const ReliefMap above(mesh, 0, 1, 2);
        deviation.mirrorCorrelation = mirrorCorrelation(above, box.min().y(), box.max().y());
    }
    if (measuredCrown(tooth.fdi) == nullptr) return deviation;
    deviation.section = sectionDeviation(mesh, tooth.fdi);
    deviation.outline = outlineDeviation(mesh, tooth.fdi);
    const auto* const table = std::ranges::find(kMeasuredTables, tooth.fdi, &MeasuredTable::fdi);
    if (table != kMeasuredTables.end()) compareTable(mesh, *table, deviation);
    const auto* const edge = std::ranges::find(kMeasuredEdges, tooth.fdi, &MeasuredEdge::fdi);
    if (edge == kMeasuredEdges.end()) return deviation;
    deviation.edge = edgeDeviation(mesh, *edge);
    deviation.thickness = thicknessDeviation(mesh, *edge);
    return deviation;
}

}  // namespace tactooth::test
