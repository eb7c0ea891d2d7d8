// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/tooth_source.h"

#include "collision/solid/solid_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/messages.h"
#include "session/io/messages.h"
#include "tooth/model/messages.h"

namespace tactooth {
namespace {

Expected<MaterialId> materialNamed(const std::string& name, const MaterialRegistry& materials) {
    if (const auto id = materials.find(name)) return *id;
    return unexpected(msg::kMaterialNamed, name, materials.names());
}

}  // namespace

Expected<ToothSource::Layer> parseLayer(const std::string& text, const MaterialRegistry& materials) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
        return unexpected(msg::kLayerNotParsed, text);
    }
    const std::string name = text.substr(0, equals);
    if (const auto id = materialNamed(name, materials); !id) return Unexpected{id.error()};
    return ToothSource::Layer{name, text.substr(equals + 1)};
}

Expected<std::shared_ptr<const LayeredTooth>> loadLayeredTooth(const ToothSource& source,
                                                               std::vector<ImportNote>* importNotes) {
    const MaterialRegistry& materials = source.materials != nullptr ? *source.materials : builtinMaterials();
    const Expected<MaterialId> body = source.material.empty()
                                          ? Expected<MaterialId>(materials.withRole(MaterialRole::Enamel))
                                          : materialNamed(source.material, materials);
    if (!body) return Unexpected{body.error()};
    Expected<TriangleMesh> outer = loadSolid(source.outer, {msg::kSurfaceOf, msg::kTheTooth}, {}, importNotes);
    if (!outer) return Unexpected{outer.error()};
    std::vector<LayerMesh> layers;
    for (const ToothSource::Layer& layer : source.layers) {
        const Expected<MaterialId> material = materialNamed(layer.material, materials);
        if (!material) return Unexpected{material.error()};
        const Message what(msg::kSurfaceOf, Message(msg::kLayerNamed, layer.material));
        Expected<TriangleMesh> mesh = loadSolid(layer.file, what, {.dropsSpecks = false}, importNotes);
        if (!mesh) return Unexpected{mesh.error()};
        layers.push_back({layer.material, *material, std::move(*mesh)});
    }
    Expected<LayeredTooth> tooth = LayeredTooth::make(std::move(*outer), std::move(layers), *body, {}, materials);
    if (!tooth) return unexpected(msg::kNamed, displayName(source.outer), tooth.error());
    return std::shared_ptr<const LayeredTooth>(std::make_shared<const LayeredTooth>(std::move(*tooth)));
}

Expected<CuttingTool> makeCuttingTool(const TriangleMesh& bur, double sharpness) {
    Expected<RevolutionEnvelope> envelope = RevolutionEnvelope::make(bur);
    if (!envelope) return Unexpected{envelope.error()};
    return CuttingTool{std::move(*envelope), sharpness};
}

}  // namespace tactooth
