// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <random>
#include <thread>

#include "bench_scene.h"
#include "session/recording/session_recorder.h"
#include "track/stepped_session.h"

namespace tactooth::test {

/// A recorded session of two burs on the block: strokes over it and into it, with an undo now and then, and one reset.
struct RecordedStrokes {
    double seconds = 4;
    unsigned seed = 1;
    double undoEach = 0.9;  ///< s
    double resetAt = 3.5;   ///< s, while something is cut; after the end: never
    double voxel = kVoxel;  ///< mm
    double cutShare = 0.8;  ///< of the time, with the pedal down

    /// Returns CutModel::hash at the end.
    std::uint64_t writeTo(const std::filesystem::path& file) const {
        auto tooth = LayeredTooth::make(box(Vec3(-1.5, -1.5, -3), Vec3(1.5, 1.5, 0)), {}, kDentin);
        const auto model = std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*tooth)), voxel);
        auto recorder = SessionRecorder::create(file, *model, "block");
        EXPECT_TRUE(recorder) << recorder.error().message();
        std::mt19937 random(seed);
        double time = 0, undone = 0;
        bool isReset = false;
        for (int bur = 0; bur < 2; ++bur) {
            HapticSettings settings;
            settings.freedom = bur == 0 ? Freedom::Translation : Freedom::TranslationAndRotation;
            const Instrument instrument = flatBur(bur == 0 ? 1 : 0.5);
            const auto lanes = (*recorder)->begin({instrument, settings});
            SteppedSession session(model, instrument, settings, lanes);
            Vec3 from(0, 0, 0.5), to = from;
            constexpr double kStroke = 0.15;  // s
            double began = time;
            bool cuts = true;
            for (; time < seconds * (bur + 1) / 2; time += SteppedSession::kPeriod) {
                if (time >= began + kStroke) {
                    std::uniform_real_distribution<double> across(-1.3, 1.3), down(-0.8, 0.3), part(0, 1);
                    began = time, from = to, to = Vec3(across(random), across(random), down(random));
                    cuts = part(random) < cutShare;
                }
                const double share = std::min(1.0, (time - began) / kStroke);
                session.step({{from + share * (to - from), Quat::Identity()}, cuts ? 1.0 : 0.0, cuts});
                if (time > undone + undoEach) session.edit(Edit::Undo), undone = time;
                if (!isReset && time > resetAt) session.edit(Edit::Reset), isReset = true;
                waitForRecorder(session.ticks());
            }
            (*recorder)->end();
        }
        const auto closed = (*recorder)->close(model->hash());
        EXPECT_TRUE(closed) << closed.error().message();
        return model->hash();
    }

private:
    /// Its queues hold 16,384 events, and it looks 20 times a second: nobody may be faster than that.
    static void waitForRecorder(std::uint64_t ticks) {
        constexpr std::uint64_t kBatch = 2000;
        static thread_local std::chrono::steady_clock::time_point batchBegan;
        if (ticks % kBatch != 0) return;
        const auto next = batchBegan + std::chrono::milliseconds(60);
        std::this_thread::sleep_until(next);
        batchBegan = std::chrono::steady_clock::now();
    }
};

}  // namespace tactooth::test
