// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/contact_query.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "collision/bvh/closest_point.h"
#include "collision/narrow/gjk.h"
#include "collision/narrow/triangle_penetration.h"
#include "geometry/util/assert.h"
#include "geometry/util/pose.h"

// Penetration depth as the least translation to a free pose: S. Cameron, R. K. Culley, "Determining the Minimum
// Translational Distance Between Two Convex Polyhedra", IEEE ICRA 1986. Differs from the paper: a tooth is not convex,
// so the least translation is found by local descent. The tool is pulled out along several candidate directions, swept
// back to first contact and slid to the nearest free pose. The shortest exit wins, and is verified.

namespace tactooth {
namespace {

constexpr std::size_t kFirstCapacity = 4096;
constexpr std::size_t kFirstQuery = 64;  // clusters: if a tool is in the tooth, one of so many nearly always intersects
constexpr int kMaxMoves = 64;            // moves of a few iterations each, until a pulled-out tool has settled
constexpr std::size_t kMaxNormals = 6;
constexpr double kClearance =
    4e-5;  // of the tool's radius (0.12 um for a 6 mm bur): a free tool is still free so much further
constexpr double kSameDirection = 0.97;  // cosine of 14 degrees: more similar candidates end in the same place

/// Adds `direction` as a unit vector, unless a similar one is there already.
void addDirection(std::vector<Vec3>& directions, const Vec3& direction, std::size_t limit) {
    const double length = direction.norm();
    if (!(length > 0) || directions.size() >= limit) return;
    const Vec3 unit = direction / length;
    for (const Vec3& other : directions) {
        if (unit.dot(other) > kSameDirection) return;
    }
    directions.push_back(unit);
}

/// The 26 directions from the centre of a cube to its corners, edges and faces.
const std::array<Vec3, 26> kAroundACube = [] {
    std::array<Vec3, 26> directions;
    for (int i = 0; i < 26; ++i) {
        const int cell = i < 13 ? i : i + 1;  // number 13 is the centre itself
        directions[i] = Vec3(cell % 3 - 1, cell / 3 % 3 - 1, cell / 9 - 1).normalized();
    }
    return directions;
}();

bool intersects(const Surface& surface, const ToolShape& tool, const Pose& toolInTooth, const NearPair& pair) {
    const Triangle3 tooth = cornersOf(partOf(surface, pair.part).mesh(), pair.tooth);
    const Triangle3 moved = tool.cornersAt(toolInTooth, pair.tool);
    return !distanceBetween(tooth, moved, moved[0] - tooth[0]).separated;
}

}  // namespace

ContactQuery::ContactQuery(std::shared_ptr<const ToolShape> tool, std::shared_ptr<const Surface> surface)
    : tool_(std::move(tool)), surface_(std::move(surface)), proxy_(tool_), list_(*tool_, kFirstCapacity) {
    TACTOOTH_ASSERT(surface_ != nullptr && surface_->base != nullptr);
    proxy_.setSurface(surface_);
    overlap_.pairs.reserve(kFirstCapacity);
}

std::shared_ptr<const Surface> ContactQuery::setSurface(std::shared_ptr<const Surface> surface) {
    TACTOOTH_ASSERT(surface != nullptr && surface->base != nullptr);
    surface_ = std::move(surface);
    blocking_.clear();
    return proxy_.setSurface(surface_);
}

/// Calls `take` with each listed pair that intersects at this pose, until it returns false.
template <class Take>
void ContactQuery::forEachIntersecting(const Pose& toolInTooth, Take&& take) {
    const ToolMotion still = list_.motion(toolInTooth, toolInTooth, 0, {});
    for (std::size_t cluster = 0; cluster < list_.clusters(); ++cluster) {
        for (std::uint32_t uncertain = list_.uncertainPairs(cluster, still); uncertain != 0;
             uncertain &= uncertain - 1) {
            const NearPair pair = list_[NeighbourList::placeOf(cluster, std::countr_zero(uncertain))];
            if (intersects(*surface_, *tool_, toolInTooth, pair) && !take(pair)) return;
        }
    }
}

/// Whether a tool that crosses no triangle is wholly inside.
bool ContactQuery::isEnclosed(const Pose& toolInTooth) const {
    return surface_->closed && contains(*surface_, toolInTooth * tool_->mesh().corner(0, 0));
}

void ContactQuery::findOverlap(const Pose& toolInTooth) {
    overlap_.pairs.clear();
    list_.buildAll(*surface_, toolInTooth, {});
    forEachIntersecting(toolInTooth, [&](const NearPair& pair) {
        overlap_.pairs.push_back(pair);
        return true;
    });
    overlap_.enclosed = overlap_.pairs.empty() && isEnclosed(toolInTooth);
}

Contact ContactQuery::deepestPairAt(const Pose& toolInTooth) {
    Contact result;
    if (surface_->base->tree().empty() || tool_->mesh().empty()) return result;
    findOverlap(toolInTooth);
    result.contacts = static_cast<int>(overlap_.pairs.size());
    result.touching = result.contacts > 0;
    for (const NearPair& pair : overlap_.pairs) {
        const Triangle3 tooth = cornersOf(partOf(*surface_, pair.part).mesh(), pair.tooth);
        const Triangle3 tool = tool_->cornersAt(toolInTooth, pair.tool);
        const TrianglePenetration penetration = penetrationOf(tooth, tool);
        if (!std::isfinite(penetration.depth) || penetration.depth <= result.depth) continue;
        result.depth = penetration.depth;
        result.normal = penetration.normal;
        result.point = *std::min_element(tool.begin(), tool.end(), [&](const Vec3& p, const Vec3& q) {
            return p.dot(result.normal) < q.dot(result.normal);
        });
        result.part = pair.part;
        result.tooth = pair.tooth;
    }
    return result;
}

/// Tests the pairs that blocked the tool recently, then more and more of the pairs that are near. One pair that
/// intersects is enough.
bool ContactQuery::isFree(const Pose& toolInTooth) {
    for (std::size_t i = 0; i < blocking_.size(); ++i) {
        if (intersects(*surface_, *tool_, toolInTooth, blocking_[i])) return false;
    }
    bool complete = false;
    for (std::size_t limit = kFirstQuery; !complete; limit *= 8) {
        complete = list_.buildUpTo(*surface_, toolInTooth, limit);
        bool free = true;
        forEachIntersecting(toolInTooth, [&](const NearPair& pair) {
            blocking_.add(pair);
            return free = false;
        });
        if (!free) return false;
    }
    return !isEnclosed(toolInTooth);
}

/// Directions to try: the mean normal of the touched triangles, from the tool's centre to the nearest point of the
/// surface, single normals that differ, and back along the shaft (so a bur leaves a narrow cavity).
std::vector<Vec3> ContactQuery::exitDirections(const Pose& toolInTooth, const Overlap& overlap) const {
    std::vector<Vec3> directions;
    Vec3 mean = Vec3::Zero();
    for (const NearPair& pair : overlap.pairs) mean += partOf(*surface_, pair.part).mesh().areaVector(pair.tooth);
    addDirection(directions, mean, 1);
    const Vec3 centre = toolInTooth * tool_->centre();
    if (const auto nearest = closestPoint(*surface_->base, centre)) {
        const bool inside = surface_->closed && contains(*surface_, centre);
        addDirection(directions, inside ? Vec3(nearest->point - centre) : Vec3(centre - nearest->point), 2);
    }
    for (const NearPair& pair : overlap.pairs) {
        addDirection(directions, partOf(*surface_, pair.part).mesh().areaVector(pair.tooth), kMaxNormals);
    }
    addDirection(directions, toolInTooth.rotation * Vec3::UnitZ(), kMaxNormals + 1);
    return directions;
}

/// About how far the tool must be pulled along `direction` to be free, mm. None if that is beyond `limit`.
std::optional<double> ContactQuery::exitDistance(const Pose& toolInTooth, const Vec3& direction, double limit) {
    constexpr double kStretch = 1.6;  // of a step over the one before
    constexpr int kHalvings = 5;      // of the last step: a long path back to the tooth takes longer than a few tests
    TACTOOTH_ASSERT(isUnit(direction));
    TACTOOTH_ASSERT(limit >= 0);
    const auto freeAt = [&](double distance) {
        return isFree({toolInTooth.position + distance * direction, toolInTooth.rotation});
    };
    for (double distance = 0.01 * tool_->radius(); distance < limit; distance *= kStretch) {
        if (!freeAt(distance)) continue;
        double blocked = distance / kStretch;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = (distance + blocked) / 2;
            (freeAt(middle) ? distance : blocked) = middle;
        }
        return distance;
    }
    return std::nullopt;
}

