// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measure/reproduce_command.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "app/common/exit_code.h"
#include "app/cli/terminal/output.h"
#include "app/cli/measure/reproduce_page.h"
#include "app/common/drawing_experiment.h"
#include "app/common/panel_image.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_set.h"
#include "geometry/files/folder.h"
#include "geometry/files/unfinished_folder.h"
#include "experiments/thread_clock.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

struct Named {
    const char* name;
    Expected<Experiment> (*measure)(Subjects&, const fs::path& folder);
};

constexpr std::array kExperiments = {
    Named{"table2", [](Subjects& s, const fs::path& folder) { return measureLoading(s, folder); }},
    Named{"table3", [](Subjects& s, const fs::path&) { return measureDrawing(s); }},
    Named{"table4", [](Subjects& s, const fs::path&) { return measureMovement(s); }},
    Named{"fig11", [](Subjects& s, const fs::path&) { return Expected<Experiment>(measureTenPatches(s)); }},
    Named{"fig13", [](Subjects& s, const fs::path&) { return measureSideways(s); }},
    Named{"fig15", [](Subjects& s, const fs::path&) { return measureTouch(s, StandardToothKind::Front); }},
    Named{"fig16", [](Subjects& s, const fs::path&) { return measureTouch(s, StandardToothKind::Dog); }},
    Named{"fig17", [](Subjects& s, const fs::path&) { return measureTouch(s, StandardToothKind::Molar); }}};

bool isWanted(const ReproduceOptions& options, const std::string& name) {
    return std::ranges::any_of(options.what, [&](const std::string& w) { return w == "all" || w == name; });
}

Expected<void> writeDown(const Experiment& experiment, const fs::path& folder) {
    if (auto done = writeExperimentCsv(experiment, folder / (experiment.id + ".csv")); !done) return done;
    return writePanels(experiment, folder / (experiment.id + ".png"));
}

void sayOf(const Experiment& experiment, double seconds) {
    say("{}: {} ({:.1f} s)\n", experiment.id, experiment.title, seconds);
    for (const Comparison& c : experiment.comparisons) {
        say("    {}: published {}, here {}\n", c.what, c.published, c.ours);
    }
    std::fflush(stdout);
}

Expected<void> openFiles(const ReproduceOptions& options, FileSet& files) {
    if (auto made = files.makeFolder(options.out); !made) return made;
    for (const Named& named : kExperiments) {
        if (!isWanted(options, named.name)) continue;
        for (const char* const ending : {".csv", ".png"}) {
            if (auto opened = files.open(options.out / (std::string(named.name) + ending)); !opened) return opened;
        }
    }
    return files.open(options.out / "index.html");
}

}  // namespace

std::vector<std::string> experimentNames() {
    std::vector<std::string> names;
    for (const Named& experiment : kExperiments) names.emplace_back(experiment.name);
    return names;
}

int runReproduce(const ReproduceOptions& options) {
    FileSet files;
    if (const auto opened = openFiles(options, files); !opened) return refuse(opened.error());
    const auto scratch = UnfinishedFolder::make(options.out);
    if (!scratch) return refuse({shownName(options.out) + ": cannot be written: " + scratch.error().message + "."});
    const auto data = realTeethFolder();
    say("teeth: {}\n", data ? "real ones from " + shownName(*data)
                            : "built-in ones ($TACTOOTH_DATA and ../shared/data hold no real ones)");
    Subjects subjects;
    std::vector<Experiment> done;
    for (const Named& named : kExperiments) {
        if (!isWanted(options, named.name)) continue;
        say(stderr, "measuring {}\n", named.name);
        const double start = wallMillis();
        auto experiment = named.measure(subjects, scratch->path());
        if (!experiment) return refuse(experiment.error());
        if (const auto written = writeDown(*experiment, options.out); !written) return refuse(written.error());
        sayOf(*experiment, 1e-3 * (wallMillis() - start));
        done.push_back(std::move(*experiment));
    }
    if (const auto page = writeReproducePage(done, subjectsText(subjects), options.out / "index.html"); !page)
        return refuse(page.error());
    if (const auto named = files.commit(); !named) return refuse(named.error());
    say("open {} for all of it\n", shownName(options.out / "index.html"));
    return kExitOk;
}

}  // namespace tactooth
