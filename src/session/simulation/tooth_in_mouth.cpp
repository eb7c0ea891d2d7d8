// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/tooth_in_mouth.h"

#include <algorithm>
#include <cstdlib>

#include "geometry/mesh/append_subset.h"
#include "geometry/util/assert.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

bool isUpper(int fdi) { return fdi < 30; }

bool isRightSide(int fdi) { return fdi / 10 % 4 < 2; }  // quadrants 1 and 4

/// Position along the jaw: 0 to 15 from the patient's right to the left.
int placeInArch(int fdi) { return isRightSide(fdi) ? 8 - fdi % 10 : 7 + fdi % 10; }

bool areBeside(int a, int b) { return isUpper(a) == isUpper(b) && std::abs(placeInArch(a) - placeInArch(b)) == 1; }

BuiltinTooth transformed(BuiltinTooth tooth, const Pose& pose) {
    for (TriangleMesh* mesh : meshesOf(tooth)) *mesh = transformed(*mesh, pose);
    return tooth;
}

struct Placed {
    const TriangleMesh* mesh;
    Pose bodyInTooth;
    MaterialId material;
    bool isUpper;
    const ZonedMesh* gingiva = nullptr;  ///< how it is drawn; null for a tooth
    int fdi = 0;                         ///< of a tooth
};

std::vector<Placed> placedAround(const BuiltinMouth& mouth, const MouthTooth& worked) {
    const Pose mouthInTooth = mouth.poseOf(worked).inverse();
    const MaterialId gingiva = builtinMaterials().withRole(MaterialRole::Surroundings);
    const MaterialId enamel = builtinMaterials().withRole(MaterialRole::Enamel);
    std::vector<Placed> bodies = {
        {&mouth.upperGingiva, mouthInTooth, gingiva, true, &mouth.upperShown},
        {&mouth.lowerGingiva, mouthInTooth * mouth.lowerJaw, gingiva, false, &mouth.lowerShown}};
    for (const MouthTooth& tooth : mouth.teeth) {
        if (&tooth == &worked || areBeside(tooth.tooth.fdi, worked.tooth.fdi)) continue;
        bodies.push_back({&tooth.tooth.outer, mouthInTooth * mouth.poseOf(tooth), enamel, isUpper(tooth.tooth.fdi),
                          nullptr, tooth.tooth.fdi});
    }
    return bodies;
}

/// The part of a gingiva on the side of a tooth.
ToothInMouth::Body::Half halfOf(const ZonedMesh& gingiva, const Pose& gingivaInTooth, bool isRight) {
    const double side = isRight ? 1 : -1;
    TriangleMesh half;
    std::vector<std::uint8_t> zones;
    const auto isOwn = [&](std::uint32_t vertex) { return side * gingiva.mesh.vertices[vertex].x() >= 0; };
    appendSubset(
        half, gingiva.mesh, [&](std::uint32_t i) { return std::ranges::any_of(gingiva.mesh.triangles[i], isOwn); },
        [&](std::uint32_t vertex) { zones.push_back(gingiva.zones[vertex]); });
    return {gingivaInTooth.rotation * (side * Vec3::UnitX()),
            std::make_shared<const TriangleMesh>(transformed(half, gingivaInTooth)),
            std::make_shared<const std::vector<std::uint8_t>>(std::move(zones))};
}

