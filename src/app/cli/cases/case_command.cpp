// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/case_command.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <numbers>
#include <set>

#include "app/cli/terminal/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/mesh/mesh_report.h"
#include "geometry/util/display_text.h"
#include "geometry/util/number_text.h"
#include "patient/length_unit.h"
#include "session/cases/make_case.h"
#include "session/cases/open_case.h"
#include "session/cases/write_case.h"
#include "session/io/unicode_text.h"

namespace tactooth {
namespace {

constexpr double kFinestUnit = 1e-6, kCoarsestUnit = 1e6;  // mm

Expected<ImportOptions> choicesOf(const CaseNewOptions& options) {
    ImportOptions choices;
    if (!options.units.empty()) {
        if (const auto unit = lengthUnitFromName(options.units)) {
            choices.mmPerUnit = unit->mm;
        } else if (const auto factor = toNumber<double>(options.units);
                   factor && *factor >= kFinestUnit && *factor <= kCoarsestUnit) {
            choices.mmPerUnit = *factor;
        } else {
            return unexpected(msg::kUnitUnknown, quotedWord(options.units));
        }
    }
    choices.holes = options.holes == "all"    ? HolesToFill::All
                    : options.holes == "none" ? HolesToFill::None
                                              : HolesToFill::Small;
    choices.frame.isFlipped = options.upsideDown;
    choices.frame.turn = options.turnDegrees * std::numbers::pi / 180;
    choices.modelsLayers = !options.noModel;
    return choices;
}

void printSentences(const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) print("    {}\n", displayText(sentence));
}

/// Example: "enamel, dentin and pulp (a model)".
std::string layersOf(const CaseTooth& tooth, const MaterialRegistry& materials) {
    if (tooth.layers.empty()) return "all " + materials.nameOf(tooth.material);
    std::string words;
    for (const auto& [id, file] : tooth.layers) words.append(words.empty() ? "" : ", ").append(materials.nameOf(id));
    return words + (tooth.isModelled ? " (a model)" : "");
}

void printBodies(const CaseDescription& description, bool withAssumptions) {
    for (const CaseTooth& tooth : description.teeth) {
        const Vec3& at = tooth.toothInCase.position;
        print("  tooth {}{}: {}; at {:.1f}, {:.1f}, {:.1f} mm\n", displayText(tooth.name),
              tooth.fdi != 0 ? fmt::format(" (FDI {})", tooth.fdi) : "", layersOf(tooth, *description.registry), at.x(),
              at.y(), at.z());
        if (withAssumptions) printSentences(tooth.assumed);
    }
    for (const CaseSurrounding& body : description.around) {
        print("  around: {}, taken as {}\n", displayText(body.name), description.registry->nameOf(body.material));
        if (withAssumptions) printSentences(body.assumed);
    }
    for (const std::string& bur : description.burs) print("  bur: {}\n", displayText(bur));
    if (!description.materials.empty()) print("  materials of its own: {}\n", displayText(description.materials));
}

/// Files that the description does not name. They may belong there, but the program does not use them.
std::vector<std::string> unusedFiles(const CaseStore& store, const CaseDescription& description) {
    std::set<std::string> used = {std::string(kCaseText), description.materials};
    for (const CaseTooth& tooth : description.teeth) {
        used.insert(tooth.outer);
        for (const auto& [id, file] : tooth.layers) used.insert(file);
    }
    for (const CaseSurrounding& body : description.around) used.insert(body.surface);
    std::vector<std::string> unused;
    const auto folderOf = [](const std::string& entry) { return entry.substr(0, entry.rfind('/') + 1); };
    for (const std::string& entry : store.entries()) {
        // The description of a bur names a surface file in the same folder.
        const bool isBesideBur = std::ranges::any_of(
            description.burs, [&](const std::string& bur) { return folderOf(bur) == folderOf(entry); });
        if (!used.contains(entry) && !isBesideBur) unused.push_back(entry);
    }
    return unused;
}

/// Reads the files that the packed case of a folder would contain.
Expected<std::vector<CaseFile>> filesOf(const CaseStore& store) {
    std::vector<CaseFile> files;
    for (const std::string& entry : store.entries()) {
        if (const std::string name = validUtf8(entry); name != entry) return unexpected(msg::kArchiveNeedsUtf8, name);
        auto bytes = store.read(entry);
        if (!bytes) return Unexpected{bytes.error()};
        files.push_back({entry, std::move(*bytes)});
    }
    return files;
}

}  // namespace

