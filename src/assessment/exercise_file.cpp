// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/exercise_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assessment/exercise_keys.h"
#include "assessment/messages.h"
#include "assessment/plan_reader.h"
#include "assessment/rubric/rubric_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/assert.h"
#include "geometry/util/number_text.h"
#include "instruments/bur_catalogue.h"
#include "session/cases/case_store.h"
#include "session/cases/messages.h"
#include "session/io/limited_toml.h"
#include "session/io/material_table.h"
#include "session/io/messages.h"
#include "session/io/toml_reader.h"

namespace tactooth {
namespace {

class ExerciseReader {
public:
    ExerciseReader(const std::string& name, const std::filesystem::path& folder) : toml_(name), folder_(folder) {}

    Expected<Exercise> read(std::string_view text) {
        const toml::table root = toml_.parse(text);
        if (!toml_.error()) readAll(root);
        if (toml_.error()) return Unexpected{*toml_.error()};
        return std::move(exercise_);
    }

private:
    void readAll(const toml::table& root) {
        toml_.allow(
            root, msg::kAnExercise,
            {"name",   "task",       "brief", "japanese", "group", "level",     "minutes",         "tolerance",
             "rubric", "tooth",      "mouth", "patient",  "decay", "filling",   "materials",       "layers",
             "bur",    "other_burs", "ideal", "cavity",   "view",  "forbidden", "only_these_burs", "instruments"});
        exercise_.name = toml_.text(root, "name", true);
        exercise_.task = toml_.text(root, "task", true);
        exercise_.brief = toml_.text(root, "brief", false);
        if (const toml::table* japanese = toml_.table(root, "japanese")) {
            toml_.allow(*japanese, msg::kJapaneseWords, {"name", "task", "brief"});
            exercise_.japanese = {toml_.text(*japanese, "name", true), toml_.text(*japanese, "task", true),
                                  toml_.text(*japanese, "brief", false)};
        }
        readFrame(root);
        if (const toml::table* materials = toml_.table(root, "materials"))
            exercise_.materials = &materialsIn(toml_, *materials);
        readTooth(root);
        readBur(root);
        readInstruments(root);
        readIdeal(root);
        readForbidden(root);
    }

    /// What the exercise trains, for how long, and how it is judged.
    void readFrame(const toml::table& root) {
        exercise_.group = static_cast<ExerciseGroup>(
            choice(toml_, root, "group", kGroupKeys, msg::kGroupUnknown, static_cast<std::size_t>(ExerciseGroup::Own)));
        exercise_.level =
            static_cast<ExerciseLevel>(choice(toml_, root, "level", kLevelKeys, msg::kExerciseLevelUnknown,
                                              static_cast<std::size_t>(ExerciseLevel::Usual)));
        if (root.get("minutes") != nullptr) exercise_.minutes = toml_.integer(root, "minutes", 1, 1, kMostMinutes);
        exercise_.tolerance = toml_.number(root, "tolerance", exercise_.tolerance, kLeastTolerance, kMostTolerance);
        exercise_.view = static_cast<StartView>(choice(toml_, root, "view", kViewKeys, msg::kStartViewUnknown,
                                                       static_cast<std::size_t>(StartView::Cavity)));
        exercise_.rubric = toml_.text(root, "rubric", false);
        if (exercise_.rubric.ends_with(".toml"))
            exercise_.rubric = beside(*root.get("rubric"), exercise_.rubric).string();
        else if (!exercise_.rubric.empty())
            if (const auto rubric = findRubric(exercise_.rubric); !rubric)
                toml_.fail(*root.get("rubric"), {msg::kNoSuchRubric, quotedWord(exercise_.rubric)});
    }

    /// The path of a file that the text names.
    std::filesystem::path beside(const toml::node& where, const std::string& entry) {
        if (!entry.empty() && !isSafeEntry(entry)) {
            toml_.fail(where, {msg::kMustLieBeside, quotedWord(entry)});
        }
        return folder_ / entry;
    }

    void readTooth(const toml::table& root) {
        const toml::node* node = root.get("tooth");
        if (node == nullptr) return toml_.fail(root, {msg::kKeyMissing, "tooth"});
        if (node->is_string()) return readCustomTooth(root, *node);
        exercise_.inMouth = toml_.flag(root, "mouth", false);
        ToothRequest request;
        request.fdi = toml_.integer(root, "tooth", request.fdi, 0, 99);
        if (!isPermanentTooth(request.fdi)) {
            toml_.fail(*node, {msg::kNoPermanentTooth, request.fdi});
        }
        request.seed = static_cast<std::uint32_t>(toml_.integer(root, "patient", 0, 0, 1'000'000));
        if (const toml::table* decay = toml_.table(root, "decay")) request.lesion = lesion(*decay, request.fdi);
        if (const toml::table* filling = toml_.table(root, "filling"))
            request.filling = readFilling(*filling, request.fdi);
        if (root.get("layers") != nullptr) toml_.fail(*root.get("layers"), msg::kBuiltinToothHasLayers);
        if (exercise_.inMouth && request.seed != 0) toml_.fail(*root.get("mouth"), msg::kMouthIsAverage);
        exercise_.tooth = request;
    }