ToothInMouth inMouth(const BuiltinMouth& mouth, int fdi) {
    const MouthTooth* worked = mouth.find(fdi);
    TACTOOTH_ASSERT(worked != nullptr);
    const std::vector<Placed> bodies = placedAround(mouth, *worked);
    ToothInMouth result;
    result.around.resize(bodies.size());
    parallelFor(bodies.size(), [&](std::size_t i) {
        const auto& [mesh, pose, material, upper, gingiva, number] = bodies[i];
        std::vector<SurfaceTag> tags(mesh->triangles.size(), static_cast<SurfaceTag>(material));
        auto part = std::make_shared<const SurfacePart>(transformed(*mesh, pose), std::move(tags), 0);
        const bool isGingiva = gingiva != nullptr;
        auto shown = std::make_shared<const TriangleMesh>(
            transformed(isGingiva ? gingiva->mesh : supragingivalMesh(*mesh), pose));
        result.around[i] = {std::move(part), std::move(shown), isGingiva, upper != isUpper(fdi)};
        result.around[i].fdi = number;
        result.around[i].bodyInTooth = pose;
        result.around[i].ownBox = boundingBox(*mesh);
        const bool isOwnJaw = upper == isUpper(fdi);
        result.around[i].isBeyond = !isGingiva && isOwnJaw && isRightSide(number) != isRightSide(fdi);
        if (!isGingiva) return;
        result.around[i].zones = std::make_shared<const std::vector<std::uint8_t>>(gingiva->zones);
        if (isOwnJaw) result.around[i].ownHalf = halfOf(*gingiva, pose, isRightSide(fdi));
    });
    result.tooth = worked->tooth;
    const Pose mouthInTooth = mouth.poseOf(*worked).inverse();
    result.softTissues = softTissueBodies(mouth, fdi, mouthInTooth);
    for (const MouthTooth& tooth : mouth.teeth) {
        if (areBeside(tooth.tooth.fdi, fdi))
            result.beside.push_back(transformed(tooth.tooth, mouthInTooth * mouth.poseOf(tooth)));
    }
    return result;
}

}  // namespace

std::vector<SoftTissueBody> softTissueBodies(const BuiltinMouth& mouth, int worked, const Pose& mouthInFrame) {
    std::vector<SoftTissue> tissues = softTissuesOf(mouth, worked);
    std::vector<SoftTissueBody> bodies(tissues.size());
    parallelFor(bodies.size(), [&](std::size_t i) {
        auto& [kind, shown] = tissues[i];
        Surface surface{std::make_shared<const SurfacePart>(transformed(shown.mesh, mouthInFrame),
                                                            std::vector<SurfaceTag>(), SurfacePart::kNoneAdjacent,
                                                            TreeBuild::Quick)};  // only some rays a picture search it
        bodies[i] = {kind, std::make_shared<const Surface>(std::move(surface)),
                     std::make_shared<const std::vector<std::uint8_t>>(std::move(shown.zones))};
    });
    return bodies;
}

Expected<ToothInMouth> toothInMouth(int fdi, const std::optional<Lesion>& lesion, const MouthRequest& mouth,
                                    const ToothGenerator& generator) {
    const auto whole = makeMouth(mouth, generator);
    if (!whole) return Unexpected{whole.error()};
    ToothInMouth result = inMouth(*whole, fdi);
    if (lesion) result.tooth = generator({fdi, mouth.triangles, mouth.seed, lesion});
    return result;
}

Expected<ToothInMouth> toothInMouth(int fdi, const std::optional<Lesion>& lesion, const MouthRequest& mouth,
                                    const ToothCache& cache, const std::function<void(double)>& partDone) {
    const auto whole = cache.makeMouth(mouth, partDone);
    if (!whole) return Unexpected{whole.error()};
    ToothInMouth result = inMouth(*whole, fdi);
    if (lesion) result.tooth = cache.make({fdi, mouth.triangles, mouth.seed, lesion});
    return result;
}

TriangleMesh supragingivalMesh(const TriangleMesh& tooth) {
    constexpr float kBelowNeck = -1.0F;  // mm: the gum's margin stands above the neck all around
    TriangleMesh shown;
    appendSubset(shown, tooth, [&](std::uint32_t i) {
        return !std::ranges::all_of(tooth.triangles[i],
                                    [&](std::uint32_t vertex) { return tooth.vertices[vertex].z() < kBelowNeck; });
    });
    return shown;
}

Surroundings surroundingsOf(const ToothInMouth& tooth) {
    Surroundings bodies;
    for (const ToothInMouth::Body& body : tooth.around) bodies.push_back(body.part);
    return bodies;
}

Expected<LayeredTooth> layeredTooth(const ToothInMouth& tooth) { return layeredTooth(tooth.tooth, tooth.beside); }

}  // namespace tactooth
