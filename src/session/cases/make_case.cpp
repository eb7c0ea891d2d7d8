// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/make_case.h"

#include <algorithm>

#include "collision/solid/solid.h"
#include "geometry/files/file_bytes.h"
#include "geometry/io/stl_writer.h"
#include "geometry/util/byte_text.h"
#include "geometry/util/messages.h"
#include "patient/jaw_frame.h"
#include "patient/length_unit.h"
#include "patient/messages.h"
#include "session/cases/bur_by_name.h"
#include "session/cases/case_names.h"
#include "session/cases/case_surfaces.h"
#include "session/cases/messages.h"
#include "session/io/limited_toml.h"
#include "session/io/material_file.h"
#include "session/io/run_metadata.h"

namespace tactooth {
namespace {

std::vector<Message> messagesOf(const std::vector<ImportNote>& importNotes) {
    std::vector<Message> messages;
    for (const ImportNote& importNote : importNotes) messages.push_back(importNote.message);
    return messages;
}

/// As the file of a case keeps them.
std::vector<std::string> inEnglish(const std::vector<Message>& messages) {
    std::vector<std::string> sentences;
    for (const Message& message : messages) sentences.push_back(message.in(Language::English));
    return sentences;
}

class CaseBuilder {
public:
    CaseBuilder(const CaseRequest& request, const CaseProgress& progress) : request_(request), progress_(progress) {}

    Expected<NewCase> make() {
        if (auto known = readRegistry(); !known) return Unexpected{known.error()};
        auto surfaces = readCaseSurfaces(request_.from, *materials_);
        if (!surfaces) return Unexpected{surfaces.error()};
        surfaces_ = std::move(*surfaces);
        if (surfaces_.teeth.size() > 1) {
            auto jaw = findJawFrame(surfaces_.teeth, request_.choices.mmPerUnit);
            if (!jaw) return Unexpected{jaw.error()};
            jaw_ = std::move(*jaw);
        }
        for (std::size_t i = 0; i < surfaces_.teeth.size(); ++i) {
            if (auto done = import(i); !done) return Unexpected{done.error()};
        }
        for (auto& [name, mesh] : surfaces_.around) {
            if (auto done = importSurroundings(name, std::move(mesh)); !done) return Unexpected{done.error()};
        }
        return finish();
    }

    Expected<NewCase> makeOf(const ExaminedScan& tooth) {
        materials_ = tooth.materials;
        addTooth(tooth, {});
        return finish();
    }

private:
    Expected<void> readRegistry() {
        const auto known = materialsFrom(request_.materials);
        if (!known) return Unexpected{known.error()};
        materials_ = *known;
        return {};
    }

    [[nodiscard]] bool goesOn(const std::string& name, double part) const {
        return !progress_ || progress_(name, part);
    }

    [[nodiscard]] ImportOptions choicesFor(std::size_t place) const {
        ImportOptions choices = request_.choices;
        if (jaw_) choices.mmPerUnit = jaw_->mmPerUnit;
        if (jaw_ && !jaw_->buccalDirections.empty()) choices.frame.buccal = jaw_->buccalDirections[place];
        return choices;
    }

    Expected<void> import(std::size_t place) {
        const Scan& scan = surfaces_.teeth[place];
        const ImportOptions choices = choicesFor(place);
        if (!goesOn(scan.name, 0)) return unexpected(msg::kStopped);
        auto examined = examineScan(scan, choices);
        if (!examined) return Unexpected{examined.error()};
        auto tooth = finishScan(std::move(*examined), choices, [&](double part) { return goesOn(scan.name, part); });
        if (!tooth) return Unexpected{tooth.error()};
        if (jaw_ && !jaw_->why.empty()) {
            // The unit was guessed for all teeth together.
            std::erase_if(tooth->importNotes,
                          [](const ImportNote& importNote) { return importNote.topic == ImportNoteTopic::Units; });
            tooth->importNotes.insert(tooth->importNotes.begin(), jaw_->why.begin(), jaw_->why.end());
        }
        const bool isAlone = !jaw_ && surfaces_.around.empty();
        addTooth(*tooth, isAlone ? Pose() : tooth->toothInFile);
        mmPerUnit_ = tooth->mmPerUnit;
        return {};
    }

