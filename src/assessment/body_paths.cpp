// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/body_paths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kPitch = 0.2;     // mm between two columns
constexpr double kLayer = 0.75;    // of a bur's head: how far apart two depths are
constexpr double kMargin = 0.1;    // mm that the bur goes beyond the body: no column is narrower than its pitch
constexpr double kLedge = 1.2;     // mm: a lower ledge over a flat floor is cut, too, so that the walls are even
constexpr double kSkin = 1e-3;     // mm below a surface: there a ray does not meet it again
constexpr double kNowhere = -1e9;  // mm: the height of a column beside the body

/// A body as columns along the direction of the shaft: for each column, how deep the tip goes.
class BodyColumns {
public:
    /// `outer`: of the uncut tooth.
    BodyColumns(const PreparationPlan& plan, const std::shared_ptr<const SurfacePart>& body, const SurfacePart& outer)
        : outward_(plan.outward), u_(plan.outward.unitOrthogonal()), v_(plan.outward.cross(u_)) {
        const Surface surface{.base = body};
        const std::optional<Vec2> open = plan.body->openTo ? std::optional(inPlane(*plan.body->openTo)) : std::nullopt;
        double top = kNowhere;
        Eigen::AlignedBox2d box;
        for (const Vec3f& vertex : body->mesh().vertices) {
            const Vec3 place = vertex.cast<double>();
            box.extend(inPlane(place));
            top = std::max(top, outward_.dot(place));
        }
        if (open) extendTo(*open, outer, plan.body->burRadius, box);
        const double floor = plan.body->below ? top - *plan.body->below : kNowhere;
        corner_ = box.min() - Vec2::Constant(kPitch);
        columns_ = static_cast<int>(std::ceil(box.sizes().x() / kPitch)) + 3;
        rows_ = static_cast<int>(std::ceil(box.sizes().y() / kPitch)) + 3;
        tips_.assign(static_cast<std::size_t>(columns_ * rows_), kNowhere);
        for (int j = 0; j < rows_; ++j) {
            for (int i = 0; i < columns_; ++i) {
                const Vec3 place = placeAt(i, j, 0);
                const auto above = firstHit(surface, {place + kFarAway * outward_, -outward_});
                if (!above || kFarAway - *above < floor) continue;
                const double roof = kFarAway - *above;
                const auto inside = firstHit(surface, {placeAt(i, j, roof - kSkin), -outward_});
                const double bottom = inside ? roof - kSkin - *inside : roof;
                tips_[at(i, j)] = bottom < floor + kLedge ? (plan.body->below ? floor : bottom) : bottom;
            }
        }
        if (open) openTo(*open);
        narrow(plan.body->burRadius - kMargin);
        if (open) leaveOutBeside(outer);
        if (plan.body->role == MaterialRole::Pulp) fillHollows(floor);
    }

    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] int columns() const { return columns_; }
    /// Height of the tip along the shaft, mm; nothing where the bur does not go.
    [[nodiscard]] std::optional<double> tipAt(int i, int j) const {
        const double tip = tips_[at(i, j)];
        return tip > kNowhere ? std::optional(tip) : std::nullopt;
    }
    [[nodiscard]] Vec3 placeAt(int i, int j, double height) const {
        return (corner_.x() + kPitch * i) * u_ + (corner_.y() + kPitch * j) * v_ + height * outward_;
    }

