// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/exercise_file.h"

#include <array>
#include <cmath>

#include "assessment/messages.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/assert.h"
#include "geometry/util/number_text.h"
#include "instruments/bur_catalogue.h"
#include "session/cases/case_store.h"
#include "session/cases/messages.h"
#include "session/io/limited_toml.h"
#include "session/io/messages.h"
#include "session/io/toml_reader.h"

namespace tactooth {
namespace {

constexpr double kFarthest = 500;      // mm from the origin of the tooth's frame
constexpr double kMinDepth = 0.05;     // mm: a voxel
constexpr double kMaxDepth = 15;       // mm: more than a crown is high
constexpr double kLongestStroke = 50;  // mm: more than a molar is wide, roots and all
constexpr std::size_t kMaxStrokes = 200;
constexpr double kDeepestLesion = 10;  // mm

constexpr std::array<std::pair<std::string_view, LesionSite>, 5> kSites = {{{"occlusal", LesionSite::Occlusal},
                                                                            {"mesial", LesionSite::Mesial},
                                                                            {"distal", LesionSite::Distal},
                                                                            {"buccal", LesionSite::Buccal},
                                                                            {"lingual", LesionSite::Lingual}}};

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
        toml_.allow(root, msg::kAnExercise,
                    {"name", "task", "tooth", "patient", "decay", "layers", "bur", "ideal", "cavity"});
        exercise_.name = toml_.text(root, "name", true);
        exercise_.task = toml_.text(root, "task", true);
        readTooth(root);
        readBur(root);
        readIdeal(root);
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
        ToothRequest request;
        request.fdi = toml_.integer(root, "tooth", request.fdi, 0, 99);
        if (!isPermanentTooth(request.fdi)) {
            toml_.fail(*node, {msg::kNoPermanentTooth, request.fdi});
        }
        request.seed = static_cast<std::uint32_t>(toml_.integer(root, "patient", 0, 0, 1'000'000));
        if (const toml::table* decay = toml_.table(root, "decay")) request.lesion = lesion(*decay, request.fdi);
        if (root.get("layers") != nullptr) toml_.fail(*root.get("layers"), msg::kBuiltinToothHasLayers);
        mesialX_ = mesialX(request.fdi);
        exercise_.tooth = request;
    }

    Lesion lesion(const toml::table& decay, int fdi) {
        toml_.allow(decay, msg::kDecay, {"site", "width", "depth"});
        Lesion lesion;
        const std::string site = toml_.text(decay, "site", false);
        const auto* const known = std::ranges::find(kSites, site, &std::pair<std::string_view, LesionSite>::first);
        if (known != kSites.end()) lesion.site = known->second;
        if (known == kSites.end() && !site.empty()) {
            toml_.fail(*decay.get("site"), msg::kDecaySite);
        }
        if (lesion.site == LesionSite::Occlusal && isAnteriorTooth(fdi)) {
            toml_.fail(*decay.get("site"), msg::kNoOcclusalSide);
        }
        lesion.width = toml_.number(decay, "width", lesion.width, kMinLesionWidth, kMaxLesionWidth);
        if (decay.get("depth") != nullptr)
            lesion.depth = toml_.number(decay, "depth", 1, kMinLesionDepth, kDeepestLesion);
        return lesion;
    }

    void readCustomTooth(const toml::table& root, const toml::node& node) {
        ToothSource source;
        source.outer = beside(node, toml_.text(root, "tooth", true));
        for (const std::string_view key : {"patient", "decay"}) {
            if (root.get(key) == nullptr) continue;
            toml_.fail(*root.get(key), {msg::kKeyOfBuiltinTooth, quotedWord(key)});
        }
        if (const toml::table* layers = toml_.table(root, "layers")) {
            for (auto&& [name, entry] : *layers) {
                if (!builtinMaterials().find(name.str())) {
                    toml_.fail(entry, {msg::kMaterialUnknown, quotedWord(name.str()), builtinMaterials().names()});
                }
                source.layers.push_back(
                    {std::string(name.str()), beside(entry, toml_.text(*layers, name.str(), true))});
            }
        }
        exercise_.tooth = source;
    }