    /// Where decay or a filling begins.
    LesionSite lesionSite(const toml::table& table, int fdi) {
        LesionSite found = LesionSite::Usual;
        const std::string site = toml_.text(table, "site", false);
        const auto* const known = std::ranges::find(kSiteKeys, site, &std::pair<std::string_view, LesionSite>::first);
        if (known != kSiteKeys.end()) found = known->second;
        if (known == kSiteKeys.end() && !site.empty()) {
            toml_.fail(*table.get("site"), msg::kDecaySite);
        }
        if (found == LesionSite::Occlusal && isAnteriorTooth(fdi)) {
            toml_.fail(*table.get("site"), msg::kNoOcclusalSide);
        }
        return found;
    }

    Filling readFilling(const toml::table& table, int fdi) {
        toml_.allow(table, msg::kAFilling, {"site", "width", "depth", "material"});
        Filling filling;
        filling.site = lesionSite(table, fdi);
        filling.width = toml_.number(table, "width", filling.width, kMinLesionWidth, kMaxLesionWidth);
        filling.depth = toml_.number(table, "depth", filling.depth, kMinLesionDepth, kDeepestLesion);
        if (const auto material = ownMaterial(table, msg::kFillingMaterial)) filling.material = *material;
        filling.materials = exercise_.materials;
        return filling;
    }

    /// The key `material`: one that no part of a sound tooth is made of. `mistake` takes the name and those that may
    /// be.
    std::optional<MaterialId> ownMaterial(const toml::table& table, const MessageText& mistake) {
        const std::string name = toml_.text(table, "material", true);
        const MaterialRegistry& materials = *exercise_.materials;
        const auto material = materials.find(name);
        if (material && materials.hasRole(*material, MaterialRole::None)) return material;
        if (name.empty()) return std::nullopt;
        std::string names;
        for (const MaterialId id : materials.inMenuOrder()) {
            if (materials.hasRole(id, MaterialRole::None)) names += (names.empty() ? "" : ", ") + materials.nameOf(id);
        }
        toml_.fail(*table.get("material"), {mistake, quotedWord(name), names});
        return std::nullopt;
    }

    Lesion lesion(const toml::table& decay, int fdi) {
        toml_.allow(decay, msg::kDecay, {"site", "at", "spread", "width", "depth", "rim"});
        Lesion lesion;
        lesion.site = lesionSite(decay, fdi);
        if (decay.get("at") != nullptr) {
            if (decay.get("site") != nullptr) toml_.fail(decay, msg::kDecaySiteOrPlace);
            lesion.place = placeIn(toml_, decay, "at");
        }
        if (decay.get("spread") != nullptr) {
            if (!lesion.place) toml_.fail(*decay.get("spread"), msg::kDecaySpreadNeedsPlace);
            lesion.spread = placesIn(toml_, decay, "spread", 1, kMostDecayPlaces, msg::kDecaySpread);
        }
        lesion.width = toml_.number(decay, "width", lesion.width, kMinLesionWidth, kMaxLesionWidth);
        if (decay.get("depth") != nullptr)
            lesion.depth = toml_.number(decay, "depth", 1, kMinLesionDepth, kDeepestLesion);
        if (const toml::table* rim = toml_.table(decay, "rim")) lesion.rim = lesionRim(*rim);
        return lesion;
    }

    LesionRim lesionRim(const toml::table& table) {
        toml_.allow(table, msg::kARim, {"width", "material"});
        LesionRim rim;
        rim.width = toml_.number(table, "width", rim.width, kMinRimWidth, kMaxRimWidth);
        rim.materials = exercise_.materials;
        const MaterialRegistry& materials = *rim.materials;
        if (const auto material = ownMaterial(table, msg::kRimMaterial)) {
            rim.material = *material;
            const auto [least, above] = rimNesting(materials);
            const int nesting = materials[rim.material].nesting;
            if (nesting < least || nesting >= above)
                toml_.fail(*table.get("material"), {msg::kRimNesting, materials.nameOf(rim.material), least, above});
        }
        return rim;
    }

