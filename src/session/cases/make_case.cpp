// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/make_case.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "geometry/atomic_file.h"
#include "geometry/file_bytes.h"
#include "geometry/mesh_file.h"
#include "geometry/stl_writer.h"
#include "instruments/builtin_tooth.h"
#include "patient/dental_arch.h"
#include "patient/length_unit.h"
#include "session/cases/own_bur.h"
#include "session/experiments/run_facts.h"
#include "session/material_file.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
    for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return text;
}

bool isSurfaceFile(const fs::path& path) {
    const std::string ending = lower(path.extension().string());
    return ending == ".stl" || ending == ".obj" || ending == ".ply";
}

/// All surfaces that the paths name, sorted, so that the same folder gives the same case.
Expected<std::vector<fs::path>> surfaceFiles(const std::vector<fs::path>& from) {
    std::vector<fs::path> files;
    for (const fs::path& path : from) {
        std::error_code error;
        if (!fs::is_directory(path, error)) {
            files.push_back(path);
            continue;
        }
        for (fs::recursive_directory_iterator at(path, error), end; !error && at != end; at.increment(error)) {
            if (isSurfaceFile(at->path()) && at->is_regular_file(error)) files.push_back(at->path());
            if (files.size() > kCaseLimits.entries) {
                return unexpected(shownName(path) + ": the folder holds too many surfaces for one case.");
            }
        }
        if (error) return unexpected(shownName(path) + ": the folder cannot be read (" + error.message() + ").");
    }
    std::ranges::sort(files);
    if (files.empty()) return unexpected("there is no STL, OBJ or PLY file to make a case of.");
    return files;
}

int fdiOf(const std::string& name, const std::optional<int>& quadrant) {
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;  // npos + 1 = 0
    const std::string number = name.substr(digits);
    if (number.size() == 2 && isPermanentTooth(std::stoi(number))) return std::stoi(number);
    if (quadrant && number.size() == 1 && number[0] >= '1' && number[0] <= '8')
        return *quadrant * 10 + (number[0] - '0');
    return 0;
}

/// Letters, digits, '-' and '_' alone, as every file system takes them.
std::string entryName(const std::string& name) {
    std::string entry;
    for (const char letter : name) {
        entry += std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' ? letter : '-';
    }
    return entry;
}

std::vector<std::string> words(const std::vector<Remark>& remarks) {
    std::vector<std::string> sentences;
    for (const Remark& remark : remarks) sentences.push_back(inWords(remark));
    return sentences;
}

