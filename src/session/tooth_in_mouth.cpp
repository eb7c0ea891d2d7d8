// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/tooth_in_mouth.h"

#include <cassert>

#include "geometry/parallel_for.h"

namespace tactooth {
namespace {

struct Placed {
    const TriangleMesh* mesh;
    Pose bodyInTooth;
    MaterialId material;
};

std::vector<Placed> placedAround(const BuiltinMouth& mouth, const MouthTooth& worked) {
    const Pose mouthInTooth = mouth.poseOf(worked).inverse();
    std::vector<Placed> bodies = {{&mouth.upperGingiva, mouthInTooth, MaterialId::Other},
                                  {&mouth.lowerGingiva, mouthInTooth * mouth.lowerJaw, MaterialId::Other}};
    for (const MouthTooth& tooth : mouth.teeth) {
        if (&tooth == &worked) continue;
        bodies.push_back({&tooth.tooth.outer, mouthInTooth * mouth.poseOf(tooth), MaterialId::Enamel});
    }
    return bodies;
}

}  // namespace

ToothInMouth toothInMouth(int fdi, const std::optional<Lesion>& lesion, const MouthRequest& request,
                          const ToothMaker& maker) {
    const BuiltinMouth mouth = makeMouth(request, maker);
    const MouthTooth* worked = mouth.find(fdi);
    assert(worked != nullptr);
    const std::vector<Placed> bodies = placedAround(mouth, *worked);
    ToothInMouth result;
    result.around.resize(bodies.size());
    parallelFor(bodies.size(), [&](std::size_t i) {
        const auto& [mesh, pose, material] = bodies[i];
        std::vector<SurfaceTag> tags(mesh->triangles.size(), static_cast<SurfaceTag>(material));
        result.around[i] = {std::make_shared<const SurfacePart>(moved(*mesh, pose), std::move(tags)),
                            material == MaterialId::Other};
    });
    result.tooth = lesion ? maker({fdi, request.triangles, request.seed, lesion}) : worked->tooth;
    return result;
}

Surroundings surroundingsOf(const ToothInMouth& tooth) {
    Surroundings bodies;
    for (const ToothInMouth::Body& body : tooth.around) bodies.push_back(body.part);
    return bodies;
}

}  // namespace tactooth
