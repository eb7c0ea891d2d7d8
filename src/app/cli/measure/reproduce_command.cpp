// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measure/reproduce_command.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "app/cli/measure/reproduce_page.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "app/common/images/drawing_experiment.h"
#include "app/common/images/panel_image.h"
#include "experiments/thread_clock.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/files/folder.h"
#include "geometry/files/staging_folder.h"
#include "geometry/util/messages.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

struct Named {
    const char* name;
    Expected<Experiment> (*measure)(TestTeeth&, const fs::path& folder);
};

constexpr std::array kExperiments = {
    Named{"table2", [](TestTeeth& s, const fs::path& folder) { return measureLoading(s, folder); }},
    Named{"table3", [](TestTeeth& s, const fs::path&) { return measureDrawing(s); }},
    Named{"table4", [](TestTeeth& s, const fs::path&) { return measureMovement(s); }},
    Named{"fig11", [](TestTeeth& s, const fs::path&) { return Expected<Experiment>(measureTenPatches(s)); }},
    Named{"fig13", [](TestTeeth& s, const fs::path&) { return measureSideways(s); }},
    Named{"fig15", [](TestTeeth& s, const fs::path&) { return measureTouch(s, StandardToothKind::Front); }},
    Named{"fig16", [](TestTeeth& s, const fs::path&) { return measureTouch(s, StandardToothKind::Canine); }},
    Named{"fig17", [](TestTeeth& s, const fs::path&) { return measureTouch(s, StandardToothKind::Molar); }}};

bool isWanted(const ReproduceOptions& options, const std::string& name) {
    return std::ranges::any_of(options.what, [&](const std::string& w) { return w == "all" || w == name; });
}

Expected<void> writeDown(const Experiment& experiment, const fs::path& folder) {
    if (auto done = writeExperimentCsv(experiment, folder / (experiment.id + ".csv")); !done) return done;
    return writePanels(experiment, folder / (experiment.id + ".png"));
}

void sayOf(const Experiment& experiment, double seconds) {
    print("{}: {} ({:.1f} s)\n", experiment.id, experiment.title, seconds);
    for (const Comparison& c : experiment.comparisons) {
        print("    {}: published {}, here {}\n", c.what, c.published, c.ours);
    }
    std::fflush(stdout);
}

Expected<void> openFiles(const ReproduceOptions& options, FileTransaction& files) {
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
    FileTransaction files;
    if (const auto opened = openFiles(options, files); !opened) return reportError(opened.error());
    const auto scratch = StagingFolder::make(options.out);
    if (!scratch) return reportError({msg::kOutputNotWritten, displayName(options.out), scratch.error()});
    const auto data = realTeethFolder();
    print("teeth: {}\n", data ? "real ones from " + displayName(*data)
                              : "built-in ones ($TACTOOTH_DATA and ../shared/data hold no real ones)");
    TestTeeth testTeeth;
    std::vector<Experiment> done;
    for (const Named& named : kExperiments) {
        if (!isWanted(options, named.name)) continue;
        print(stderr, "measuring {}\n", named.name);
        const double start = wallMillis();
        auto experiment = named.measure(testTeeth, scratch->path());
        if (!experiment) return reportError(experiment.error());
        if (const auto written = writeDown(*experiment, options.out); !written) return reportError(written.error());
        sayOf(*experiment, 1e-3 * (wallMillis() - start));
        done.push_back(std::move(*experiment));
    }
    if (const auto page = writeReproducePage(done, testTeethText(testTeeth), options.out / "index.html"); !page)
        return reportError(page.error());
    if (const auto named = files.commit(); !named) return reportError(named.error());
    print("open {} for all of it\n", displayName(options.out / "index.html"));
    return kExitOk;
}

}  // namespace tactooth