    void addTooth(const ExaminedScan& tooth, const Pose& toothInCase) {
        CaseTooth entry;
        entry.name = bodyNames_.make(tooth.name);
        entry.fdi = fdiNamed(tooth.name, request_.quadrant);
        const std::string folder = "teeth/" + teethNames_.make(tooth.name) + "/";
        entry.outer = folder + "outer.stl";
        made_.files.push_back({entry.outer, stlBytes(tooth.outer)});
        for (const LayerMesh& layer : tooth.layers) {
            const bool isOuter = tooth.enamelIsOuter && materials_->hasRole(layer.material, MaterialRole::Enamel);
            const std::string file = isOuter ? entry.outer : folder + materials_->nameOf(layer.material) + ".stl";
            if (!isOuter) made_.files.push_back({file, stlBytes(layer.mesh)});
            entry.layers.emplace_back(layer.material, file);
        }
        std::ranges::sort(entry.layers, {}, [](const auto& layer) { return layer.first; });
        entry.isModelled = tooth.layersAreModelled;
        entry.toothInCase = toothInCase;
        made_.ofTeeth.push_back(messagesOf(tooth.importNotes));
        entry.assumed = inEnglish(made_.ofTeeth.back());
        made_.description.teeth.push_back(std::move(entry));
    }

    Expected<void> importSurroundings(const std::string& name, TriangleMesh mesh) {
        scaleToMm(mesh, mmPerUnit_);
        RepairedMesh mended = repaired(mesh, {.holes = request_.choices.holes});
        ExaminedSolid solid = examineSolid(std::move(mended.mesh));
        if (!solid.report.isSolid()) {
            return unexpected(msg::kCaseSurfaceNotSolid, name, flawSentence(solid.report, msg::kTheSurface));
        }
        const std::vector<ImportNote> importNotes = notesOn(solid.report, Message::verbatim(name));
        const bool isMended = mended.report.changedAnything() || !importNotes.empty();
        CaseSurrounding body;
        body.name = bodyNames_.make(name);
        body.material = materials_->withRole(MaterialRole::Surroundings);
        body.surface = "around/" + surroundingNames_.make(name) + ".stl";
        std::vector<Message> assumed = messagesOf(surfaces_.aroundImportNotes[name]);
        assumed.emplace_back(isMended ? msg::kCaseSurfaceMended : msg::kCaseSurfaceSound);
        for (const Message& message : messagesOf(importNotes)) assumed.push_back(message);
        body.assumed = inEnglish(assumed);
        made_.ofAround.push_back(std::move(assumed));
        made_.files.push_back({body.surface, stlBytes(solid.mesh)});
        made_.description.around.push_back(std::move(body));
        return {};
    }

    Expected<void> addBurs() {
        for (std::size_t i = 0; i < request_.burs.size(); ++i) {
            const auto bur = findOrReadBur(request_.burs[i]);
            if (!bur) return Unexpected{bur.error()};
            const std::string stem = "burs/" + std::to_string(i + 1);
            made_.files.push_back({stem + ".toml", bytesOf(customBurText(*bur, std::to_string(i + 1) + ".stl"))});
            made_.files.push_back({stem + ".stl", stlBytes(bur->surface)});
            made_.description.burs.push_back(stem + ".toml");
        }
        return {};
    }

    Expected<NewCase> finish() {
        CaseDescription& description = made_.description;
        description.title = request_.title.empty() ? description.teeth.front().name : request_.title;
        description.licence = request_.licence.empty() ? "not stated" : request_.licence;
        if (!request_.provenance.empty()) description.provenance.push_back(request_.provenance);
        for (const std::string& file : surfaces_.files) description.provenance.push_back("from " + file);
        description.provenance.push_back("made " + currentRunMetadata().date + " by Tactooth");
        if (!request_.materials.empty()) {
            const auto bytes = readFile(request_.materials, kTomlLimits.bytes);
            if (!bytes) return Unexpected{bytes.error()};
            made_.files.push_back({"materials.toml", {bytes->bytes().begin(), bytes->bytes().end()}});
            description.materials = "materials.toml";
        }
        description.registry = materials_;
        if (auto done = addBurs(); !done) return Unexpected{done.error()};
        const std::string text = caseText(description);
        const auto registry = [&](const std::string&) { return Expected<const MaterialRegistry*>(materials_); };
        if (const auto readable = parseCase(text, kCaseText, registry); !readable) {
            return unexpected(msg::kCaseNotReadable, readable.error());
        }
        made_.files.push_back({std::string(kCaseText), bytesOf(text)});
        return std::move(made_);
    }

    const CaseRequest& request_;
    const CaseProgress& progress_;
    const MaterialRegistry* materials_ = &builtinMaterials();
    CaseSurfaces surfaces_;
    std::optional<JawFrame> jaw_;  // of several teeth
    double mmPerUnit_ = 1;         // of the teeth
    EntryNames teethNames_, surroundingNames_;
    BodyNames bodyNames_;
    NewCase made_;
};

}  // namespace

Expected<NewCase> makeCase(const CaseRequest& request, const CaseProgress& progress) {
    return CaseBuilder(request, progress).make();
}

Expected<NewCase> caseOf(const ExaminedScan& tooth, const CaseRequest& request) {
    return CaseBuilder(request, {}).makeOf(tooth);
}

}  // namespace tactooth
