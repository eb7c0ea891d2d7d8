// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/exercise.h"

#include <algorithm>
#include <string>

#include "assessment/crown/crown_form.h"
#include "assessment/ideal_shape.h"
#include "assessment/messages.h"
#include "assessment/outline/outline_paths.h"
#include "collision/bvh/closest_point.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/messages.h"
#include "geometry/util/number_text.h"
#include "geometry/util/pose.h"
#include "instruments/bur_shape.h"
#include "session/cases/custom_bur.h"
#include "session/cases/loaded_tooth.h"
#include "session/simulation/cut_model.h"
#include "session/simulation/session_voxel.h"
#include "session/simulation/tooth_cache.h"

namespace tactooth {
namespace {

constexpr double kVoxel = kSessionVoxel;
constexpr double kClear = 20.0;    // mm: start of the bur above the tooth
constexpr double kNextPath = 1.0;  // mm: to a path that begins so near, the bur goes without leaving the tooth
constexpr double kNear = 1e-4;     // mm: distance at which the surface is reached
constexpr int kMaxSteps = 10000;   // toward the surface: only a line along the surface needs as many

/// Height of the surface over `place` along `outward`, by sphere tracing (J. C. Hart, "Sphere tracing", The Visual
/// Computer 12, 1996); nothing where the line misses it.
std::optional<double> heightOf(const SurfacePart& outer, const Vec3& place, const Vec3& outward) {
    const Box3 box = outer.tree().box();
    const double middle = outward.dot(box.center() - place);
    const double reach = box.diagonal().norm() / 2;
    double height = middle + reach;
    for (int i = 0; i < kMaxSteps && height > middle - reach; ++i) {
        const double distance = closestPoint(outer, place + height * outward)->distance;
        if (distance < kNear) return height;
        height -= distance;
    }
    return std::nullopt;
}

/// Mean height of the surface over the places of a stroke.
double meanOf(const std::vector<double>& heights) {
    double sum = 0;
    for (const double height : heights) sum += height;
    return sum / static_cast<double>(heights.size());
}

/// Heights of the surface along `outward` at these places; nothing if one of them misses it.
std::optional<std::vector<double>> heightsAt(const std::vector<Vec3>& places, const SurfacePart& outer,
                                             const Vec3& outward) {
    std::vector<double> heights;
    for (const Vec3& place : places) {
        const auto above = heightOf(outer, place, outward);
        if (!above) return std::nullopt;
        heights.push_back(*above + outward.dot(place));
    }
    return heights;
}

const MessageText& noPathsIn(const PreparationPlan& plan) {
    if (plan.outline) return msg::kNoRoomInOutline;
    return plan.body ? msg::kNoSuchBody : msg::kNoFissureFound;
}

Expected<CuttingTool> burOf(const Exercise& exercise) {
    if (const auto* file = std::get_if<std::filesystem::path>(&exercise.bur)) {
        const Expected<CustomBur> own = readCustomBur(*file);
        if (!own) return Unexpected{own.error()};
        return makeCuttingTool(own->surface);
    }
    const std::string& number = std::get<std::string>(exercise.bur);
    const std::optional<BurSpec> bur = findBur(number);
    if (!bur) return unexpected(msg::kBurNotInCatalogue, quotedWord(number));
    return makeCuttingTool(makeBur(*bur).surface);
}

/// A crown preparation needs no paths: it is the region that the form describes, with the bur's end in its angles.
Expected<TriangleMesh> crownShape(const PreparationPlan& plan, std::shared_ptr<const LayeredTooth> tooth) {
    const std::shared_ptr<const SurfacePart> outer = tooth->ownOuter();
    const Expected<CrownForm> form = CrownForm::make(plan, *tooth, outer);
    if (!form) return Unexpected{form.error()};
    CutModel piece(std::move(tooth), kVoxel);
    piece.adopt(cutFieldsOf(*form, *outer, piece.volume().lattice()), {});
    return asReadFromFile(*piece.surface());
}

std::size_t placesIn(const std::vector<BurPath>& paths) {
    std::size_t places = 0;
    for (const BurPath& path : paths) places += path.places.size();
    return places;
}

Expected<TriangleMesh> cutShape(const PreparationPlan& plan, const CuttingTool& tool,
                                std::shared_ptr<const LayeredTooth> tooth, const IdealProgress& progress) {
    const Quat grip = shortestRotation(Vec3::UnitZ(), plan.outward);
    const auto paths = tipPaths(plan, *tooth);
    if (!paths) return Unexpected{paths.error()};
    CutModel piece(std::move(tooth), kVoxel);
    const auto all = static_cast<double>(placesIn(*paths));
    std::size_t cut = 0;
    Pose before{kClear * plan.outward, grip};
    for (const auto& [path, depth, lifts] : *paths) {
        // A pear that is lifted leaves a hole wider than its groove.
        const bool goesOn = !lifts && (path.front() - before.position).norm() < kNextPath;
        if (!goesOn) before.position = path.front() + kClear * plan.outward;
        for (const Vec3& tip : path) {
            const bool goesOnCutting = !progress || progress(static_cast<double>(cut++) / all);
            if (!goesOnCutting) return TriangleMesh();
            const Pose next{tip, grip};
            piece.sweep(tool, before, next);
            before = next;
        }
    }
    piece.refreshSurface();
    return asReadFromFile(*piece.surface());
}

}  // namespace

Expected<std::vector<BurPath>> tipPaths(const PreparationPlan& plan, const LayeredTooth& tooth) {
    const std::shared_ptr<const SurfacePart> outer = tooth.ownOuter();
    double floor = 0;
    std::vector<BurPath> planned = burPaths(plan, tooth, outer);
    if (planned.empty()) return unexpected(noPathsIn(plan));
    for (std::size_t number = 0; number < planned.size(); ++number) {
        BurPath& one = planned[number];
        std::vector<Vec3>& path = one.places;
        if (!one.depth) continue;
        std::vector<double> heights;
        const bool needsHeights = !plan.fissure || number == 0;  // a box goes past the outside of the tooth
        if (needsHeights) {
            auto found = heightsAt(path, *outer, plan.outward);
            if (!found) return unexpected(msg::kStrokePastTooth, number + 1);
            heights = std::move(*found);
        }
        if (number == 0) floor = meanOf(heights);
        for (std::size_t i = 0; i < path.size(); ++i) {
            const double height = (plan.isFlat ? floor : heights[i]) - *one.depth;
            path[i] += (height - plan.outward.dot(path[i])) * plan.outward;
        }
    }
    return planned;
}

std::optional<Vec3> floorReference(const PreparationPlan& plan, const LayeredTooth& tooth) {
    const std::shared_ptr<const SurfacePart> outer = tooth.ownOuter();
    if (plan.outline) return outlineReference(plan, *outer);
    const std::vector<BurPath> paths = burPaths(plan, tooth, outer);
    if (paths.empty() || !paths.front().depth) return std::nullopt;
    const std::vector<Vec3>& places = paths.front().places;
    const auto heights = heightsAt(places, *outer, plan.outward);
    if (!heights) return std::nullopt;
    return places.front() + (meanOf(*heights) - plan.outward.dot(places.front())) * plan.outward;
}

Expected<std::shared_ptr<const LayeredTooth>> exerciseTooth(const Exercise& exercise) {
    if (const auto* source = std::get_if<ToothSource>(&exercise.tooth)) {
        const Expected<LoadedModel> work = loadModelOrCase(*source, {}, std::nullopt, kVoxel);
        if (!work) return Unexpected{work.error()};
        return work->piece->volume().tooth();
    }
    const ToothRequest& request = std::get<ToothRequest>(exercise.tooth);
    Expected<LayeredTooth> tooth = layeredTooth(ToothCache(defaultCacheFolder()).make(request));
    if (!tooth) return Unexpected{tooth.error()};
    return std::make_shared<const LayeredTooth>(std::move(*tooth));
}

std::optional<ToothInMouth> exerciseMouth(const Exercise& exercise) {
    const auto* request = std::get_if<ToothRequest>(&exercise.tooth);
    if (request == nullptr || !exercise.inMouth) return std::nullopt;
    const MouthRequest mouth{.triangles = request->triangles, .seed = 0, .jaw = JawPose::Open, .missing = {}};
    Expected<ToothInMouth> made = toothInMouth(request->fdi, std::nullopt, mouth, ToothCache(defaultCacheFolder()));
    if (!made) return std::nullopt;
    return std::move(*made);
}

std::vector<std::shared_ptr<const SurfacePart>> exerciseGums(const Exercise& exercise) {
    std::vector<std::shared_ptr<const SurfacePart>> gums;
    const std::optional<ToothInMouth> made = exerciseMouth(exercise);
    if (!made) return gums;
    for (const ToothInMouth::Body& body : made->around) {
        if (body.isGingiva && !body.isOpposite) gums.push_back(body.part);
    }
    return gums;
}

Expected<TriangleMesh> idealShape(const Exercise& exercise, std::shared_ptr<const LayeredTooth> tooth,
                                  const IdealProgress& progress) {
    if (const auto* file = std::get_if<std::filesystem::path>(&exercise.ideal)) return loadIdealShape(*file);
    const Expected<CuttingTool> tool = burOf(exercise);
    if (!tool) return Unexpected{tool.error()};
    const auto& plan = std::get<PreparationPlan>(exercise.ideal);
    Expected<TriangleMesh> ideal =
        plan.crown ? crownShape(plan, std::move(tooth)) : cutShape(plan, *tool, std::move(tooth), progress);
    if (!ideal && !exercise.file.empty())
        return unexpected(msg::kNamedSentence, displayName(exercise.file), ideal.error());
    return ideal;
}

}  // namespace tactooth