std::vector<std::byte> bytesOf(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

class CaseMaker {
public:
    CaseMaker(const CaseRequest& request, const CaseProgress& progress) : request_(request), progress_(progress) {}

    Expected<MadeCase> make() {
        if (auto done = readSurfaces(); !done) return Unexpected{done.error()};
        if (scans_.size() > 1) {
            if (auto done = shareOneFrame(); !done) return Unexpected{done.error()};
        }
        for (const Scan& scan : scans_) {
            if (auto done = import(scan); !done) return Unexpected{done.error()};
        }
        for (const auto& [name, mesh] : around_) {
            if (auto done = importAround(name, mesh); !done) return Unexpected{done.error()};
        }
        return finish();
    }

    Expected<MadeCase> makeOf(const ExaminedScan& tooth) {
        addTooth(tooth, {});
        return finish();
    }

private:
    Expected<void> readSurfaces() {
        const auto files = surfaceFiles(request_.from);
        if (!files) return Unexpected{files.error()};
        std::map<std::string, Scan> byName;
        for (const fs::path& file : *files) {
            auto mesh = loadMesh(file);
            if (!mesh) return Unexpected{mesh.error()};
            sources_.push_back(file.filename().string());
            const NamedSurface named = surfaceNamed(file);
            if (named.isAround) {
                around_[named.body] = std::move(*mesh);
                continue;
            }
            Scan& scan = byName[named.body];
            scan.name = named.body;
            if (!named.material) {
                if (!scan.outer.empty()) return twice(file);
                scan.outer = std::move(*mesh);
                continue;
            }
            for (const LayerMesh& layer : scan.layers) {
                if (layer.material == *named.material) return twice(file);
            }
            scan.layers.push_back({std::string(materialName(*named.material)), *named.material, std::move(*mesh)});
        }
        if (byName.empty())
            return unexpected("none of the surfaces is a tooth; name one TOOTH.stl or TOOTH_enamel.stl.");
        for (auto& [name, scan] : byName) scans_.push_back(std::move(scan));
        return {};
    }

    static Expected<void> twice(const fs::path& file) {
        return unexpected(shownName(file) + ": the case has this surface already; give each tooth its own name.");
    }

    /// Teeth of one jaw come in one unit, and their arch tells where the cheek is.
    Expected<void> shareOneFrame() {
        std::vector<double> longest;
        std::vector<Vec3> crowns;
        for (const Scan& scan : scans_) {
            Box3 box = boundingBox(scan.outer);
            for (const LayerMesh& layer : scan.layers) box.extend(boundingBox(layer.mesh));
            if (box.isEmpty()) return unexpected(scan.name + ": there is no surface.");
            longest.push_back(box.sizes().maxCoeff());
            Vec3 crown = box.center();
            for (const LayerMesh& layer : scan.layers) {
                if (layer.material == MaterialId::Enamel) crown = boundingBox(layer.mesh).center();
            }
            crowns.push_back(crown);
        }
        std::ranges::sort(longest);
        if (!request_.choices.mmPerUnit) {
            ScaleGuess guess = guessScale(longest[longest.size() / 2]);
            shared_.push_back(std::move(guess.why));
            mmPerUnit_ = guess.mmPerUnit;
        } else {
            mmPerUnit_ = *request_.choices.mmPerUnit;
        }
        for (Vec3& crown : crowns) crown *= mmPerUnit_;
        archMiddle_ = archMiddle(crowns);
        crowns_ = std::move(crowns);
        return {};
    }

    [[nodiscard]] bool goesOn(const std::string& name, double part) const {
        return !progress_ || progress_(name, part);
    }

    Expected<void> import(const Scan& scan) {
        ImportChoices choices = request_.choices;
        if (scans_.size() > 1) choices.mmPerUnit = mmPerUnit_;
        const auto place = static_cast<std::size_t>(&scan - scans_.data());
        if (archMiddle_) choices.frame.cheek = crowns_[place] - *archMiddle_;
        if (!goesOn(scan.name, 0)) return unexpected("stopped");
        auto examined = examineScan(scan, choices);
        if (!examined) return Unexpected{examined.error()};
        auto tooth = finishScan(std::move(*examined), choices, [&](double part) { return goesOn(scan.name, part); });
        if (!tooth) return Unexpected{tooth.error()};
        if (scans_.size() > 1 && !shared_.empty()) {
            // The unit was guessed for all teeth together.
            std::erase_if(tooth->remarks, [](const Remark& remark) { return remark.topic == RemarkTopic::Units; });
            tooth->remarks.insert(tooth->remarks.begin(), shared_.begin(), shared_.end());
        }
        const bool isAlone = scans_.size() == 1 && around_.empty();
        addTooth(*tooth, isAlone ? Pose() : tooth->toothInFile);
        if (mmPerUnit_ == 0) mmPerUnit_ = tooth->mmPerUnit;
        return {};
    }

    void addTooth(const ExaminedScan& tooth, const Pose& toothInCase) {
        CaseTooth entry;
        entry.name = tooth.name;
        entry.fdi = fdiOf(tooth.name, request_.quadrant);
        const std::string folder = "teeth/" + entryName(tooth.name) + "/";
        entry.outer = folder + "outer.stl";
        made_.files.push_back({entry.outer, stlBytes(tooth.outer)});
        for (const LayerMesh& layer : tooth.layers) {
            const bool isOuter = tooth.enamelIsOuter && layer.material == MaterialId::Enamel;
            const std::string file =
                isOuter ? entry.outer : folder + std::string(materialName(layer.material)) + ".stl";
            if (!isOuter) made_.files.push_back({file, stlBytes(layer.mesh)});
            entry.layers.emplace_back(layer.material, file);
        }
        std::ranges::sort(entry.layers, {}, [](const auto& layer) { return layer.first; });
        entry.isModelled = tooth.layersAreModelled;
        entry.toothInCase = toothInCase;
        entry.assumed = words(tooth.remarks);
        made_.description.teeth.push_back(std::move(entry));
    }

    Expected<void> importAround(const std::string& name, TriangleMesh mesh) {
        const double scale = mmPerUnit_;
        if (scale != 1) {
            for (Vec3f& vertex : mesh.vertices) vertex = (scale * vertex.cast<double>()).cast<float>();
        }
        const RepairedMesh mended = repaired(mesh, {.holes = request_.choices.holes});
        const auto tooth = LayeredTooth::make(mended.mesh);
        if (!tooth) {
            return unexpected(name + ": " + tooth.error().message +
                              ". Leave it out, or ask for all holes to be filled.");
        }
        CaseSurrounding body;
        body.name = name;
        body.surface = "around/" + entryName(name) + ".stl";
        body.assumed.push_back(mended.report.changedAnything() ? "The surface was mended."
                                                               : "Closed and sound as it came.");
        made_.files.push_back({body.surface, stlBytes(mended.mesh)});
        made_.description.around.push_back(std::move(body));
        return {};
    }

    Expected<void> addBurs() {
        for (std::size_t i = 0; i < request_.burs.size(); ++i) {
            const auto bur = readOwnBur(request_.burs[i]);
            if (!bur) return Unexpected{bur.error()};
            const std::string stem = "burs/" + std::to_string(i + 1);
            const bool isDiamond = bur->material == BurMaterial::diamond;
            std::string text = "name = " + tomlText(bur->name) + "\nsurface = \"" + std::to_string(i + 1) +
                               ".stl\"\nmaterial = \"" + (isDiamond ? "diamond" : "carbide") +
                               "\"\nflutes = " + std::to_string(bur->flutes) +
                               "\ngrit_um = " + rounded(bur->gritMicrometres, 1) +
                               "\nsharpness = " + rounded(bur->sharpness, 3) + "\n";
            made_.files.push_back({stem + ".toml", bytesOf(text)});
            made_.files.push_back({stem + ".stl", stlBytes(bur->surface)});
            made_.description.burs.push_back(stem + ".toml");
        }
        return {};
    }

    Expected<MadeCase> finish() {
        CaseDescription& description = made_.description;
        description.title = request_.title.empty() ? description.teeth.front().name : request_.title;
        description.licence = request_.licence.empty() ? "not stated" : request_.licence;
        if (!request_.provenance.empty()) description.provenance.push_back(request_.provenance);
        for (const std::string& file : sources_) description.provenance.push_back("from " + file);
        description.provenance.push_back("made " + currentRunFacts().date + " by Tactooth");
        if (!request_.materials.empty()) {
            if (const auto known = readMaterials(request_.materials); !known) return Unexpected{known.error()};
            const auto bytes = readFile(request_.materials);
            if (!bytes) return Unexpected{bytes.error()};
            made_.files.push_back({"materials.toml", {bytes->bytes().begin(), bytes->bytes().end()}});
            description.materials = "materials.toml";
        }
        if (auto done = addBurs(); !done) return Unexpected{done.error()};
        made_.files.push_back({std::string(kCaseText), bytesOf(caseText(description))});
        return std::move(made_);
    }

    const CaseRequest& request_;
    const CaseProgress& progress_;
    std::vector<std::string> sources_;
    std::vector<Scan> scans_;
    std::map<std::string, TriangleMesh> around_;
    double mmPerUnit_ = 0;  // of all teeth; 0: not known yet
    std::vector<Remark> shared_;
    std::vector<Vec3> crowns_;
    std::optional<Vec3> archMiddle_;
    MadeCase made_;
};

}  // namespace

