// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sessions/session_command.h"

#include <nlohmann/json.hpp>

#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/display_text.h"
#include "journal/file/journal_repair.h"
#include "session/recording/session_parts.h"
#include "session/recording/session_recording.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

/// What a walk over all events counts.
struct EventCounts {
    double seconds = 0;
    std::uint64_t ticks = 0, burs = 0, carves = 0, undos = 0, redos = 0, resets = 0;

    void add(const SessionEvent& event) {
        if (const auto elapsed = secondsOf(event)) ++ticks, seconds += *elapsed;
        burs += std::holds_alternative<BeginEvent>(event) ? 1 : 0;
        const auto* carve = std::get_if<CarveEvent>(&event);
        carves += carve != nullptr && carve->published ? 1 : 0;
        const auto* edit = std::get_if<EditEvent>(&event);
        redos += edit != nullptr && edit->edit == Edit::Redo ? 1 : 0;
        undos += edit != nullptr && edit->edit == Edit::Undo ? 1 : 0;
        resets += edit != nullptr && edit->edit == Edit::Reset ? 1 : 0;
    }
};

Json infoOf(const SessionRecording& recording, const EventCounts& counts, const RecordedEnd& end,
            const NeighbourParts& others) {
    const JournalReader& journal = recording.journal();
    Json json = {{"case", recording.facts().title},
                 {"date", recording.facts().date},
                 {"seconds", counts.seconds},
                 {"ticks", counts.ticks},
                 {"bytes", journal.bytes()},
                 {"complete", journal.isComplete() && !end.hasGap},
                 {"gap", end.hasGap},
                 {"cut_off_at", nullptr},
                 {"part", nullptr},
                 {"part_before", nullptr},
                 {"part_behind", nullptr},
                 {"sealed", recording.facts().isSealed},
                 {"public_key", nullptr},
                 {"build", recording.facts().commit},
                 {"compiler", recording.facts().compiler},
                 {"machine", recording.facts().machine},
                 {"events",
                  {{"burs", counts.burs},
                   {"cuts", counts.carves},
                   {"undos", counts.undos},
                   {"redos", counts.redos},
                   {"resets", counts.resets}}}};
    if (journal.cutOffAt()) json["cut_off_at"] = *journal.cutOffAt();
    if (!recording.facts().part.session.empty()) json["part"] = recording.facts().part.number;
    if (others.before) json["part_before"] = displayName(*others.before);
    if (others.behind) json["part_behind"] = displayName(*others.behind);
    if (recording.facts().sealKey) json["public_key"] = keyText(*recording.facts().sealKey);
    return json;
}

/// Only of a session that is in several files.
void printParts(const Json& json) {
    if (json["part"].is_null()) return;
    const auto part = json["part"].get<unsigned>();
    const auto nameOf = [&](const char* key) {
        return json[key].is_string() ? displayText(json[key].get<std::string>()) : std::string("not in this folder");
    };
    if (part > 1) print("part:      {} of its session; the part before is {}\n", part, nameOf("part_before"));
    if (json["part_behind"].is_string() || json["gap"].get<bool>())
        print("goes on:   the next part is {}\n", nameOf("part_behind"));
}

void printInfo(const Json& json) {
    print("case:      {}\n", displayText(json["case"].get<std::string>()));
    print("date:      {}\n", displayText(json["date"].get<std::string>()));
    print("length:    {:.1f} s, {} ticks\n", json["seconds"].get<double>(), json["ticks"].get<std::uint64_t>());
    print("size:      {} bytes\n", json["bytes"].get<std::uint64_t>());
    print("build:     {}, {}\n", displayText(json["build"].get<std::string>()),
          displayText(json["compiler"].get<std::string>()));
    print("machine:   {}\n", displayText(json["machine"].get<std::string>()));
    const Json& events = json["events"];
    print("events:    {} burs, {} updates of the cut, {} undos, {} redos, {} resets\n",
          events["burs"].get<std::uint64_t>(), events["cuts"].get<std::uint64_t>(),
          events["undos"].get<std::uint64_t>(), events["redos"].get<std::uint64_t>(),
          events["resets"].get<std::uint64_t>());
    if (json["public_key"].is_string()) {
        print("sealed by: {}; 'tactooth session verify' checks it\n", json["public_key"].get<std::string>());
    } else if (json["sealed"].get<bool>()) {
        print("sealed by: no valid key\n");
    }
    if (json["complete"].get<bool>()) {
        print("complete:  yes\n");
    } else if (json["gap"].get<bool>()) {
        print("complete:  no: it ends in mid-session\n");
    } else if (json["cut_off_at"].is_null()) {
        print("complete:  no: it ends after a whole block, without an end mark\n");
    } else {
        print("complete:  no: cut off at byte {}; 'tactooth session repair' keeps what is before\n",
              json["cut_off_at"].get<std::uint64_t>());
    }
    printParts(json);
}

}  // namespace

int runSessionInfo(const SessionInfoOptions& options) {
    const Expected<SessionRecording> recording = SessionRecording::open(options.session);
    if (!recording) return reportError(recording.error());
    EventCounts counts;
    const auto read = recording->forEach([&](const SessionEvent& event) { return counts.add(event), true; });
    if (!read) return reportError(read.error());
    const auto end = recording->end();
    if (!end) return reportError(end.error());
    const Json json = infoOf(*recording, counts, *end, neighbourParts(options.session, recording->facts().part));
    if (options.json) {
        print("{}\n", json.dump(2));
    } else {
        printInfo(json);
    }
    return kExitOk;
}

int runSessionRepair(const SessionRepairOptions& options) {
    const Expected<JournalReader> journal = JournalReader::open(options.session);
    if (!journal) return reportError(journal.error());
    const std::optional<std::string> header = unsealedHeader(journal->headerJson());
    const Expected<JournalRepair> repaired = repairJournal(options.session, options.out, header);
    if (!repaired) return reportError(repaired.error());
    print("{}: {} bytes kept, {} bytes dropped{}\n", displayName(options.out), repaired->keptBytes,
          repaired->droppedBytes, repaired->hadEnd ? "; there was nothing to repair" : "");
    if (header) print("The copy is not sealed: keep the recording, too.\n");
    return kExitOk;
}

}  // namespace tactooth
