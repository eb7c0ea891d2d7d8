// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/exercise_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assessment/messages.h"
#include "assessment/rubric/rubric_file.h"
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

constexpr double kMostLeft = 10;      // mm of tooth beside a cavity: a whole crown
constexpr double kWidestOutline = 8;  // mm
constexpr double kMaxBox = 6;         // mm: any measure of a proximal box
constexpr int kMostMinutes = 600;
constexpr double kLeastTolerance = 0.02, kMostTolerance = 2;  // mm

/// Their names in files, in the order of the enumerations.
constexpr std::array<std::string_view, 8> kGroups = {"hand-eye", "caries",  "class-1",    "class-2",
                                                     "class-3",  "class-5", "endodontic", "own"};
constexpr std::array<std::string_view, 3> kLevels = {"easy", "usual", "hard"};

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
                    {"name", "task", "brief", "japanese", "group", "level", "minutes", "tolerance", "rubric", "tooth",
                     "mouth", "patient", "decay", "layers", "bur", "other_burs", "ideal", "cavity"});
        exercise_.name = toml_.text(root, "name", true);
        exercise_.task = toml_.text(root, "task", true);
        exercise_.brief = toml_.text(root, "brief", false);
        if (const toml::table* japanese = toml_.table(root, "japanese")) {
            toml_.allow(*japanese, msg::kJapaneseWords, {"name", "task", "brief"});
            exercise_.japanese = {toml_.text(*japanese, "name", true), toml_.text(*japanese, "task", true),
                                  toml_.text(*japanese, "brief", false)};
        }
        readFrame(root);
        readTooth(root);
        readBur(root);
        readIdeal(root);
    }

    /// What the exercise trains, for how long, and how it is judged.
    void readFrame(const toml::table& root) {
        exercise_.group = static_cast<ExerciseGroup>(
            choice(root, "group", kGroups, msg::kGroupUnknown, static_cast<std::size_t>(ExerciseGroup::Own)));
        exercise_.level = static_cast<ExerciseLevel>(
            choice(root, "level", kLevels, msg::kExerciseLevelUnknown, static_cast<std::size_t>(ExerciseLevel::Usual)));
        if (root.get("minutes") != nullptr) exercise_.minutes = toml_.integer(root, "minutes", 1, 1, kMostMinutes);
        exercise_.tolerance = toml_.number(root, "tolerance", exercise_.tolerance, kLeastTolerance, kMostTolerance);
        exercise_.rubric = toml_.text(root, "rubric", false);
        if (exercise_.rubric.ends_with(".toml"))
            exercise_.rubric = beside(*root.get("rubric"), exercise_.rubric).string();
        else if (!exercise_.rubric.empty())
            if (const auto rubric = findRubric(exercise_.rubric); !rubric)
                toml_.fail(*root.get("rubric"), {msg::kNoSuchRubric, quotedWord(exercise_.rubric)});
    }

    /// The place of a word in the list of those that a key may have.
    template <std::size_t N>
    std::size_t choice(const toml::table& table, std::string_view key, const std::array<std::string_view, N>& words,
                       const MessageText& mistake, std::size_t fallback) {
        const std::string word = toml_.text(table, key, false);
        if (word.empty()) return fallback;
        const auto* const known = std::ranges::find(words, word);
        if (known != words.end()) return static_cast<std::size_t>(known - words.begin());
        toml_.fail(*table.get(key), mistake);
        return fallback;
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
        if (root.get("layers") != nullptr) toml_.fail(*root.get("layers"), msg::kBuiltinToothHasLayers);
        if (exercise_.inMouth && request.seed != 0) toml_.fail(*root.get("mouth"), msg::kMouthIsAverage);
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
        for (const std::string_view key : {"patient", "decay", "mouth"}) {
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
        toml_.allow(cavity, msg::kACavity,
                    {"side", "depth", "floor", "depth_stop", "strokes", "fissure", "boxes", "removes"});
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
        if (const toml::table* fissure = toml_.table(cavity, "fissure")) {
            const bool fits = plan.isFlat && plan.outward == Vec3::UnitZ() && strokes.empty();
            if (!fits) toml_.fail(*fissure, msg::kFissureUnfit);
            readFissure(*fissure, toml_.tables(cavity, "boxes"), plan);
            return plan;
        }
        if (const toml::table* body = toml_.table(cavity, "removes")) {
            if (!strokes.empty()) toml_.fail(*body, msg::kBodyUnfit);
            readBody(*body, plan);
            return plan;
        }
        if (cavity.get("boxes") != nullptr) toml_.fail(*cavity.get("boxes"), msg::kBoxWithoutFissure);
        if (strokes.empty()) toml_.fail(cavity, msg::kNoStrokes);
        if (strokes.size() > kMaxStrokes) toml_.fail(cavity, msg::kTooManyStrokes);
        for (const toml::table* stroke : strokes) plan.strokes.push_back(this->stroke(*stroke));
        return plan;
    }

    [[nodiscard]] std::optional<BurSpec> catalogueBur() const {
        const auto* number = std::get_if<std::string>(&exercise_.bur);
        return number != nullptr ? findBur(*number) : std::nullopt;
    }

    /// An outline along the fissure, with the boxes at its ends.
    void readFissure(const toml::table& table, const std::vector<const toml::table*>& boxes, PreparationPlan& plan) {
        toml_.allow(table, msg::kAFissure, {"width", "mesial", "distal"});
        const auto* request = std::get_if<ToothRequest>(&exercise_.tooth);
        if (request != nullptr && isAnteriorTooth(request->fdi)) toml_.fail(table, msg::kNoFissure);
        const std::optional<BurSpec> bur = catalogueBur();
        if (!bur) return toml_.fail(table, msg::kOutlineNeedsBur);
        for (const toml::table* box : boxes) plan.boxes.push_back(this->box(*box, bur->headDiameter));
        if (plan.boxes.size() > 2 || (plan.boxes.size() == 2 && plan.boxes[0].towardX == plan.boxes[1].towardX))
            toml_.fail(*boxes.back(), msg::kBoxTwice);
        FissureOutline outline{
            .width = toml_.number(table, "width", bur->headDiameter, bur->headDiameter, kWidestOutline),
            .burRadius = bur->headDiameter / 2,
            .leftPlusX = {},
            .leftMinusX = {}};
        for (const std::string_view name : {"mesial", "distal"}) {
            const double towardX = name == "mesial" ? mesialX_ : -mesialX_;
            const bool hasBox = std::ranges::count(plan.boxes, towardX, &ProximalBox::towardX) > 0;
            if (hasBox == (table.get(name) != nullptr)) toml_.fail(table, {msg::kRidgeOrBox, name});
            if (!hasBox)
                (towardX > 0 ? outline.leftPlusX : outline.leftMinusX) = toml_.number(table, name, 0, 0, kMostLeft);
        }
        plan.fissure = outline;
    }

    /// A body inside the tooth that the cavity removes.
    void readBody(const toml::table& table, PreparationPlan& plan) {
        toml_.allow(table, msg::kABody, {"tissue", "below"});
        constexpr std::array<std::string_view, 2> kTissues = {"caries", "pulp"};
        const bool isPulp = choice(table, "tissue", kTissues, msg::kTissueUnknown, 0) == 1;
        const std::optional<BurSpec> bur = catalogueBur();
        if (!bur) return toml_.fail(table, msg::kOutlineNeedsBur);
        plan.body = {.role = isPulp ? MaterialRole::Pulp : MaterialRole::Decay,
                     .burRadius = bur->headDiameter / 2,
                     .burLength = bur->headLength,
                     .below = {}};
        if (isPulp && table.get("below") == nullptr) toml_.fail(table, {msg::kKeyMissing, "below"});
        if (table.get("below") != nullptr) plan.body->below = toml_.number(table, "below", 1, kMinDepth, kMaxDepth);
    }

    ProximalBox box(const toml::table& table, double diameter) {
        toml_.allow(table, msg::kABox, {"side", "width", "axial_depth", "axial_height"});
        for (const std::string_view key : {"width", "axial_depth", "axial_height"}) {
            if (table.get(key) == nullptr) toml_.fail(table, {msg::kKeyMissing, key});
        }
        constexpr std::array<std::string_view, 2> kSidesOfBox = {"mesial", "distal"};
        const bool isDistal = choice(table, "side", kSidesOfBox, msg::kBoxSide, 0) == 1;
        return {.towardX = isDistal ? -mesialX_ : mesialX_,
                .width = toml_.number(table, "width", diameter, diameter, kMaxBox),
                .axialDepth = toml_.number(table, "axial_depth", diameter, diameter, kMaxBox),
                .axialHeight = toml_.number(table, "axial_height", 1, kMinDepth, kMaxBox)};
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
        toml_.allow(table, msg::kAStroke, {"from", "to", "depth"});
        if (table.get("from") == nullptr) toml_.fail(table, {msg::kKeyMissing, "from"});
        PreparationPlan::Stroke stroke{Vec3::Zero(), Vec3::Zero(), {}};
        toml_.numbers(table, "from", {stroke.from.data(), 3});
        stroke.to = stroke.from;  // a pit
        toml_.numbers(table, "to", {stroke.to.data(), 3});
        if (table.get("depth") != nullptr) stroke.depth = toml_.number(table, "depth", 1, kMinDepth, kMaxDepth);
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

Expected<Exercise> readExercise(const std::filesystem::path& file) {
    const Expected<FileBytes> bytes = readFile(file, kTomlLimits.bytes);
    if (!bytes) return Unexpected{bytes.error()};
    Expected<Exercise> exercise = parseExercise(bytes->text(), displayName(file), file.parent_path());
    if (exercise) exercise->file = file;
    return exercise;
}

}  // namespace tactooth