    void readCustomTooth(const toml::table& root, const toml::node& node) {
        ToothSource source;
        source.outer = beside(node, toml_.text(root, "tooth", true));
        if (exercise_.materials != &builtinMaterials()) source.materials = exercise_.materials;
        for (const std::string_view key : {"patient", "decay", "mouth"}) {
            if (root.get(key) == nullptr) continue;
            toml_.fail(*root.get(key), {msg::kKeyOfBuiltinTooth, quotedWord(key)});
        }
        if (const toml::table* layers = toml_.table(root, "layers")) {
            for (auto&& [name, entry] : *layers) {
                if (!exercise_.materials->find(name.str())) {
                    toml_.fail(entry, {msg::kMaterialUnknown, quotedWord(name.str()), exercise_.materials->names()});
                }
                source.layers.push_back(
                    {std::string(name.str()), beside(entry, toml_.text(*layers, name.str(), true))});
            }
        }
        exercise_.tooth = source;
    }

    void readBur(const toml::table& root) {
        exercise_.otherBurs = toml_.texts(root, "other_burs");
        for (const std::string& other : exercise_.otherBurs) {
            if (!findBur(other)) toml_.fail(*root.get("other_burs"), {msg::kBurUnknown, quotedWord(other)});
        }
        const std::string bur = toml_.text(root, "bur", true);
        if (bur.ends_with(".toml") || bur.ends_with(".stl") || bur.ends_with(".STL")) {
            exercise_.bur = beside(*root.get("bur"), bur);
            return;
        }
        exercise_.bur = bur;
        if (!bur.empty() && !findBur(bur)) {
            toml_.fail(*root.get("bur"), {msg::kBurUnknown, quotedWord(bur)});
        }
    }

    /// What the student may take.
    void readInstruments(const toml::table& root) {
        exercise_.onlyTheseBurs = toml_.flag(root, "only_these_burs", false);
        const toml::node* const node = root.get("instruments");
        if (node == nullptr) return;
        const std::vector<std::string> names = toml_.texts(root, "instruments");
        for (const std::string& name : names) {
            const bool isKnown =
                std::ranges::count(kInstrumentKeys, name, &std::pair<std::string_view, TrayInstrument>::first) > 0;
            if (!isKnown) toml_.fail(*node, {msg::kInstrumentUnknown, quotedWord(name)});
        }
        bool hasHandpiece = false;
        for (const auto& [key, instrument] : kInstrumentKeys) {
            if (std::ranges::find(names, key) == names.end()) continue;
            exercise_.instruments.push_back(instrument);
            hasHandpiece = hasHandpiece || std::holds_alternative<HandpieceKind>(instrument);
        }
        if (!hasHandpiece) toml_.fail(*node, msg::kInstrumentsNeedHandpiece);
    }

    void readIdeal(const toml::table& root) {
        const toml::table* cavity = toml_.table(root, "cavity");
        if ((root.get("ideal") != nullptr) == (cavity != nullptr)) {
            return toml_.fail(root, msg::kIdealShapeUnclear);
        }
        if (cavity != nullptr) {
            exercise_.ideal = PlanReader(toml_, exercise_.tooth, catalogueBur()).read(*cavity);
        } else {
            exercise_.ideal = beside(*root.get("ideal"), toml_.text(root, "ideal", true));
        }
    }

    void readForbidden(const toml::table& root) {
        const std::vector<const toml::table*> zones = toml_.tables(root, "forbidden");
        if (zones.size() > kMostZones) return toml_.fail(*zones.back(), {msg::kTooManyZones, kMostZones});
        for (const toml::table* table : zones) {
            toml_.allow(*table, msg::kAForbiddenZone, {"side", "corners"});
            ForbiddenZone zone{.corners = {}, .outward = sideIn(toml_, *table, toothMesialX(exercise_.tooth))};
            zone.corners = cornersIn(toml_, *table, zone.outward);
            exercise_.forbidden.push_back(std::move(zone));
        }
    }

    [[nodiscard]] std::optional<BurSpec> catalogueBur() const {
        const auto* number = std::get_if<std::string>(&exercise_.bur);
        return number != nullptr ? findBur(*number) : std::nullopt;
    }

    TomlReader toml_;
    const std::filesystem::path& folder_;
    Exercise exercise_;
};

}  // namespace

Expected<Exercise> parseExercise(std::string_view text, const std::string& name, const std::filesystem::path& folder) {
    return ExerciseReader(name, folder).read(text);
}

Expected<Exercise> readExercise(const std::filesystem::path& file) {
    const Expected<FileBytes> bytes = readFile(file, kTomlLimits.bytes);
    if (!bytes) return Unexpected{bytes.error()};
    Expected<Exercise> exercise = parseExercise(bytes->text(), displayName(file), file.parent_path());
    if (exercise) exercise->file = file;
    return exercise;
}

}  // namespace tactooth