    void readBur(const toml::table& root) {
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

    void readIdeal(const toml::table& root) {
        const toml::table* cavity = toml_.table(root, "cavity");
        if ((root.get("ideal") != nullptr) == (cavity != nullptr)) {
            return toml_.fail(root, msg::kIdealShapeUnclear);
        }
        if (cavity != nullptr) {
            exercise_.ideal = plan(*cavity);
        } else {
            exercise_.ideal = beside(*root.get("ideal"), toml_.text(root, "ideal", true));
        }
    }

    PreparationPlan plan(const toml::table& cavity) {
        toml_.allow(cavity, msg::kACavity, {"side", "depth", "floor", "depth_stop", "strokes"});
        PreparationPlan plan;
        plan.outward = side(cavity);
        if (cavity.get("depth") == nullptr) toml_.fail(cavity, {msg::kKeyMissing, "depth"});
        plan.depth = toml_.number(cavity, "depth", 1, kMinDepth, kMaxDepth);
        const std::string floor = toml_.text(cavity, "floor", false);
        plan.isFlat = floor != "surface";
        if (!floor.empty() && floor != "flat" && floor != "surface") {
            toml_.fail(*cavity.get("floor"), msg::kFloorUnknown);
        }
        plan.stopsDevice = toml_.flag(cavity, "depth_stop", false);
        const std::vector<const toml::table*> strokes = toml_.tables(cavity, "strokes");
        if (strokes.empty()) toml_.fail(cavity, msg::kNoStrokes);
        if (strokes.size() > kMaxStrokes) toml_.fail(cavity, msg::kTooManyStrokes);
        for (const toml::table* stroke : strokes) plan.strokes.push_back(this->stroke(*stroke));
        return plan;
    }

    /// Unit vector out of the tooth.
    Vec3 side(const toml::table& cavity) {
        const toml::node* node = cavity.get("side");
        if (node != nullptr && node->is_array()) {
            Vec3 outward = Vec3::Zero();
            toml_.numbers(cavity, "side", {outward.data(), 3});
            if (outward.norm() > 0) return outward.normalized();
            toml_.fail(*node, msg::kSideWithoutDirection);
            return Vec3::UnitZ();
        }
        const std::string name = toml_.text(cavity, "side", false);
        if (name.empty() || name == "occlusal") return Vec3::UnitZ();
        if (name == "buccal") return Vec3::UnitY();
        if (name == "lingual") return -Vec3::UnitY();
        if (name == "mesial") return mesialX_ * Vec3::UnitX();
        if (name == "distal") return -mesialX_ * Vec3::UnitX();
        toml_.fail(*node, msg::kSideUnknown);
        return Vec3::UnitZ();
    }

    PreparationPlan::Stroke stroke(const toml::table& table) {
        toml_.allow(table, msg::kAStroke, {"from", "to"});
        if (table.get("from") == nullptr) toml_.fail(table, {msg::kKeyMissing, "from"});
        PreparationPlan::Stroke stroke{Vec3::Zero(), Vec3::Zero()};
        toml_.numbers(table, "from", {stroke.from.data(), 3});
        stroke.to = stroke.from;  // a pit
        toml_.numbers(table, "to", {stroke.to.data(), 3});
        const bool isNear = std::max(stroke.from.cwiseAbs().maxCoeff(), stroke.to.cwiseAbs().maxCoeff()) <= kFarthest;
        if (!isNear || (stroke.to - stroke.from).norm() > kLongestStroke) {
            toml_.fail(table, msg::kStrokeTooLong);
        }
        return stroke;
    }

    TomlReader toml_;
    const std::filesystem::path& folder_;
    double mesialX_ = 1;  // for a surface from a file +x
    Exercise exercise_;
};

}  // namespace

Expected<Exercise> parseExercise(std::string_view text, const std::string& name, const std::filesystem::path& folder) {
    return ExerciseReader(name, folder).read(text);
}

std::span<const std::shared_ptr<const Exercise>> exercises() {
    static const std::vector<std::shared_ptr<const Exercise>> all = [] {
        std::vector<std::shared_ptr<const Exercise>> list;
        for (const auto& [name, text] : builtinExerciseTexts()) {
            Expected<Exercise> exercise = parseExercise(text, name, {});
            TACTOOTH_ASSERT(exercise.has_value());  // a test reads each of them
            if (exercise) list.push_back(std::make_shared<const Exercise>(std::move(*exercise)));
        }
        return list;
    }();
    return all;
}

Expected<Exercise> readExercise(const std::filesystem::path& file) {
    const Expected<FileBytes> bytes = readFile(file, kTomlLimits.bytes);
    if (!bytes) return Unexpected{bytes.error()};
    Expected<Exercise> exercise = parseExercise(bytes->text(), displayName(file), file.parent_path());
    if (exercise) exercise->file = file;
    return exercise;
}

}  // namespace tactooth