/// Moves the tool back from where it is free along each exit direction, the shortest exit first. An exit much longer
/// than the best depth is not tried.
void ContactQuery::tryExitDirections(const Pose& toolInTooth, Contact& best) {
    constexpr double kNoProgress = 2;  // times the best depth
    constexpr double kWorthExit = 4;   // times the shortest pull
    struct Exit {
        double distance;
        Vec3 direction;
    };
    std::vector<Exit> exits;
    double limit = 2 * (surface_->base->tree().box().diagonal().norm() + 2 * tool_->radius());
    for (const Vec3& direction : exitDirections(toolInTooth, overlap_)) {
        const std::optional<double> distance = exitDistance(toolInTooth, direction, limit);
        if (!distance) continue;
        exits.push_back({*distance, direction});
        limit = std::min(limit, kWorthExit * *distance);
    }
    std::ranges::stable_sort(exits, {}, &Exit::distance);
    for (const auto& [distance, direction] : exits) {
        if (best.depth > 0 && distance > kNoProgress * best.depth) return;
        keepShallowerExit(toolInTooth, {toolInTooth.position + distance * direction, toolInTooth.rotation}, best);
    }
}

/// Moves the tool from a free pose toward the query pose. Keeps where it settles as the best exit, if it is shallower.
void ContactQuery::keepShallowerExit(const Pose& toolInTooth, const Pose& start, Contact& best) {
    constexpr double kApproachShare =
        0.03;  // of the path: once the tool touches, it expects a short displacement and builds short lists
    proxy_.placeAt(start);
    MoveResult move =
        proxy_.moveToward({start.position + kApproachShare * (toolInTooth.position - start.position), start.rotation});
    for (int i = 0; i < kMaxMoves; ++i) {
        move = proxy_.moveToward(toolInTooth);
        if (move.status != MoveStatus::OutOfIterations) break;
    }
    const Vec3 out = proxy_.pose().position - toolInTooth.position;
    const double depth = out.norm();
    if (move.contactCount == 0 || !(depth > 0) || (best.depth > 0 && depth >= best.depth)) return;
    const auto strongest =
        std::max_element(move.contacts.begin(), move.contacts.begin() + move.contactCount,
                         [](const ProxyContact& a, const ProxyContact& b) { return a.multiplier < b.multiplier; });
    best.depth = depth;
    best.normal = out / depth;
    TACTOOTH_ASSERT(isUnit(best.normal));
    best.point = strongest->point - out;
    best.part = strongest->part;
    best.tooth = strongest->tooth;
    freePose_ = proxy_.pose();
    normalSum_.setZero();
    for (int i = 0; i < move.contactCount; ++i) normalSum_ += move.contacts[i].normal;
}