int runCaseNew(const CaseNewOptions& options) {
    const auto choices = choicesOf(options);
    if (!choices) return reportError(choices.error());
    if (const auto done = checkCaseTarget(options.out); !done) return reportError(done.error());
    FileTransaction set;
    for (const auto& input : options.from) set.reads(input);
    for (const auto& input : options.burs) set.reads(input);
    set.reads(options.materials);
    if (options.out.extension() == kCaseEnding) {
        if (const auto opened = set.open(options.out); !opened) return reportError(opened.error());
    }
    const CaseRequest request{options.from,     options.title, options.licence, options.provenance,
                              options.quadrant, *choices,      options.burs,    options.materials};
    std::string last;
    const auto made = makeCase(request, [&](const std::string& body, double /*part*/) {
        if (body != last) print("importing {}\n", displayText(body));
        last = body;
        std::fflush(stdout);
        return true;
    });
    if (!made) return reportError(made.error());
    if (const auto written = writeCase(made->files, options.out); !written) return reportError(written.error());
    if (const auto named = set.commit(); !named) return reportError(named.error());
    printBodies(made->description, true);
    print("{}: {} teeth and {} bodies around them; licence: {}\n", displayName(options.out),
          made->description.teeth.size(), made->description.around.size(), displayText(made->description.licence));
    return kExitOk;
}

int runCaseCheck(const CaseCheckOptions& options) {
    const auto store = CaseStore::open(options.path);
    if (!store) return reportError(store.error());
    const auto opened = openCase(*store);
    if (!opened) {
        reportError(opened.error());
        return kExitNegative;
    }
    printImportNotes(opened->importNotes);
    const auto bodies = caseBodies(*store, opened->description);
    if (!bodies) return reportError(bodies.error());
    for (const CaseBody& body : *bodies) {
        const MeshReport report = reportOn(body.surface);
        print("{}: {} triangles, closed\n", body.name, report.triangles);
        for (const std::string& finding : findings(report)) print("    {}\n", finding);
    }
    for (const CaseOverlap& overlap : overlaps(*bodies)) {
        print("{} and {} overlap, {:.3f} mm deep: a cut is not exact there\n", overlap.first, overlap.second,
              overlap.deepest);
    }
    for (const std::string& entry : unusedFiles(*store, opened->description)) {
        print("{}: case.toml does not name this file\n", displayName(entry));
    }
    print("{} can be opened\n", displayName(options.path));
    return kExitOk;
}

int runCaseInfo(const CaseInfoOptions& options) {
    const auto store = CaseStore::open(options.path);
    if (!store) return reportError(store.error());
    const auto description = readCaseDescription(*store);
    if (!description) return reportError(description.error());
    print("{}\nlicence: {}\n", description->title, description->licence);
    for (const std::string& line : description->provenance) print("  {}\n", line);
    printBodies(*description, true);
    return kExitOk;
}

int runCasePack(const CasePackOptions& options) {
    const auto store = CaseStore::open(options.folder);
    if (!store) return reportError(store.error());
    if (const auto opened = openCase(*store); !opened) return reportError(opened.error());
    auto files = filesOf(*store);
    if (!files) return reportError(files.error());
    std::filesystem::path out = options.out;
    if (out.empty()) {
        std::error_code error;
        const std::filesystem::path folder = std::filesystem::canonical(options.folder, error);
        out = std::filesystem::is_directory(folder, error) ? folder : folder.parent_path();
        out += kCaseEnding;
    }
    if (out.extension() != kCaseEnding) {
        return reportError({msg::kCaseNameEnding, displayName(out), kCaseEnding});
    }
    const std::size_t count = files->size();
    if (const auto written = writeCase(*files, out); !written) return reportError(written.error());
    print("{}: {} files\n", displayName(out), count);
    return kExitOk;
}

}  // namespace tactooth
