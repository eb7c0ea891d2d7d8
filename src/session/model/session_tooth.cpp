// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/session_tooth.h"

#include <algorithm>
#include <filesystem>

#include "geometry/util/messages.h"
#include "patient/tooth_frame.h"
#include "session/cases/case_names.h"
#include "session/cases/loaded_tooth.h"
#include "session/simulation/session_voxel.h"
#include "session/simulation/tooth_cache.h"

namespace tactooth {

namespace {

/// Reports the part of a work that goes from `from` to `to` of the whole.
ShareDone part(const ShareDone& whole, double from, double to) {
    if (!whole) return {};
    return [whole, from, to](double share) { whole(from + (to - from) * share); };
}

void report(const ShareDone& progress, double share) {
    if (progress) progress(share);
}

}  // namespace

Expected<SessionTooth> makeSessionTooth(const ToothRequest& request, const std::string& name, const std::string& suffix,
                                        const ShareDone& progress) {
    constexpr double kMade = 0.8, kLayered = 0.9;  // about these shares of the time
    const BuiltinTooth made = ToothCache(defaultCacheFolder()).make(request, part(progress, 0, kMade));
    Expected<LayeredTooth> layered = layeredTooth(made);
    if (!layered) return Unexpected{layered.error()};
    report(progress, kLayered);
    auto shared = std::make_shared<const LayeredTooth>(std::move(*layered));
    SessionTooth tooth{name,
                       std::make_shared<CutModel>(std::move(shared), kSessionVoxel),
                       mesialX(made.fdi),
                       {{"tooth", "built in: " + made.name + suffix}}};
    tooth.fdi = made.fdi;
    report(progress, 1);
    return tooth;
}

Expected<SessionTooth> makeSessionTooth(const BuiltinToothEntry& entry, const ShareDone& progress) {
    return makeSessionTooth(builtinToothRequest(entry.kind), std::string(entry.name), "", progress);
}

Expected<SessionTooth> makeSessionTooth(const MouthChoice& mouth, const ShareDone& progress) {
    constexpr int kNeighbourTriangles = 20000;
    const MouthRequest request{.triangles = kNeighbourTriangles, .seed = 0, .jaw = JawPose::Open, .missing = {}};
    const ToothCache cache(mouth.cached ? defaultCacheFolder() : std::filesystem::path());
    constexpr double kShareOfMeshes = 0.9;  // then the surfaces are made ready to be touched
    Expected<ToothInMouth> made =
        toothInMouth(mouth.fdi, mouth.lesion, request, cache, part(progress, 0, kShareOfMeshes));
    if (!made) return Unexpected{made.error()};
    if (mouth.filling)
        made->tooth = cache.make({mouth.fdi, request.triangles, request.seed, mouth.lesion, mouth.filling});
    Expected<LayeredTooth> layered = layeredTooth(*made);
    if (!layered) return Unexpected{layered.error()};
    SessionTooth tooth{
        std::to_string(made->tooth.fdi),  // a number needs no translation
        std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*layered)), kSessionVoxel),
        mesialX(made->tooth.fdi),
        {{"tooth", "built in: " + made->tooth.name + ", in the whole mouth"}}};
    tooth.workBox = tooth.piece->tooth().ownBox();
    tooth.around = made->around;
    tooth.softTissues = made->softTissues;
    tooth.mouthTooth = made->tooth.fdi;
    tooth.piece->surroundBy(surroundingsOf(*made));
    return tooth;
}

int fdiOfTooth(const SessionTooth& tooth) {
    if (tooth.mouthTooth != 0) return tooth.mouthTooth;
    if (tooth.fdi != 0) return tooth.fdi;
    const auto* const builtin = std::ranges::find(kBuiltinTeeth, tooth.name, &BuiltinToothEntry::name);
    if (builtin != kBuiltinTeeth.end()) return builtinToothRequest(builtin->kind).fdi;
    return fdiNamed(std::filesystem::path(tooth.name).stem().string(), std::nullopt);
}

ChairView chairViewOf(const SessionTooth& tooth) {
    const int fdi = fdiOfTooth(tooth);
    if (isPermanentTooth(fdi) && mesialX(fdi) == tooth.mesialX) return chairView(fdi);
    return {.view = dentistView(tooth.mesialX)};
}

Expected<void> putIntoMouth(SessionTooth& tooth, int fdi, const ShareDone& progress) {
    Expected<SessionTooth> mouth = makeSessionTooth(MouthChoice{.fdi = fdi}, progress);
    if (!mouth) return Unexpected{mouth.error()};
    tooth.mesialX = mouth->mesialX;
    tooth.workBox = mouth->workBox;
    tooth.around = std::move(mouth->around);
    tooth.softTissues = std::move(mouth->softTissues);
    tooth.mouthTooth = fdi;
    if (tooth.piece->surroundings().empty()) tooth.piece->surroundBy(mouth->piece->surroundings());
    return {};
}

Expected<SessionTooth> loadSessionTooth(const ToothSource& source, const std::string& workOn,
                                        const ShareDone& progress) {
    constexpr double kRead = 0.5;  // then it may come into a mouth
    Expected<LoadedModel> work = loadModelOrCase(source, workOn, std::nullopt, kSessionVoxel);
    if (!work) return Unexpected{work.error()};
    report(progress, kRead);
    ToothPlacement& place = work->place;
    SessionTooth tooth{
        std::move(place.name),       std::move(work->piece), place.mesialX, std::move(work->provenance), place.box,
        std::move(place.teethOfCase)};
    for (const ImportNote& importNote : work->importNotes)
        tooth.provenance.emplace_back("assumed", inWords(importNote));
    tooth.importNotes = std::move(work->importNotes);
    if (tooth.teethOfCase.empty() && !isToothFile(source.outer)) {  // a hint: nothing was assumed
        if (auto tilted = noteOnTilt(tooth.piece->tooth().outer()->mesh())) tooth.importNotes.push_back(*tilted);
    }
    if (place.bur) {
        Expected<SessionBur> bur = makeSessionBur(std::move(*place.bur), {});
        if (!bur) return Unexpected{bur.error()};
        tooth.bur = std::move(*bur);
    }
    if (const std::optional<SessionWork> before = parseWork(work->work)) {
        tooth.work = *before;
        if (auto bur = burOf(tooth.work, source.outer.parent_path())) tooth.bur = std::move(*bur);
    }
    if (isPermanentTooth(tooth.work.mouthTooth)) {
        if (const auto inMouth = putIntoMouth(tooth, tooth.work.mouthTooth, part(progress, kRead, 1)); !inMouth)
            return Unexpected{inMouth.error()};
    }
    return tooth;
}

Expected<SessionTooth> makeSessionTooth(const ExaminedScan& scan) {
    Expected<LayeredTooth> layered = LayeredTooth::make(scan.outer, scan.layers, {}, {}, *scan.materials);
    if (!layered) return unexpected(msg::kNamed, scan.name, layered.error());
    auto shared = std::make_shared<const LayeredTooth>(std::move(*layered));
    SessionTooth tooth{
        scan.name, std::make_shared<CutModel>(std::move(shared), kSessionVoxel), 1, {{"tooth", scan.name}}};
    for (const ImportNote& importNote : scan.importNotes) tooth.provenance.emplace_back("assumed", inWords(importNote));
    return tooth;
}

}  // namespace tactooth