NamedSurface surfaceNamed(const fs::path& file) {
    const std::string stem = file.stem().string();
    const std::size_t split = stem.find_last_of("_- ");
    const std::string last = lower(split == std::string::npos ? stem : stem.substr(split + 1));
    for (const std::string_view word : {"bone", "jaw", "gum", "gums", "gingiva", "mandible", "maxilla"}) {
        if (last == word) return {stem, std::nullopt, true};
    }
    if (split == std::string::npos || split == 0) return {stem, std::nullopt, false};
    const std::string body = stem.substr(0, split);
    if (last == "outer" || last == "whole") return {body, std::nullopt, false};
    if (const auto id = materialFromName(last)) return {body, id, false};
    return {stem, std::nullopt, false};
}

Expected<MadeCase> makeCase(const CaseRequest& request, const CaseProgress& progress) {
    return CaseMaker(request, progress).make();
}

Expected<MadeCase> caseOf(const ExaminedScan& tooth, const CaseRequest& request) {
    return CaseMaker(request, {}).makeOf(tooth);
}

Expected<void> writeCase(const std::vector<CaseFile>& files, const fs::path& to) {
    if (to.extension() == kCaseEnding) {
        const auto bytes = packedCase(files);
        if (!bytes) return Unexpected{bytes.error()};
        return writeFile(to, *bytes);
    }
    std::error_code error;
    if (fs::exists(to, error) && !(fs::is_directory(to, error) && fs::is_empty(to, error))) {
        return unexpected(shownName(to) + ": there is something already; give a new folder, or a name that ends in " +
                          std::string(kCaseEnding) + ".");
    }
    for (const CaseFile& file : files) {
        const fs::path path = to / fs::path(file.entry);
        fs::create_directories(path.parent_path(), error);
        if (auto written = writeFile(path, file.bytes); !written) return written;
    }
    return {};
}

}  // namespace tactooth
