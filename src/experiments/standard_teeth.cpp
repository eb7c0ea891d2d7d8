// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/standard_teeth.h"

#include <cstdlib>

#include "geometry/io/mesh_file.h"
#include "geometry/mesh/simplify.h"
#include "geometry/util/messages.h"
#include "instruments/builtin_tooth.h"
#include "instruments/bur_shape.h"

namespace tactooth {
namespace {

/// Where a standard tooth comes from.
struct Origin {
    const char* name;
    const char* file;  // in the folder of real teeth
    BuiltinToothKind builtin;
    int builtinTriangles;
};

Origin originOf(StandardToothKind kind) {
    using enum BuiltinToothKind;
    switch (kind) {
        case StandardToothKind::Front:
            return {"front tooth", "openmandible/whole/L1_whole.stl", UpperCentralIncisor, 10000};
        case StandardToothKind::Molar:
            return {"molar", "openmandible/whole/L6_whole.stl", LowerFirstMolar, 10000};
        case StandardToothKind::Canine:
            return {"dog tooth", "openmandible/whole/L3_whole.stl", UpperCanine, 10000};
        case StandardToothKind::Large:
            return {"large tooth", "microct-meshes/tooth_2_outer.stl", LowerFirstMolar, 325312};
    }
    return {};
}

}  // namespace

std::optional<std::filesystem::path> realTeethFolder() {
    const char* named = std::getenv("TACTOOTH_DATA");
    const std::filesystem::path folder = named != nullptr ? named : "../shared/data";
    std::error_code ignored;
    if (!std::filesystem::exists(folder / "openmandible", ignored)) return std::nullopt;
    return folder;
}

Expected<StandardTooth> standardTooth(StandardToothKind kind) {
    const Origin origin = originOf(kind);
    if (const auto folder = realTeethFolder(); folder && std::filesystem::exists(*folder / origin.file)) {
        auto mesh = loadMesh(*folder / origin.file);
        if (!mesh) return Unexpected{mesh.error()};
        return StandardTooth{origin.name, origin.file, std::move(*mesh)};
    }
    BuiltinTooth tooth = makeBuiltinTooth(origin.builtin, origin.builtinTriangles);
    return StandardTooth{origin.name, "built in: " + tooth.name, std::move(tooth.outer)};
}

Expected<StandardTooth> customTooth(const std::filesystem::path& file) {
    auto mesh = loadMesh(file);
    if (!mesh) return Unexpected{mesh.error()};
    return StandardTooth{file.stem().string(), file.string(), std::move(*mesh)};
}

Expected<std::shared_ptr<const LayeredTooth>> uncut(const StandardTooth& tooth) {
    auto layered = LayeredTooth::make(tooth.mesh);
    if (!layered) return unexpected(msg::kNamed, tooth.source, layered.error());
    return std::make_shared<const LayeredTooth>(std::move(*layered));
}

TriangleMesh standardBur() { return makeBur(findBur("4").value()).surface; }

std::vector<Resolution> resolutionLadder(const TriangleMesh& tooth, std::span<const int> percents) {
    std::vector<Resolution> ladder(percents.size());
    const TriangleMesh* finer = &tooth;
    for (std::size_t i = percents.size(); i-- > 0;) {
        const std::size_t triangles = tooth.triangles.size() * static_cast<std::size_t>(percents[i]) / 100;
        ladder[i] = {percents[i], simplified(*finer, triangles)};
        finer = &ladder[i].mesh;
    }
    return ladder;
}

}  // namespace tactooth
