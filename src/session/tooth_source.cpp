// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/tooth_source.h"

#include "geometry/file_bytes.h"
#include "geometry/mesh_file.h"
#include "session/cases/open_case.h"

namespace tactooth {
namespace {

Expected<MaterialId> materialNamed(const std::string& name) {
    if (const auto id = materialFromName(name)) return *id;
    return unexpected("there is no material '" + name +
                      "'; choose enamel, dentin, pulp, caries, restoration or other.");
}

}  // namespace

Expected<ToothSource::Layer> parseLayer(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
        return unexpected("the layer '" + text + "' must be given as NAME=FILE.stl, for example dentin=dentin.stl.");
    }
    const std::string name = text.substr(0, equals);
    if (const auto id = materialNamed(name); !id) return Unexpected{id.error()};
    return ToothSource::Layer{name, text.substr(equals + 1)};
}

namespace {

Expected<std::shared_ptr<const LayeredTooth>> loadSurfaces(const ToothSource& source) {
    const Expected<MaterialId> body = materialNamed(source.material);
    if (!body) return Unexpected{body.error()};
    Expected<TriangleMesh> outer = loadMesh(source.outer);
    if (!outer) return Unexpected{outer.error()};
    std::vector<LayerMesh> layers;
    for (const ToothSource::Layer& layer : source.layers) {
        const Expected<MaterialId> material = materialNamed(layer.material);
        if (!material) return Unexpected{material.error()};
        Expected<TriangleMesh> mesh = loadMesh(layer.file);
        if (!mesh) return Unexpected{mesh.error()};
        layers.push_back({layer.material, *material, std::move(*mesh)});
    }
    Expected<LayeredTooth> tooth = LayeredTooth::make(std::move(*outer), std::move(layers), *body);
    if (!tooth) return unexpected(source.outer.string() + ": " + tooth.error().message);
    return std::shared_ptr<const LayeredTooth>(std::make_shared<const LayeredTooth>(std::move(*tooth)));
}

Expected<PlacedTooth> loadCase(const ToothSource& source) {
    if (!source.layers.empty()) {
        return unexpected(shownName(source.outer) + ": a case has its own layers; give no others.");
    }
    auto opened = openCase(source.outer, source.workOn);
    if (!opened) return Unexpected{opened.error()};
    PlacedTooth placed{std::move(opened->teeth), opened->box, opened->mesialX, opened->description.title};
    if (opened->description.teeth.size() > 1) placed.name += ", " + opened->tooth;
    placed.materials = std::move(opened->materials);
    placed.bur = std::move(opened->bur);
    placed.provenance = {{"case", shownName(source.outer)}, {"tooth", opened->tooth}};
    placed.provenance.emplace_back("licence", opened->description.licence);
    for (const std::string& line : opened->description.provenance) placed.provenance.emplace_back("case from", line);
    for (const CaseTooth& tooth : opened->description.teeth) placed.teethOfCase.push_back(tooth.name);
    return placed;
}

}  // namespace

Expected<PlacedTooth> loadPlacedTooth(const ToothSource& source) {
    if (isCase(source.outer)) return loadCase(source);
    if (!source.workOn.empty()) {
        return unexpected(shownName(source.outer) + ": this is one tooth; a tooth can be chosen in a case only.");
    }
    auto tooth = loadSurfaces(source);
    if (!tooth) return Unexpected{tooth.error()};
    PlacedTooth placed{std::move(*tooth), {}, 1, source.outer.filename().string()};
    placed.box = placed.tooth->outer()->tree().box();
    placed.provenance.emplace_back("tooth", source.outer.string());
    for (const ToothSource::Layer& layer : source.layers) {
        placed.provenance.emplace_back("layer " + layer.material, layer.file.string());
    }
    return placed;
}

Expected<std::shared_ptr<const LayeredTooth>> loadLayeredTooth(const ToothSource& source) {
    auto placed = loadPlacedTooth(source);
    if (!placed) return Unexpected{placed.error()};
    return placed->tooth;
}

Expected<CuttingTool> makeCuttingTool(const TriangleMesh& bur, double sharpness) {
    Expected<RevolutionEnvelope> envelope = RevolutionEnvelope::make(bur);
    if (!envelope) return Unexpected{envelope.error()};
    return CuttingTool{std::move(*envelope), sharpness};
}

}  // namespace tactooth
