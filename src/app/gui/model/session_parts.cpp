// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/session_parts.h"

#include "app/common/mouth_scene.h"
#include "app/common/spin_blur.h"
#include "geometry/util/messages.h"
#include "instruments/builtin_tooth.h"
#include "instruments/bur_catalogue.h"
#include "instruments/bur_shape.h"
#include "instruments/suction_tube.h"
#include "instruments/turbine.h"
#include "session/cases/loaded_tooth.h"
#include "session/simulation/tooth_cache.h"
#include "session/simulation/tooth_in_mouth.h"

namespace tactooth {
namespace {

constexpr double kVoxel = 0.05;           // mm: a twentieth of a small bur's width; the cut itself is finer
constexpr int kShownBurTriangles = 6000;  // blades look round at full zoom

/// `file`: that it came from; empty for one of a case.
Expected<SessionBur> sessionBurOf(CustomBur own, const std::filesystem::path& file) {
    Expected<CuttingTool> cutting = makeCuttingTool(own.surface, own.sharpness);
    if (!cutting) return unexpected(msg::kNamedSentence, (file.empty() ? own.name : file.string()), cutting.error());
    auto shown = std::make_shared<const TriangleMesh>(own.surface);
    auto blurred = std::make_shared<const TriangleMesh>(spinEnvelopeMesh(cutting->envelope));
    const BurEdge edge = own.edge();
    return SessionBur{
        own.name,         {std::make_shared<const ToolShape>(std::move(own.surface)), std::move(*cutting), edge},
        std::move(shown), std::move(blurred),
        own.material,     file};
}

/// `importNote`: what its provenance says of it beside its name.
Expected<SessionTooth> builtinSessionTooth(const ToothRequest& request, const std::string& name,
                                           const std::string& importNote) {
    const BuiltinTooth made = ToothCache(defaultCacheFolder()).make(request);
    Expected<LayeredTooth> layered = layeredTooth(made);
    if (!layered) return Unexpected{layered.error()};
    auto shared = std::make_shared<const LayeredTooth>(std::move(*layered));
    return SessionTooth{name,
                        std::make_shared<CutModel>(std::move(shared), kVoxel),
                        mesialX(made.fdi),
                        {{"tooth", "built in: " + made.name + importNote}}};
}

}  // namespace

Expected<SessionTooth> makeSessionTooth(const BuiltinToothEntry& entry) {
    return builtinSessionTooth(builtinToothRequest(entry.kind), std::string(entry.name), "");
}

Expected<SessionTooth> makeSessionTooth(const std::shared_ptr<const Exercise>& exercise) {
    const auto* request = std::get_if<ToothRequest>(&exercise->tooth);
    const bool isSound = request != nullptr && (!request->lesion || request->lesion->width == 0);
    Expected<SessionTooth> tooth = request != nullptr
                                       ? builtinSessionTooth(*request, exercise->name, isSound ? ", sound" : "")
                                       : loadSessionTooth(std::get<ToothSource>(exercise->tooth));
    if (!tooth) return tooth;
    const auto* file = std::get_if<std::filesystem::path>(&exercise->bur);
    Expected<SessionBur> bur =
        file != nullptr ? loadSessionBur(*file) : makeSessionBur(*findBur(std::get<std::string>(exercise->bur)));
    if (!bur) return Unexpected{bur.error()};
    tooth->name = exercise->name;
    tooth->provenance.emplace_back("exercise", exercise->name);
    tooth->bur = std::move(*bur);
    tooth->exercise = exercise;
    return tooth;
}

Expected<SessionTooth> makeSessionTooth(const MouthChoice& mouth) {
    constexpr int kNeighbourTriangles = 20000;
    const MouthRequest request{.triangles = kNeighbourTriangles, .seed = 0, .jaw = JawPose::Open, .missing = {}};
    const ToothCache cache(mouth.cached ? defaultCacheFolder() : std::filesystem::path());
    const Expected<ToothInMouth> made = toothInMouth(mouth.fdi, Lesion{}, request, cache);
    if (!made) return Unexpected{made.error()};
    Expected<LayeredTooth> layered = layeredTooth(*made);
    if (!layered) return Unexpected{layered.error()};
    SessionTooth tooth{std::to_string(made->tooth.fdi),  // a number needs no translation
                       std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*layered)), kVoxel),
                       mesialX(made->tooth.fdi),
                       {{"tooth", "built in: " + made->tooth.name + ", in the whole mouth"}}};
    tooth.workBox = tooth.piece->tooth().ownBox();
    tooth.around = shownAround(*made);
    tooth.piece->surroundBy(surroundingsOf(*made));
    return tooth;
}

Expected<SessionTooth> loadSessionTooth(const ToothSource& source, const std::string& workOn) {
    Expected<LoadedModel> work = loadModelOrCase(source, workOn, std::nullopt, kVoxel);
    if (!work) return Unexpected{work.error()};
    ToothPlacement& place = work->place;
    SessionTooth tooth{
        std::move(place.name),      std::move(work->piece),      place.mesialX, std::move(work->provenance), place.box,
        std::move(place.materials), std::move(place.teethOfCase)};
    for (const ImportNote& importNote : work->importNotes)
        tooth.provenance.emplace_back("assumed", inWords(importNote));
    tooth.importNotes = std::move(work->importNotes);
    if (place.bur) {
        Expected<SessionBur> bur = sessionBurOf(std::move(*place.bur), {});
        if (!bur) return Unexpected{bur.error()};
        tooth.bur = std::move(*bur);
    }
    return tooth;
}

Expected<SessionTooth> makeSessionTooth(const ExaminedScan& scan) {
    Expected<LayeredTooth> layered = LayeredTooth::make(scan.outer, scan.layers);
    if (!layered) return unexpected(msg::kNamed, scan.name, layered.error());
    auto shared = std::make_shared<const LayeredTooth>(std::move(*layered));
    SessionTooth tooth{scan.name, std::make_shared<CutModel>(std::move(shared), kVoxel), 1, {{"tooth", scan.name}}};
    for (const ImportNote& importNote : scan.importNotes) tooth.provenance.emplace_back("assumed", inWords(importNote));
    return tooth;
}

Expected<SessionBur> makeSessionBur(const BurSpec& spec) {
    const Bur felt = makeBur(spec);
    Expected<CuttingTool> cutting = makeCuttingTool(felt.surface, spec.sharpness);
    if (!cutting) return Unexpected{cutting.error()};
    auto blurred = std::make_shared<const TriangleMesh>(spinEnvelopeMesh(cutting->envelope));
    return SessionBur{spec.name,
                      {std::make_shared<const ToolShape>(felt.surface), std::move(*cutting), spec.edge()},
                      std::make_shared<const TriangleMesh>(makeBur(spec, kShownBurTriangles).surface),
                      std::move(blurred),
                      spec.material,
                      {}};
}

Expected<SessionBur> loadSessionBur(const std::filesystem::path& path) {
    Expected<CustomBur> own = readCustomBur(path);
    if (!own) return Unexpected{own.error()};
    return sessionBurOf(std::move(*own), path);
}

SessionInstruments makeSessionInstruments() {
    SessionInstruments instruments;
    instruments.turbine = std::make_shared<const TriangleMesh>(makeTurbine());
    instruments.suction = std::make_shared<const TriangleMesh>(makeSuctionTube());
    return instruments;
}

void replaceMirror(SessionInstruments& instruments, double diameter) {
    DentalMirror mirror = makeMirror(diameter);
    instruments.mirror = std::make_shared<const TriangleMesh>(std::move(mirror.surface));
    instruments.disc = mirror.disc;
}

}  // namespace tactooth
