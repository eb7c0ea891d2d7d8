// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// The lining is lofted from a curve around both jaws to a curve around the opening of the lips. The first curve follows
// the vestibules and, behind the last teeth, the fold between the jaws (the pterygomandibular raphe). The second one is
// as wide as a cheek retractor holds the lips. All sizes follow textbook drawings and the usual sizes of retractors.
#include "instruments/mouth/mouth_lining.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "geometry/util/degree.h"
#include "instruments/modelling/blend.h"
#include "instruments/modelling/tube.h"

namespace tactooth {
namespace {

constexpr double kUpperEnd = 0.2, kLowerEnd = 0.3;  // turns: here the jaws end, and the fold between them lies
constexpr int kColumns = 208;                       // of the lofts, around the mouth
constexpr double kBehind = 10;                      // mm: the jaws end behind the last tooth
constexpr double kInnerSide = -75 * kDegree, kOuterSide = 95 * kDegree;  // of the round edge of the lips

/// Column to turn: columns are closest at the midlines, where the frenula are.
double turnOf(int column) {
    constexpr double kCloser = 0.72;
    const double even = static_cast<double>(column % kColumns) / kColumns;
    return even - kCloser * std::sin(4 * std::numbers::pi * even) / (4 * std::numbers::pi);
}

/// The same place on the patient's right.
double rightHalf(double turn) { return turn <= 0.5 ? turn : 1 - turn; }
Vec3 mirrored(Vec3 point, bool isLeft) {
    if (isLeft) point.x() = -point.x();
    return point;
}

/// 1 at the fold between the jaws, 0 from the canines forward.
double cheekShare(double right) { return smoothStep(0.06, 0.22, right) * smoothStep(0.44, 0.28, right); }

SmoothCurve rimCurve(int axis) {
    struct Knot {
        double turn;
        Vec3 place;
    };
    static const std::array<Knot, 9> kRight = {{{0, {0, 13, 15}},
                                                {0.08, {16, 10.5, 13.5}},
                                                {0.16, {29, 0, 5}},
                                                {0.21, {35, -11, -6}},
                                                {0.25, {37.5, -19, -18}},
                                                {0.30, {35, -22.5, -33}},
                                                {0.37, {27, -20.5, -47}},
                                                {0.44, {14, -16, -56.5}},
                                                {0.5, {0, -14, -59}}}};
    const double sign = axis == 0 ? -1 : 1;
    std::vector<SmoothCurve::Point> points = {{-kRight[1].turn, sign * kRight[1].place[axis]}};
    for (const Knot& knot : kRight) points.push_back({knot.turn, knot.place[axis]});
    points.push_back({1 - kRight[7].turn, sign * kRight[7].place[axis]});
    return SmoothCurve(points);
}

Vec3 bezier(const std::array<Vec3, 4>& p, double u) {
    const double v = 1 - u;
    return v * v * v * p[0] + 3 * v * v * u * p[1] + 3 * v * u * u * p[2] + u * u * u * p[3];
}

/// Columns of a loft; all of them: it is closed around the mouth.
struct ColumnRange {
    int first = 0, last = kColumns;
};
constexpr ColumnRange kAllColumns, kRightColumns{0, kColumns / 2}, kLeftColumns{kColumns / 2, kColumns};

/// A surface of columns around the mouth, of `rows` points each.
ZonedMesh loft(const ColumnRange& columns, int rows, bool facesBack,
               const std::function<Vec3(double turn, int row)>& pointAt, const std::function<double(int row)>& zoneAt) {
    ZonedMesh shown;
    const bool isClosed = columns.last - columns.first == kColumns;
    const int points = columns.last - columns.first + (isClosed ? 0 : 1);
    for (int column = columns.first; column < columns.first + points; ++column) {
        const double turn = turnOf(column);
        for (int row = 0; row < rows; ++row) {
            shown.mesh.vertices.push_back(pointAt(turn, row).cast<float>());
            shown.zones.push_back(ZonedMesh::zoneOf(zoneAt(row)));
        }
    }
    const auto at = [&](int column, int row) { return static_cast<std::uint32_t>(column % points * rows + row); };
    for (int column = 0; column < columns.last - columns.first; ++column) {
        for (int row = 0; row + 1 < rows; ++row) {
            std::array<Triangle, 2> pair = {Triangle{at(column, row), at(column, row + 1), at(column + 1, row + 1)},
                                            Triangle{at(column, row), at(column + 1, row + 1), at(column + 1, row)}};
            for (Triangle& triangle : pair) {
                if (facesBack) std::swap(triangle[1], triangle[2]);
                shown.mesh.triangles.push_back(triangle);
            }
        }
    }
    return shown;
}

}  // namespace

MouthLining::MouthLining(const NeckCurve& upper, const NeckCurve& lower, const Pose& lowerJaw)
    : upper_(upper), lower_(lower), lowerJaw_(lowerJaw) {
    const auto y = rimCurve(1), z = rimCurve(2);
    const Vec3 top(0, y(0).value, z(0).value), bottom(0, y(0.5).value, z(0.5).value);
    centre_ = (top + bottom) / 2;
    forward_ = (bottom - top).cross(Vec3::UnitX()).normalized();
    if (forward_.y() < 0) forward_ = -forward_;
}

MouthLining::Root MouthLining::rootAt(double turn) const {
    constexpr double kWithin = 4, kUpperAway = 8, kLowerAway = 7;  // mm from the necks: outward, and to the vestibule
    const double right = rightHalf(turn);
    const auto ofUpper = [&](double s) {
        const NeckCurve::Place place = upper_.at(s);
        return Root{place.neck + kWithin * place.outward + kUpperAway * Vec3::UnitZ(), place.outward, Vec3::UnitZ()};
    };
    const auto ofLower = [&](double s) {
        const NeckCurve::Place place = lower_.at(s);
        const Vec3 down = -Vec3::UnitZ();
        return Root{lowerJaw_ * Vec3(place.neck + kWithin * place.outward + kLowerAway * down),
                    lowerJaw_.rotation * place.outward, lowerJaw_.rotation * down};
    };
    const double upperEnd = upper_.half() + kBehind, lowerEnd = lower_.half() + kBehind;
    Root root;
    if (right < kUpperEnd) {
        root = ofUpper(upperEnd * right / kUpperEnd);
    } else if (right > kLowerEnd) {
        root = ofLower(lowerEnd * (0.5 - right) / (0.5 - kLowerEnd));
    } else {
        const double part = smoothStep(kUpperEnd, kLowerEnd, right);
        const Root a = ofUpper(upperEnd), b = ofLower(lowerEnd);
        root = {isthmusAt(right), (a.outward + part * (b.outward - a.outward)).normalized(),
                (1 - part) * a.away + part * b.away};
    }
    const bool isLeft = turn > 0.5;
    return {mirrored(root.point, isLeft), mirrored(root.outward, isLeft), mirrored(root.away, isLeft)};
}

MouthLining::Rim MouthLining::rimAt(double turn) const {
    static const SmoothCurve x = rimCurve(0), y = rimCurve(1), z = rimCurve(2);
    constexpr double kLip = 4.2, kCorner = 3.2;  // mm: half the thickness
    const double right = rightHalf(turn);
    const Vec3 middle = mirrored(Vec3(x(right).value, y(right).value, z(right).value), turn > 0.5);
    Vec3 aside = middle - centre_;
    aside -= aside.dot(forward_) * forward_;
    return {middle, aside.normalized(), std::lerp(kLip, kCorner, bump(right - 0.25, 0.06))};
}

Vec3 MouthLining::onLip(const Rim& rim, double angle) const {
    return rim.middle + rim.radius * (std::sin(angle) * forward_ - std::cos(angle) * rim.aside);
}

ZonedMesh MouthLining::cheek(bool isLeft) const {
    constexpr int kRows = 24;
    const auto pointAt = [&](double turn, int row) -> Vec3 {
        const Rim rim = rimAt(turn);
        const Root root = rootAt(turn);
        const double right = rightHalf(turn), cheek = cheekShare(right);
        const Vec3 end = onLip(rim, kInnerSide);
        const std::array<Vec3, 4> controls = {
            root.point,
            root.point + std::lerp(8.0, 15.0, cheek) * root.outward + std::lerp(7.0, 2.0, cheek) * root.away,
            end + std::lerp(6.0, 5.0, cheek) * rim.aside - std::lerp(3.0, 16.0, cheek) * forward_, end};
        const double u = static_cast<double>(row) / kRows;
        // The frenula of the lips.
        constexpr double kHigh = 5, kWide = 0.006;  // mm; turns
        const double frenulum =
            bump(std::min(right, 0.5 - right), kWide) * smoothStep(0, 0.3, u) * smoothStep(0.9, 0.4, u);
        return bezier(controls, u) - kHigh * frenulum * root.away;
    };
    return loft(isLeft ? kLeftColumns : kRightColumns, kRows + 1, false, pointAt, [](int) { return 0; });
}

ZonedMesh MouthLining::lips() const {
    constexpr int kRound = 14, kSkin = 10;  // rows
    const auto pointAt = [&](double turn, int row) -> Vec3 {
        const Rim rim = rimAt(turn);
        const double round = std::min(1.0, static_cast<double>(row) / kRound);
        const double skin = std::max(0.0, static_cast<double>(row - kRound) / kSkin);
        // The skin goes on from the edge, and falls back to the cheeks.
        constexpr double kWide = 15, kBack = 5;  // mm
        return onLip(rim, std::lerp(kInnerSide, kOuterSide, round)) + kWide * skin * rim.aside -
               kBack * skin * skin * forward_;
    };
    return loft(kAllColumns, kRound + kSkin + 1, false, pointAt, [](int row) {
        return smoothStep(0.15 * kRound, 0.45 * kRound, row) + smoothStep(kRound - 2, kRound + 0.5, row);
    });
}

Vec3 MouthLining::isthmusAt(double turn) const {
    constexpr double kVault = 12;  // mm: the palate over the necks
    const double right = rightHalf(turn);
    const NeckCurve::Place above = upper_.at(upper_.half()), below = lower_.at(lower_.half());
    const double half = above.neck.x() - 1;
    const Vec3 corner(half, above.neck.y() - 7, above.neck.z() - 1);
    const Vec3 foot = lowerJaw_ * Vec3(below.neck.x() - 3, below.neck.y() - 8, below.neck.z() + 1);
    Vec3 place;
    if (right < kUpperEnd) {
        const double aside = right / kUpperEnd;
        place = Vec3(half * std::sin(aside * std::numbers::pi / 2), above.neck.y() - 6 - aside,
                     corner.z() + kVault * std::pow(std::cos(aside * std::numbers::pi / 2), 1.5));
    } else if (right > kLowerEnd) {
        const double aside = (0.5 - right) / (0.5 - kLowerEnd);
        constexpr double kDeep = 7;  // mm: below the sides of the tongue
        const double low = below.neck.z() + 1 - kDeep * smoothStep(1, 0.8, aside);
        place = lowerJaw_ * Vec3((below.neck.x() - 3) * aside, below.neck.y() - 8, low);
    } else {
        place = corner + (right - kUpperEnd) / (kLowerEnd - kUpperEnd) * (foot - corner);
    }
    return mirrored(place, turn > 0.5);
}

ZonedMesh MouthLining::throat() const {
    constexpr int kToArch = 12, kToWall = 8, kWall = 8;  // rows
    const Vec3 back = Vec3(0, -1, -0.45).normalized();
    const Vec3 middle = (isthmusAt(0) + isthmusAt(0.5)) / 2;
    const auto pointAt = [&](double turn, int row) -> Vec3 {
        constexpr double kArch = 15, kDepth = 30;           // mm behind the mouth: the arch of the palate, the wall
        constexpr double kArchWidth = 0.62, kWidth = 0.85;  // as shares of the mouth's width
        const Vec3 from = isthmusAt(turn) - middle;
        const double toArch = std::min(1.0, static_cast<double>(row) / kToArch);
        const double toWall = std::clamp(static_cast<double>(row - kToArch) / kToWall, 0.0, 1.0);
        const double onWall = std::max(0.0, static_cast<double>(row - kToArch - kToWall) / kWall);
        double width = std::lerp(1.0, kArchWidth, smoothStep(0, 1, toArch));
        width = std::lerp(width, kWidth, smoothStep(0, 1, toWall)) * (1 - onWall);
        const double deep = kArch * toArch + (kDepth - kArch) * toWall;
        constexpr double kUvula = 8, kHalf = 4;  // mm
        const double aside = from.x() * width / kHalf;
        const double uvula = from.z() > 0 ? kUvula * std::exp(-std::pow(aside, 4)) * bump(row - kToArch, 2.5) : 0;
        return middle + width * from + deep * back - uvula * Vec3::UnitZ();
    };
    return loft(kAllColumns, kToArch + kToWall + kWall + 1, true, pointAt, [](int row) {
        return smoothStep(kToArch - 3, kToArch + 2, row) + smoothStep(kToArch, kToArch + kToWall, row);
    });
}

ZonedMesh MouthLining::retractor() const {
    constexpr double kThick = 1.3, kPlace = -48 * kDegree;  // mm: radius; on the inner side of the lips
    constexpr int kPoints = 120, kSides = 12;
    std::vector<TubePoint> ring;
    for (int i = 0; i <= kPoints; ++i) {
        Rim rim = rimAt(static_cast<double>(i % kPoints) / kPoints);
        rim.radius += 0.6 * kThick;
        ring.push_back({onLip(rim, kPlace), kThick});
    }
    ZonedMesh shown{tube(ring, kSides), {}};
    shown.zones.assign(shown.mesh.vertices.size(), 0);
    return shown;
}

}  // namespace tactooth
