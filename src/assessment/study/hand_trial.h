// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "assessment/exercise.h"
#include "assessment/preparation/preparation_metrics.h"
#include "assessment/study/synthetic_hand.h"
#include "session/kernel/stepwise_session.h"

namespace tactooth {

/// An exercise that synthetic hands work at: made once for all of them.
struct StudyScene {
    Preparation preparation;  ///< all but `prepared`
    HandTask task;
    Instrument instrument;
};

/// `preparation`: of the exercise, all but `prepared`; its tooth is that of the exercise. Fails with one sentence,
/// among others if the exercise does not say how the bur moves.
[[nodiscard]] Expected<StudyScene> studyScene(const Exercise& exercise, Preparation preparation);

/// What a hand has done.
struct HandTrial {
    std::vector<MetricResult> metrics;  ///< of measureAll
    bool isFinished = false;            ///< false: the hand was still at work after kLongestTrial
    std::uint64_t toothHash = 0;        ///< CutModel::hash at the end
};
inline constexpr double kLongestTrial = 900;  ///< s

/// A new tooth of the exercise.
[[nodiscard]] std::shared_ptr<CutModel> uncutModel(const StudyScene& scene);

/// Lets a hand work at `model` (uncutModel) in simulated time, with the default drive, and measures what it leaves.
/// Equal calls give equal results. `sink` receives the events of the session; it may be empty.
[[nodiscard]] HandTrial playHand(const StudyScene& scene, const std::shared_ptr<CutModel>& model,
                                 const HandHabits& habits, std::uint64_t seed,
                                 const StepwiseSession::EventSink& sink = {});

}  // namespace tactooth
