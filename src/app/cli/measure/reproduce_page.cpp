// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measure/reproduce_page.h"

#include <fmt/core.h>

#include "geometry/files/atomic_file.h"
#include "session/io/run_metadata.h"

namespace tactooth {
namespace {

constexpr std::string_view kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Tactooth: published measurements, repeated</title>
<meta name="viewport" content="width=device-width, initial-scale=1">
<style>
body { font: 16px/1.5 system-ui, sans-serif; color: #222; max-width: 72rem; margin: 2rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.7rem; margin-bottom: .3rem; } h2 { font-size: 1.25rem; margin-top: 3rem; }
table { border-collapse: collapse; margin: 1rem 0; } td, th { padding: .35rem .9rem; border-bottom: 1px solid #ddd;
text-align: left; vertical-align: top; } th { color: #555; font-weight: 600; } td:last-child { font-weight: 600; }
img { width: 100%; border: 1px solid #e3e3e3; } .facts { color: #555; font-size: .9rem; } code { font-size: .85rem; }
nav a { margin-right: 1rem; }
</style></head><body>
)";

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '&':
                safe += "&amp;";
                break;
            default:
                safe += c;
        }
    }
    return safe;
}

std::string factsText(const std::string& testTeeth) {
    const RunMetadata facts = currentRunMetadata();
    return fmt::format("<p class=\"facts\">{}<br>{}; {}; commit {}; {}<br><code>{}</code></p>\n", escaped(testTeeth),
                       escaped(facts.machine), escaped(facts.compiler), escaped(facts.commit), escaped(facts.date),
                       escaped(facts.command));
}

std::string section(const Experiment& experiment) {
    std::string html = fmt::format("<h2 id=\"{0}\">{1} <small>({0})</small></h2>\n<p>{2}</p>\n", experiment.id,
                                   escaped(experiment.title), escaped(experiment.method));
    html += "<table><tr><th></th><th>published</th><th>here</th></tr>\n";
    for (const Comparison& c : experiment.comparisons) {
        html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", escaped(c.what), escaped(c.published),
                            escaped(c.ours));
    }
    html += fmt::format(
        "</table>\n<a href=\"{0}.png\"><img src=\"{0}.png\" alt=\"{1}\"></a>\n"
        "<p><a href=\"{0}.csv\">{0}.csv</a> ({2} rows)</p>\n",
        experiment.id, escaped(experiment.title), experiment.rows.size());
    return html;
}

}  // namespace

std::string testTeethText(const TestTeeth& testTeeth) {
    std::string text =
        "Measured with a round bur of " + std::to_string(testTeeth.bur()->mesh().triangles.size()) + " triangles";
    for (const StandardTooth* tooth : testTeeth.used()) {
        text += fmt::format("; {} ({}, {} triangles)", tooth->name, tooth->source, tooth->mesh.triangles.size());
    }
    return text + ".";
}

Expected<void> writeReproducePage(std::span<const Experiment> experiments, const std::string& testTeeth,
                                  const std::filesystem::path& path) {
    std::string html(kHead);
    html +=
        "<h1>Published measurements, repeated</h1>\n<p>The measurements of a published dental simulator of the same "
        "kind (surface meshes of real teeth, AABB trees, GJK), made again with Tactooth on this machine. Everything "
        "in the last column was measured in this run; of the published tables only the numbers shown are known to "
        "us, and they were taken on another machine with other teeth.</p>\n";
    html += factsText(testTeeth);
    html += "<nav>";
    for (const Experiment& experiment : experiments) {
        html += fmt::format("<a href=\"#{0}\">{0}</a>", experiment.id);
    }
    html += "</nav>\n";
    for (const Experiment& experiment : experiments) html += section(experiment);
    html += "</body></html>\n";
    return writeFile(path, html);
}

}  // namespace tactooth