/// Whether the tool is free at this distance, and also a little further.
bool ContactQuery::leaves(const Pose& toolInTooth, const Vec3& direction, double distance) {
    const double further = distance + kClearance * tool_->radius();
    return isFree({toolInTooth.position + distance * direction, toolInTooth.rotation}) &&
           isFree({toolInTooth.position + further * direction, toolInTooth.rotation});
}

/// The distance at which the tool, free at distance `clear`, first touches when it moves back along `direction`, mm.
double ContactQuery::leastAlong(const Pose& toolInTooth, const Vec3& direction, double clear) {
    TACTOOTH_ASSERT(isUnit(direction) && clear > 0);
    const double little = kClearance * tool_->radius();
    const auto freeAt = [&](double distance) {
        return isFree({toolInTooth.position + distance * direction, toolInTooth.rotation});
    };
    double blocked = clear - little;
    for (double stride = little; blocked > 0 && freeAt(blocked); stride *= 1.3) clear = blocked, blocked -= stride;
    blocked = std::max(blocked, 0.0);
    while (clear - blocked > 1e-3 * little) {
        const double middle = (clear + blocked) / 2;
        (freeAt(middle) ? clear : blocked) = middle;
    }
    return clear;
}

/// Whether the tool gets free along `out` and stays free a little further. Then the shortest translation along it
/// becomes the best exit.
bool ContactQuery::tryExit(const Pose& toolInTooth, const Vec3& out, Contact& best) {
    TACTOOTH_ASSERT(out.norm() > 0);
    const Vec3 direction = out.normalized();
    double distance = out.norm();
    if (!leaves(toolInTooth, direction, distance)) return false;
    distance = leastAlong(toolInTooth, direction, distance);
    if (!leaves(toolInTooth, direction, distance)) return false;
    best.depth = distance;
    best.normal = direction;
    // A little further out than the depth, so that the free pose has a gap to spare.
    freePose_.position = toolInTooth.position + (distance + kClearance * tool_->radius()) * direction;
    return true;
}

