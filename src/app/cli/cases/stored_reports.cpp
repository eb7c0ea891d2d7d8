// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/stored_reports.h"

#include <algorithm>
#include <system_error>

#include "app/cli/terminal/output.h"
#include "app/common/report/make_report.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/messages.h"
#include "geometry/util/system_reason.h"

namespace tactooth {
namespace {

constexpr std::size_t kMostBytes = 4'000'000;  // of a report.json, which has some 20 kB

}  // namespace

Expected<std::vector<std::filesystem::path>> reportFilesIn(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code fault;
    using Walk = std::filesystem::recursive_directory_iterator;
    for (Walk each(folder, fault), end; !fault && each != end; each.increment(fault)) {
        if (each->path().filename() == "report.json") files.push_back(each->path());
    }
    if (fault) return unexpected(msg::kFolderNotRead, displayName(folder), systemReason(fault));
    std::ranges::sort(files);
    return files;
}

Expected<std::vector<StoredReport>> storedReportsIn(const std::filesystem::path& folder,
                                                    const std::filesystem::path& except) {
    const auto files = reportFilesIn(folder);
    if (!files) return Unexpected{files.error()};
    std::vector<StoredReport> reports;
    for (const std::filesystem::path& file : *files) {
        std::error_code fault;
        if (std::filesystem::equivalent(file, except, fault)) continue;
        const Expected<FileBytes> bytes = readFile(file, kMostBytes);
        if (!bytes) return Unexpected{bytes.error()};
        Expected<StoredReport> report = readStoredReport(bytes->text(), displayName(file));
        if (!report) return Unexpected{report.error()};
        reports.push_back(std::move(*report));
    }
    std::ranges::stable_sort(reports, isEarlier);
    return reports;
}

std::vector<StoredReport> earlierTrials(std::vector<StoredReport> reports, const StoredReport& present) {
    std::erase_if(reports, [&](const StoredReport& each) {
        const bool isLater = !present.date.empty() && each.date > present.date;
        if (isLater || each.isSameWork(present)) return true;
        const std::optional<Message> why = whyNotComparable(each, present);
        if (why) print(stderr, "{}\n", why->in(Language::English));
        return why.has_value();
    });
    return reports;
}

}  // namespace tactooth
