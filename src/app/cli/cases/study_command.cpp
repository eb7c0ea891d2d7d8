// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/study_command.h"

#include <mutex>
#include <optional>

#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "app/common/report/make_report.h"
#include "app/common/report/preparation_parts.h"
#include "assessment/exercise_file.h"
#include "assessment/rubric/exercise_rubric.h"
#include "assessment/study/hand_trial.h"
#include "assessment/study/study_page.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/util/parallel_for.h"
#include "session/recording/session_recorder.h"

namespace tactooth {
namespace {

constexpr std::array kFiles = {"study.html", "study.csv", "study.json"};
constexpr const char* kHandsFolder = "hands";

Expected<StudyScene> sceneOf(const Exercise& exercise) {
    auto tooth = exerciseTooth(exercise);
    if (!tooth) return Unexpected{tooth.error()};
    auto ideal = idealShape(exercise, *tooth);
    if (!ideal) return Unexpected{ideal.error()};
    Preparation preparation;
    preparation.original = (*tooth)->ownOuter();
    preparation.ideal = std::make_shared<const SurfacePart>(std::move(*ideal));
    if (const auto* plan = std::get_if<PreparationPlan>(&exercise.ideal)) preparation.axis = plan->outward;
    preparation.forbidden = exercise.forbidden;
    preparation.gums = exerciseGums(exercise);
    preparation.mesialX = (*tooth)->toothContext().mesialX;
    preparation.tooth = std::move(*tooth);
    addPulps(preparation);
    return studyScene(exercise, std::move(preparation));
}

/// Lets one hand work; `recording`: the file of its session, empty for none.
Expected<HandTrial> play(const StudyScene& scene, const StudyHand& hand, const std::filesystem::path& recording) {
    const std::shared_ptr<CutModel> model = uncutModel(scene);
    if (recording.empty()) return playHand(scene, model, hand.habits, hand.seed);
    auto file = createJournalFile(recording, ExistingFile::ReplacedIfOurOwn);
    if (!file) return Unexpected{file.error()};
    auto recorder = SessionRecorder::start(std::move(*file), displayName(recording), *model, hand.name);
    if (!recorder) return Unexpected{recorder.error()};
    HandTrial trial =
        playHand(scene, model, hand.habits, hand.seed, [&](const SessionEvent& event) { (*recorder)->append(event); });
    if (auto closed = (*recorder)->close(trial.toothHash); !closed) return Unexpected{closed.error()};
    return trial;
}

/// All hands, on all processors; one line for each that is done.
Expected<std::vector<StudyTrial>> playAll(const StudyScene& scene, const Rubric& rubric, const StudyOptions& options) {
    const std::vector<StudyHand> hands = studyHands(options.hands, options.seed);
    std::vector<Expected<HandTrial>> played(hands.size(), HandTrial{});
    std::mutex printing;
    std::size_t done = 0;
    parallelFor(hands.size(), [&](std::size_t i) {
        const std::filesystem::path file =
            options.record ? options.out / kHandsFolder / (hands[i].name + std::string(kSessionFileEnding))
                           : std::filesystem::path();
        played[i] = play(scene, hands[i], file);
        const std::scoped_lock lock(printing);
        ++done;
        if (!played[i] || options.json) return;
        const Mark mark = markOf(rubric, played[i]->metrics);
        print("{:>3} of {}  {:<12} mark {:5.1f}  {}\n", done, hands.size(), hands[i].name, mark.value.value_or(0),
              mark.passes ? "passed" : "failed");
    });
    std::vector<StudyTrial> trials;
    for (std::size_t i = 0; i < hands.size(); ++i) {
        if (!played[i]) return Unexpected{played[i].error()};
        Mark mark = markOf(rubric, played[i]->metrics);
        trials.push_back({hands[i], std::move(played[i]->metrics), std::move(mark)});
    }
    return trials;
}

Expected<void> openFiles(const StudyOptions& options, FileTransaction& files) {
    for (const std::string& input : {options.exercise, options.rubric}) {  // or the name of a built-in one
        if (std::filesystem::path(input).has_extension()) files.reads(input);
    }
    if (auto made = files.makeFolder(options.out); !made) return made;
    for (const char* name : kFiles) {
        if (auto opened = files.open(options.out / name); !opened) return opened;
    }
    return options.record ? files.makeFolder(options.out / kHandsFolder) : Expected<void>();
}

Expected<StudyReport> study(const StudyOptions& options, Rubric& rubric) {
    Expected<Exercise> exercise = findExercise(options.exercise);
    if (!exercise) return Unexpected{exercise.error()};
    Expected<Rubric> found = rubricOf(*exercise, options.rubric);
    if (!found) return Unexpected{found.error()};
    rubric = std::move(*found);
    const Expected<StudyScene> scene = sceneOf(*exercise);
    if (!scene) return Unexpected{scene.error()};
    auto trials = playAll(*scene, rubric, options);
    if (!trials) return Unexpected{trials.error()};
    return StudyReport{exercise->name, exercise->japanese.name, &rubric,      options.hands,
                       options.seed,   std::move(*trials),      programText()};
}

Expected<void> write(const StudyOptions& options, const StudyReport& report) {
    if (auto done = writeFile(options.out / kFiles[0], studyHtml(report, options.language)); !done) return done;
    if (auto done = writeFile(options.out / kFiles[1], studyCsv(report)); !done) return done;
    return writeFile(options.out / kFiles[2], studyJson(report));
}

}  // namespace

int runStudy(const StudyOptions& options) {
    FileTransaction files;
    if (const auto opened = openFiles(options, files); !opened) return reportError(opened.error());
    Rubric rubric;
    const Expected<StudyReport> report = study(options, rubric);
    if (!report) return reportError(report.error());
    if (const auto written = write(options, *report); !written) return reportError(written.error());
    if (const auto named = files.commit(); !named) return reportError(named.error());
    if (options.json) {
        writeTo(stdout, studyJson(*report));
    } else {
        print("These hands are synthetic: they test the metrics, and say nothing about people.\n{}\npage: {}\n",
              studyResultText(*report, Language::English), displayName(options.out / kFiles[0]));
    }
    return passesSelfTest(report->trials) ? kExitOk : kExitNegative;
}

}  // namespace tactooth
