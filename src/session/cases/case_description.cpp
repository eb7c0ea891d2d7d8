// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/case_description.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "geometry/util/display_text.h"
#include "geometry/util/number_text.h"
#include "instruments/builtin_tooth.h"
#include "session/cases/case_store.h"
#include "session/cases/messages.h"
#include "session/io/messages.h"
#include "session/io/toml_reader.h"
#include "session/io/toml_text.h"
#include "session/io/unicode_text.h"

namespace tactooth {
namespace {

constexpr int kFormat = 1;
constexpr std::size_t kMaxBodies = 200;  // teeth and bodies around them: a mouth has 32 teeth
constexpr double kFarthest = 1000;       // mm from the case's origin

class CaseReader {
public:
    CaseReader(std::string_view name, const ReadCaseMaterials& readMaterials)
        : toml_(name), readMaterials_(readMaterials) {}

    Expected<CaseDescription> read(std::string_view text) {
        const toml::table root = toml_.parse(text);
        if (!toml_.error()) readAll(root);
        if (toml_.error()) return Unexpected{*toml_.error()};
        if (badMaterials_) return Unexpected{*badMaterials_};
        return std::move(case_);
    }

private:
    void readAll(const toml::table& root) {
        toml_.allow(root, msg::kACase,
                    {"format", "title", "licence", "provenance", "materials", "tooth", "around", "bur"});
        if (root.get("format") == nullptr) toml_.fail(root, msg::kCaseFormatMissing);
        const int format = toml_.integer(root, "format", kFormat, 1, 1'000'000);
        if (format > kFormat) {
            return toml_.fail(*root.get("format"), {msg::kCaseTooNew, format});
        }
        case_.title = toml_.text(root, "title", true);
        case_.licence = toml_.text(root, "licence", false);
        case_.provenance = toml_.texts(root, "provenance");
        case_.materials = entry(root, "materials", false);
        if (!case_.materials.empty() && readMaterials_ && !toml_.error()) {
            const auto registry = readMaterials_(case_.materials);
            if (!registry) return void(badMaterials_ = registry.error());
            case_.registry = *registry;
        }
        const auto teeth = toml_.tables(root, "tooth"), around = toml_.tables(root, "around");
        if (teeth.empty()) toml_.fail(root, msg::kCaseNoTooth);
        if (teeth.size() + around.size() > kMaxBodies) return toml_.fail(*teeth.front(), msg::kCaseTooManyTeeth);
        for (const toml::table* table : teeth) readTooth(*table);
        for (const toml::table* table : around) readSurrounding(*table);
        for (const toml::table* table : toml_.tables(root, "bur")) {
            toml_.allow(*table, msg::kABur, {"file"});
            case_.burs.push_back(entry(*table, "file", true));
        }
    }

    void readTooth(const toml::table& table) {
        toml_.allow(table, msg::kATooth,
                    {"name", "fdi", "outer", "layers", "material", "modelled", "position", "rotation", "assumed"});
        CaseTooth tooth;
        tooth.material = case_.registry->withRole(MaterialRole::Enamel);
        tooth.name = uniqueName(table);
        tooth.fdi = toml_.integer(table, "fdi", 0, 0, 99);
        if (tooth.fdi != 0 && !isPermanentTooth(tooth.fdi)) {
            toml_.fail(*table.get("fdi"), {msg::kNoPermanentTooth, tooth.fdi});
        }
        tooth.outer = entry(table, "outer", true);
        if (const toml::table* layers = toml_.table(table, "layers")) {
            for (auto&& [name, unused] : *layers) {
                const auto id = material(*layers, name.str(), name.str());
                tooth.layers.emplace_back(id, entry(*layers, name.str(), true));
            }
            std::ranges::sort(tooth.layers, {}, [](const auto& layer) { return layer.first; });
        }
        if (table.get("material") != nullptr) {
            tooth.material = material(table, "material", toml_.text(table, "material", true));
        }
        tooth.isModelled = toml_.flag(table, "modelled", false);
        tooth.toothInCase = pose(table);
        tooth.assumed = toml_.texts(table, "assumed");
        case_.teeth.push_back(std::move(tooth));
    }

    void readSurrounding(const toml::table& table) {
        toml_.allow(table, msg::kABodyAround, {"name", "surface", "material", "position", "rotation", "assumed"});
        CaseSurrounding body;
        body.material = case_.registry->withRole(MaterialRole::Surroundings);
        body.name = uniqueName(table);
        body.surface = entry(table, "surface", true);
        if (table.get("material") != nullptr) {
            body.material = material(table, "material", toml_.text(table, "material", true));
        }
        body.bodyInCase = pose(table);
        body.assumed = toml_.texts(table, "assumed");
        case_.around.push_back(std::move(body));
    }

    std::string uniqueName(const toml::table& table) {
        std::string name = toml_.text(table, "name", true);
        if (name.find_first_of("/\\") != std::string::npos || name.size() > 60) {
            toml_.fail(*table.get("name"), msg::kCaseNameTooLong);
        }
        if (!name.empty() && !names_.insert(name).second) {
            toml_.fail(*table.get("name"), {msg::kCaseNameTwice, quotedWord(name)});
        }
        return name;
    }