private:
    [[nodiscard]] std::size_t at(int i, int j) const { return static_cast<std::size_t>(j * columns_ + i); }
    /// The place in the plane square to the shaft; for a direction: its part in that plane.
    [[nodiscard]] Vec2 inPlane(const Vec3& place) const { return {u_.dot(place), v_.dot(place)}; }

    /// Makes the box reach past the tooth toward the open side, as far as a bur that has left it.
    void extendTo(const Vec2& open, const SurfacePart& outer, double burRadius, Eigen::AlignedBox2d& box) const {
        const Vec2 direction = open.normalized();
        double farthest = kNowhere;
        for (const Vec3f& vertex : outer.mesh().vertices)
            farthest = std::max(farthest, direction.dot(inPlane(vertex.cast<double>())));
        const double beyond = farthest + burRadius + kPitch - direction.dot(box.center());
        box.extend(Eigen::AlignedBox2d(box).translate(std::max(0.0, beyond) * direction));
    }

    /// Lets each column go as deep as those before it on the way to the open side, so that nothing of the tooth stays
    /// between the body and its outside.
    void openTo(const Vec2& open) {
        const Vec2 step = open.normalized() / 2;  // of a column
        const std::vector<double> all = tips_;
        for (int j = 0; j < rows_; ++j) {
            for (int i = 0; i < columns_; ++i) {
                double lowest = -kNowhere;
                Vec2 place(i, j);
                for (; isIn(place); place -= step) {
                    const double tip =
                        all[at(static_cast<int>(std::lround(place.x())), static_cast<int>(std::lround(place.y())))];
                    if (tip > kNowhere) lowest = std::min(lowest, tip);
                }
                if (lowest < -kNowhere) tips_[at(i, j)] = lowest;
            }
        }
    }

    [[nodiscard]] bool isIn(const Vec2& column) const {
        constexpr double kHalf = 0.49;  // what is nearer than half a column rounds to it
        return column.minCoeff() > -kHalf && column.x() < columns_ - 1 + kHalf && column.y() < rows_ - 1 + kHalf;
    }

    /// Leaves out the columns over whose tip there is no tooth: the bur comes as far as the border of the tooth.
    void leaveOutBeside(const SurfacePart& outer) {
        const Surface surface{.base = std::shared_ptr<const SurfacePart>(std::shared_ptr<void>(), &outer)};
        for (int j = 0; j < rows_; ++j) {
            for (int i = 0; i < columns_; ++i) {
                double& tip = tips_[at(i, j)];
                if (tip <= kNowhere) continue;
                const auto above = firstHit(surface, {placeAt(i, j, 0) + kFarAway * outward_, -outward_});
                if (!above || kFarAway - *above < tip) tip = kNowhere;
            }
        }
    }

    /// The outline of an access is convex: the horns of the pulp are its corners.
    void fillHollows(double floor) {
        using Column = std::array<int, 2>;
        std::vector<Column> kept;  // by i, then by j
        for (int i = 0; i < columns_; ++i) {
            for (int j = 0; j < rows_; ++j) {
                if (tips_[at(i, j)] > kNowhere) kept.push_back({i, j});
            }
        }
        const auto turn = [](const Column& a, const Column& b, const Column& c) {
            return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        };
        // A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information Processing
        // Letters 9 (1979).
        std::vector<Column> hull;
        for (int pass = 0; pass < 2; ++pass) {
            const std::size_t start = hull.size();
            for (const Column& column : kept) {
                while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), column) <= 0)
                    hull.pop_back();
                hull.push_back(column);
            }
            if (!hull.empty()) hull.pop_back();
            std::ranges::reverse(kept);
        }
        for (int i = 0; i < columns_ && hull.size() > 2; ++i) {
            for (int j = 0; j < rows_; ++j) {
                bool isInside = true;
                for (std::size_t k = 0; k < hull.size(); ++k)
                    isInside = isInside && turn(hull[k], hull[(k + 1) % hull.size()], {i, j}) >= 0;
                if (isInside && tips_[at(i, j)] <= kNowhere) tips_[at(i, j)] = floor;
            }
        }
    }

    /// Leaves the columns at least `margin` inside the outline, so that the bur stays in it.
    void narrow(double margin) {
        const std::vector<double> all = tips_;
        const int reach = static_cast<int>(std::floor(margin / kPitch));
        for (int j = 0; j < rows_; ++j) {
            for (int i = 0; i < columns_; ++i) {
                for (int y = j - reach; y <= j + reach; ++y) {
                    for (int x = i - reach; x <= i + reach; ++x) {
                        if (kPitch * std::hypot(x - i, y - j) > margin) continue;
                        const bool isInside = x >= 0 && y >= 0 && x < columns_ && y < rows_ && all[at(x, y)] > kNowhere;
                        if (!isInside) tips_[at(i, j)] = kNowhere;
                    }
                }
            }
        }
    }

    Vec3 outward_, u_, v_;
    Vec2 corner_;
    int columns_ = 0, rows_ = 0;
    std::vector<double> tips_;
};

/// A filling has no role of its own, as its material may be any.
std::shared_ptr<const SurfacePart> bodyOf(const LayeredTooth& tooth, MaterialRole role) {
    const Box3 own = tooth.ownBox();
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        const bool isOwn = own.contains(layer.part->tree().box().center());  // not of a tooth beside
        if (isOwn && tooth.materials().hasRole(layer.material, role)) return layer.part;
    }
    return nullptr;
}

}  // namespace

std::vector<BurPath> throughBody(const PreparationPlan& plan, const LayeredTooth& tooth, const SurfacePart& outer) {
    const std::shared_ptr<const SurfacePart> body = bodyOf(tooth, plan.body->role);
    if (body == nullptr) return {};
    const BodyColumns columns(plan, body, outer);
    double top = kNowhere, bottom = -kNowhere;
    for (const Vec3f& vertex : outer.mesh().vertices) {
        top = std::max(top, plan.outward.dot(vertex.cast<double>()));
    }
    for (int j = 0; j < columns.rows(); ++j) {
        for (int i = 0; i < columns.columns(); ++i) bottom = std::min(bottom, columns.tipAt(i, j).value_or(bottom));
    }
    std::vector<BurPath> paths;
    const double layer = kLayer * plan.body->burLength;
    for (double level = top; level > bottom; level -= layer) {
        const double lowest = std::max(bottom, level - layer);
        for (int j = 0; j < columns.rows(); ++j) {
            BurPath path;
            for (int i = 0; i < columns.columns(); ++i) {
                const auto tip = columns.tipAt(i, j);
                if (tip && *tip < level) path.places.push_back(columns.placeAt(i, j, std::max(*tip, lowest)));
                const bool isEnd = !tip || *tip >= level || i + 1 == columns.columns();
                if (!isEnd || path.places.empty()) continue;
                if (j % 2 == 1) std::ranges::reverse(path.places);  // from row to row without lifting the bur
                paths.push_back(std::exchange(path, {}));
            }
        }
    }
    return paths;
}

}  // namespace tactooth
