// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/session_bur.h"

#include <algorithm>

#include "geometry/util/messages.h"
#include "instruments/bur_shape.h"
#include "session/cases/bur_by_name.h"
#include "session/model/spin_envelope_mesh.h"

namespace tactooth {
namespace {

constexpr int kShownTriangles = 6000;  // blades look round at full zoom

}  // namespace

SessionBur withHead(SessionBur bur) {
    bur.head = burHeadOf(*bur.shown);
    bur.headCap = std::make_shared<const TriangleMesh>(headCap(bur.head));
    return bur;
}

Expected<SessionBur> makeSessionBur(const BurSpec& spec) {
    const Bur coarse = makeBur(spec);
    Expected<CuttingTool> cutting = makeCuttingTool(coarse.surface, spec.sharpness);
    if (!cutting) return Unexpected{cutting.error()};
    auto blurred = std::make_shared<const TriangleMesh>(spinEnvelopeMesh(cutting->envelope));
    return withHead({spec.name,
                     {std::make_shared<const ToolShape>(coarse.surface), std::move(*cutting), spec.edge()},
                     std::make_shared<const TriangleMesh>(makeBur(spec, kShownTriangles).surface),
                     std::move(blurred),
                     spec.material,
                     {}});
}

Expected<SessionBur> makeSessionBur(CustomBur bur, const std::filesystem::path& file) {
    Expected<CuttingTool> cutting = makeCuttingTool(bur.surface, bur.sharpness);
    if (!cutting) return unexpected(msg::kNamedSentence, file.empty() ? bur.name : file.string(), cutting.error());
    auto shown = std::make_shared<const TriangleMesh>(bur.surface);
    auto blurred = std::make_shared<const TriangleMesh>(spinEnvelopeMesh(cutting->envelope));
    const BurEdge edge = bur.edge();
    return withHead({bur.name,
                     {std::make_shared<const ToolShape>(std::move(bur.surface)), std::move(*cutting), edge},
                     std::move(shown),
                     std::move(blurred),
                     bur.material,
                     file});
}

SessionBur makeHandInstrument(HandInstrument kind) {
    const HandInstrumentSpec& spec = specOf(kind);
    const auto shown = std::make_shared<const TriangleMesh>(heldInstrument(kind));
    return {.name = std::string(spec.title->english),
            .instrument = handTool(kind),
            .shown = shown,
            .blurred = nullptr,  // it does not turn
            .file = {},
            .head = {spec.headLength, spec.headRadius, spec.headRadius}};
}

Expected<SessionBur> loadSessionBur(const std::filesystem::path& path) {
    Expected<CustomBur> own = readCustomBur(path);
    if (!own) return Unexpected{own.error()};
    return makeSessionBur(std::move(*own), path);
}

Expected<SessionBur> findOrLoadSessionBur(const std::filesystem::path& numberOrFile) {
    if (const auto spec = findBur(numberOrFile.native())) return makeSessionBur(*spec);
    Expected<CustomBur> own = findOrReadBur(numberOrFile);
    if (!own) return Unexpected{own.error()};
    return makeSessionBur(std::move(*own), numberOrFile);
}

std::optional<SessionBur> burOf(const SessionWork& work, const std::filesystem::path& folder) {
    if (work.bur.empty()) return std::nullopt;
    if (work.burFile.empty()) {
        if (const HandInstrumentSpec* held = findHandInstrument(work.bur)) return makeHandInstrument(held->kind);
        const auto spec = std::ranges::find(burCatalogue(), work.bur, &BurSpec::name);
        if (spec == burCatalogue().end()) return std::nullopt;
        Expected<SessionBur> made = makeSessionBur(*spec);
        return made ? std::optional(std::move(*made)) : std::nullopt;
    }
    const std::filesystem::path file = work.burFile;
    for (const std::filesystem::path& place : {file, folder / file.filename()}) {
        if (!place.is_absolute() && place == file) continue;  // a name alone: not that of the working folder
        if (Expected<SessionBur> loaded = loadSessionBur(place)) return std::move(*loaded);
    }
    return std::nullopt;
}

}  // namespace tactooth