    std::string entry(const toml::table& table, std::string_view key, bool isNeeded) {
        std::string path = toml_.text(table, key, isNeeded);
        const EntryFault fault = path.empty() ? EntryFault::None : entryName(path).fault;
        if (fault != EntryFault::None) toml_.fail(*table.get(key), inWords(fault, quotedWord(path)));
        return path;
    }

    MaterialId material(const toml::table& table, std::string_view key, std::string_view name) {
        if (const auto id = case_.registry->find(name)) return *id;
        toml_.fail(*table.get(key), {msg::kMaterialUnknown, quotedWord(name), case_.registry->names()});
        return {};
    }

    Pose pose(const toml::table& table) {
        std::array<double, 3> position = {0, 0, 0};
        std::array<double, 4> turn = {1, 0, 0, 0};
        toml_.numbers(table, "position", position);
        toml_.numbers(table, "rotation", turn);
        const Quat rotation(turn[0], turn[1], turn[2], turn[3]);
        constexpr double kRounding = 1e-3;  // people write four digits
        if (std::abs(rotation.norm() - 1) > kRounding) {
            toml_.fail(*table.get("rotation"), msg::kCaseRotation);
            return {};
        }
        const Vec3 place(position[0], position[1], position[2]);
        if (place.cwiseAbs().maxCoeff() > kFarthest) {
            toml_.fail(*table.get("position"), msg::kCasePosition);
            return {};
        }
        constexpr double kExact = 1e-12;  // numbers that this program has written come back bit for bit
        return {place, std::abs(rotation.norm() - 1) < kExact ? rotation : rotation.normalized()};
    }

    TomlReader toml_;
    const ReadCaseMaterials& readMaterials_;
    std::optional<Error> badMaterials_;  // in their own file
    CaseDescription case_;
    std::set<std::string> names_;
};

std::string list(const std::vector<std::string>& texts, const std::string& indent) {
    std::string result = "[\n";
    for (const std::string& text : texts) result += indent + "  " + tomlText(text) + ",\n";
    return result + indent + "]\n";
}

/// A TOML float that reads as the same double.
std::string exact(double value) {
    const std::string number = numberText(value);
    return number.find_first_of(".en") == std::string::npos ? number + ".0" : number;
}

std::string poseText(const Pose& pose) {
    const Vec3& p = pose.position;
    const Quat& q = pose.rotation;
    return "position = [" + exact(p.x()) + ", " + exact(p.y()) + ", " + exact(p.z()) + "]\nrotation = [" +
           exact(q.w()) + ", " + exact(q.x()) + ", " + exact(q.y()) + ", " + exact(q.z()) +
           "]  # quaternion, w first\n";
}

std::string toothText(const CaseTooth& tooth, const MaterialRegistry& materials) {
    std::string text = "\n[[tooth]]\nname = " + tomlText(tooth.name) + "\n";
    if (tooth.fdi != 0) text += "fdi = " + std::to_string(tooth.fdi) + "\n";
    text += "outer = " + tomlText(tooth.outer) + "\n";
    if (tooth.layers.empty()) {
        text += "material = " + tomlText(materials.nameOf(tooth.material)) + "\n";
    } else {
        text += "layers = { ";
        for (const auto& [id, file] : tooth.layers) {
            text += (id == tooth.layers.front().first ? "" : ", ") + materials.nameOf(id) + " = " + tomlText(file);
        }
        text += " }\n";
    }
    if (tooth.isModelled) text += "modelled = true  # the layers are a model, no measurement\n";
    text += poseText(tooth.toothInCase);
    if (!tooth.assumed.empty()) text += "assumed = " + list(tooth.assumed, "");
    return text;
}

}  // namespace

Expected<CaseDescription> parseCase(std::string_view text, std::string_view name,
                                    const ReadCaseMaterials& readMaterials) {
    return CaseReader(name, readMaterials).read(text);
}

std::string caseText(const CaseDescription& description) {
    std::string text =
        "# A case for Tactooth: lengths in mm, paths inside this folder. See docs/cases.md.\nformat = 1\n";
    text += "title = " + tomlText(description.title) + "\nlicence = " + tomlText(description.licence) + "\n";
    if (!description.provenance.empty()) text += "provenance = " + list(description.provenance, "");
    if (!description.materials.empty()) text += "materials = " + tomlText(description.materials) + "\n";
    for (const CaseTooth& tooth : description.teeth) text += toothText(tooth, *description.registry);
    for (const CaseSurrounding& body : description.around) {
        text += "\n[[around]]\nname = " + tomlText(body.name) + "\nsurface = " + tomlText(body.surface) +
                "\nmaterial = " + tomlText(description.registry->nameOf(body.material)) + "\n" +
                poseText(body.bodyInCase);
        if (!body.assumed.empty()) text += "assumed = " + list(body.assumed, "");
    }
    for (const std::string& file : description.burs) text += "\n[[bur]]\nfile = " + tomlText(file) + "\n";
    return text;
}

}  // namespace tactooth
