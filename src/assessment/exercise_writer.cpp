// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/exercise_writer.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "assessment/exercise_keys.h"
#include "assessment/messages.h"
#include "geometry/files/atomic_file.h"
#include "geometry/util/number_text.h"
#include "session/cases/case_store.h"
#include "session/io/material_table.h"
#include "session/io/toml_text.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

std::string numbersText(const Vec3& place) {
    return fmt::format("[{}, {}, {}]", numberText(place.x()), numberText(place.y()), numberText(place.z()));
}

std::string wordsText(const ExerciseWords& words) {
    std::string text = fmt::format("name = {}\ntask = {}\n", tomlText(words.name), tomlText(words.task));
    if (!words.brief.empty()) text += fmt::format("brief = {}\n", tomlText(words.brief));
    return text;
}

class ExerciseWriter {
public:
    ExerciseWriter(const Exercise& exercise, const fs::path& folder)
        : exercise_(exercise), folder_(folder), mesialX_(toothMesialX(exercise.tooth)) {}

    Expected<std::string> write() {
        text_ = wordsText({exercise_.name, exercise_.task, exercise_.brief});
        addFrame();
        if (const auto* request = std::get_if<ToothRequest>(&exercise_.tooth)) addTooth(*request);
        if (const auto* source = std::get_if<ToothSource>(&exercise_.tooth)) addTooth(*source);
        addBurs();
        if (const auto* file = std::get_if<fs::path>(&exercise_.ideal))
            text_ += fmt::format("ideal = {}\n", tomlText(beside(*file)));
        if (!exercise_.japanese.name.empty()) text_ += "\n[japanese]\n" + wordsText(exercise_.japanese);
        if (const auto* plan = std::get_if<PreparationPlan>(&exercise_.ideal)) addPlan(*plan);
        for (const ForbiddenZone& zone : exercise_.forbidden) {
            text_ += "\n[[forbidden]]\n" + sideText(zone.outward) + cornersText(zone.corners);
        }
        addMaterials();
        if (fault_) return Unexpected{*fault_};
        return std::move(text_);
    }

private:
    template <class... Arguments>
    void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    }

    /// The name of a file in the text.
    std::string beside(const fs::path& file) {
        std::string entry = file.lexically_relative(folder_).generic_string();
        if (folder_.empty()) entry = file.generic_string();
        if (!fault_ && !isSafeEntry(entry)) fault_ = Error{msg::kMustLieInFolder, file.string(), folder_.string()};
        return entry;
    }

    void addFrame() {
        if (exercise_.group != ExerciseGroup::Own)
            add("group = \"{}\"\n", kGroupKeys.at(static_cast<std::size_t>(exercise_.group)));
        if (exercise_.level != ExerciseLevel::Usual)
            add("level = \"{}\"\n", kLevelKeys.at(static_cast<std::size_t>(exercise_.level)));
        if (exercise_.minutes) add("minutes = {}\n", *exercise_.minutes);
        if (exercise_.tolerance != Exercise{}.tolerance) add("tolerance = {}\n", numberText(exercise_.tolerance));
        if (exercise_.view != StartView::Cavity)
            add("view = \"{}\"\n", kViewKeys.at(static_cast<std::size_t>(exercise_.view)));
        const bool isFile = exercise_.rubric.ends_with(".toml");
        if (!exercise_.rubric.empty())
            add("rubric = {}\n", tomlText(isFile ? beside(exercise_.rubric) : exercise_.rubric));
    }

    void addTooth(const ToothRequest& request) {
        add("tooth = {}\n", request.fdi);
        if (exercise_.inMouth) text_ += "mouth = true\n";
        if (request.seed != 0) add("patient = {}\n", request.seed);
        if (request.filling) addFilling(*request.filling);
        if (!request.lesion) return;
        const Lesion& lesion = *request.lesion;
        text_ += "decay = {";
        for (const auto& [key, site] : kSiteKeys) {
            if (!lesion.place && site == lesion.site) add("site = \"{}\", ", key);
        }
        if (lesion.place) add("at = {}, ", numbersText(*lesion.place));
        add("width = {}", numberText(lesion.width));
        if (lesion.depth) add(", depth = {}", numberText(*lesion.depth));
        for (const Vec3& place : lesion.spread)
            add("{}{}", &place == lesion.spread.data() ? ", spread = [" : ", ", numbersText(place));
        if (!lesion.spread.empty()) text_ += "]";
        if (lesion.rim)
            add(", rim = {{width = {}, material = \"{}\"}}", numberText(lesion.rim->width),
                lesion.rim->materials->nameOf(lesion.rim->material));
        text_ += "}\n";
    }

    /// Those that the exercise brings or changes.
    void addMaterials() {
        for (const MaterialDefinition& material : exercise_.materials->definitions()) {
            const auto known = builtinMaterials().find(material.name);
            if (!known || builtinMaterials()[*known] != material)
                text_ += materialBlock(material, "materials." + material.name);
        }
    }

    void addFilling(const Filling& filling) {
        text_ += "filling = {";
        for (const auto& [key, site] : kSiteKeys) {
            if (site == filling.site) add("site = \"{}\", ", key);
        }
        add("width = {}, depth = {}, material = \"{}\"}}\n", numberText(filling.width), numberText(filling.depth),
            filling.materials->nameOf(filling.material));
    }

    void addTooth(const ToothSource& source) {
        add("tooth = {}\n", tomlText(beside(source.outer)));
        if (source.layers.empty()) return;
        text_ += "layers = {";
        for (const ToothSource::Layer& layer : source.layers) {
            add("{}{} = {}", &layer == source.layers.data() ? "" : ", ", layer.material, tomlText(beside(layer.file)));
        }
        text_ += "}\n";
    }

    void addBurs() {
        const auto* file = std::get_if<fs::path>(&exercise_.bur);
        add("bur = {}\n", tomlText(file != nullptr ? beside(*file) : std::get<std::string>(exercise_.bur)));
        if (!exercise_.otherBurs.empty()) {
            text_ += "other_burs = [";
            for (const std::string& bur : exercise_.otherBurs)
                add("{}{}", &bur == exercise_.otherBurs.data() ? "" : ", ", tomlText(bur));
            text_ += "]\n";
        }
        if (exercise_.onlyTheseBurs) text_ += "only_these_burs = true\n";
        if (!exercise_.instruments.empty()) addInstruments();
    }

    void addInstruments() {
        text_ += "instruments = [";
        bool isFirst = true;
        for (const TrayInstrument& each : exercise_.instruments) {
            for (const auto& [key, instrument] : kInstrumentKeys) {
                if (instrument == each) add("{}\"{}\"", std::exchange(isFirst, false) ? "" : ", ", key);
            }
        }
        text_ += "]\n";
    }

    /// Empty for the occlusal side.
    [[nodiscard]] std::string sideText(const Vec3& outward) const {
        if (outward == Vec3::UnitZ()) return {};
        for (const auto& [key, direction] : sideKeys(mesialX_)) {
            if (outward == direction) return fmt::format("side = \"{}\"\n", key);
        }
        return fmt::format("side = {}\n", numbersText(outward));
    }

    static std::string cornersText(const std::vector<Vec3>& corners) {
        std::string text = "corners = [\n";
        for (const Vec3& corner : corners) text += "  " + numbersText(corner) + ",\n";
        return text + "]\n";
    }

    void addPlan(const PreparationPlan& plan) {
        text_ += "\n[cavity]\n" + sideText(plan.outward);
        add("depth = {}\n", numberText(plan.depth));
        if (!plan.isFlat) text_ += "floor = \"surface\"\n";
        if (plan.stopsDevice) text_ += "depth_stop = true\n";
        for (const PreparationPlan::Stroke& stroke : plan.strokes) {
            add("\n[[cavity.strokes]]\nfrom = {}\n", numbersText(stroke.from));
            if (stroke.to != stroke.from) add("to = {}\n", numbersText(stroke.to));
            if (stroke.depth) add("depth = {}\n", numberText(*stroke.depth));
        }
        if (plan.fissure) addFissure(*plan.fissure);
        if (plan.outline) {
            text_ += "\n[cavity.outline]\n";
            if (plan.outline->taperDegrees != 0) add("taper = {}\n", numberText(plan.outline->taperDegrees));
            text_ += cornersText(plan.outline->corners);
        }
        for (const ProximalBox& box : plan.boxes) {
            add("\n[[cavity.boxes]]\nside = \"{}\"\nwidth = {}\naxial_depth = {}\naxial_height = {}\n",
                box.towardX == mesialX_ ? "mesial" : "distal", numberText(box.width), numberText(box.axialDepth),
                numberText(box.axialHeight));
        }
        if (plan.crown) addCrown(*plan.crown);
        if (!plan.body) return;
        for (const auto& [key, role] : kBodyKeys) {
            if (role == plan.body->role) add("\n[cavity.removes]\ntissue = \"{}\"\n", key);
        }
        if (plan.body->below) add("below = {}\n", numberText(*plan.body->below));
        for (const auto& [key, direction] : sideKeys(mesialX_)) {
            if (plan.body->openTo == direction) add("open = \"{}\"\n", key);
        }
    }

    void addCrown(const CrownOutline& crown) {
        add("\n[cavity.crown]\nfinish = \"{}\"\n", crown.tipRadius >= crown.width ? "chamfer" : "shoulder");
        add("width = {}\nheight = {}\n", numberText(crown.width), numberText(crown.height));
        add("mesial_height = {}\ndistal_height = {}\n",
            numberText(mesialX_ > 0 ? crown.plusXHeight : crown.minusXHeight),
            numberText(mesialX_ > 0 ? crown.minusXHeight : crown.plusXHeight));
        add("taper = {}\n", numberText(crown.taper));
        if (crown.buccalTaper != crown.taper) add("buccal_taper = {}\n", numberText(crown.buccalTaper));
        add("buccal = {}\nlingual = {}\n", numberText(crown.buccal), numberText(crown.lingual));
        if (crown.rounding > 0) add("rounding = {}\n", numberText(crown.rounding));
        if (crown.isIncisal) {
            add("incisal = {}\n", numberText(crown.occlusal));
        } else {
            add("occlusal = {}\nfunctional = {}\n", numberText(crown.occlusal), numberText(crown.functional));
            add("functional_side = \"{}\"\n", crown.functionalSide > 0 ? "buccal" : "lingual");
        }
        if (crown.cervical) add("cervical = {}\n", numberText(*crown.cervical));
    }

    void addFissure(const FissureOutline& fissure) {
        add("\n[cavity.fissure]\nwidth = {}\n", numberText(fissure.width));
        const auto& mesial = mesialX_ > 0 ? fissure.leftPlusX : fissure.leftMinusX;
        const auto& distal = mesialX_ > 0 ? fissure.leftMinusX : fissure.leftPlusX;
        if (mesial) add("mesial = {}\n", numberText(*mesial));
        if (distal) add("distal = {}\n", numberText(*distal));
    }

    const Exercise& exercise_;
    const fs::path& folder_;
    double mesialX_;
    std::string text_;
    std::optional<Error> fault_;  // the first
};

}  // namespace

Expected<std::string> exerciseText(const Exercise& exercise, const fs::path& folder) {
    return ExerciseWriter(exercise, folder).write();
}

Expected<void> writeExercise(const Exercise& exercise, const fs::path& file) {
    const Expected<std::string> text = exerciseText(exercise, file.parent_path());
    if (!text) return Unexpected{text.error()};
    return writeFile(file, *text);
}

}  // namespace tactooth