/// Corrects an exit that runs into a wall. In a narrow fissure the nearest free pose may lie against a wall: the tool
/// is free there, but not a little further. Then the exit is bent by the least amount that frees the tool: away from
/// the contacts that hold it, or else to any side.
void ContactQuery::refineDirection(const Pose& toolInTooth, Contact& best) {
    const Vec3 out = best.depth * best.normal;
    if (tryExit(toolInTooth, out, best)) return;
    for (double bend = 2 * kClearance * tool_->radius(); bend < 2 * best.depth; bend *= 2) {
        if (tryExit(toolInTooth, out + bend * normalSum_, best)) return;
        for (const Vec3& side : kAroundACube) {
            if (tryExit(toolInTooth, out + bend * (toolInTooth.rotation * side), best)) return;
        }
    }
}

/// Searches all directions for a shorter exit: between two cusps, the normals of the touched triangles need not show
/// it.
void ContactQuery::searchAround(const Pose& toolInTooth, Contact& best) {
    constexpr double kWorthwhile = 0.97;  // of the depth: the descent finds smaller gains
    for (const Vec3& direction : kAroundACube) {
        const Vec3 out = kWorthwhile * best.depth * (toolInTooth.rotation * direction);
        const Pose start{toolInTooth.position + out, toolInTooth.rotation};
        if (isFree(start)) keepShallowerExit(toolInTooth, start, best);
    }
}

/// Searches for a shorter exit close beside the one found. Each facet of a rounded tool on a ridge or a corner has an
/// exit of its own, and these differ by little.
void ContactQuery::searchBeside(const Pose& toolInTooth, Contact& best) {
    constexpr double kOutside = 1.01;  // of the depth: where the tool is likely to be free
    constexpr double kSamePlace = 1e-3;
    constexpr double kNoGain = 1e-6;
    constexpr int kSides = 8;
    for (int iteration = 0; iteration < 3; ++iteration) {
        const Contact found = best;
        const Vec3 aside = found.normal.unitOrthogonal();
        for (int side = 0; side < kSides; ++side) {
            // rad: from the second facet beside to within the facet itself. If one tilt leads back to the same exit, so
            // do all smaller ones.
            for (const double tilt : {0.5, 0.3, 0.15, 0.05}) {
                const Eigen::AngleAxisd around(2 * std::numbers::pi * (side + tilt) / kSides, found.normal);
                const Vec3 out = kOutside * found.depth * (found.normal + tilt * (around * aside)).normalized();
                const Pose start{toolInTooth.position + out, toolInTooth.rotation};
                if (!isFree(start)) continue;
                keepShallowerExit(toolInTooth, start, best);
                if ((proxy_.pose().position - freePose_.position).norm() < kSamePlace * best.depth) break;
            }
        }
        if (best.depth >= (1 - kNoGain) * found.depth) return;
    }
}

Contact ContactQuery::at(const Pose& toolInTooth) {
    Contact result;
    if (surface_->base->tree().empty() || tool_->mesh().empty()) return result;
    findOverlap(toolInTooth);
    if (!overlap_.any()) return result;
    result.touching = true;
    result.contacts = static_cast<int>(overlap_.pairs.size());
    proxy_.forget();  // the result shall depend on this pose alone
    tryExitDirections(toolInTooth, result);
    if (result.depth > 0) {
        searchAround(toolInTooth, result);
        searchBeside(toolInTooth, result);
        refineDirection(toolInTooth, result);
    }
    return result;
}

}  // namespace tactooth
