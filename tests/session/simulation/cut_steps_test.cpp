// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The steps of a cut model: undo, redo and reset.
#include <gtest/gtest.h>

#include "bench_scene.h"
#include "session/simulation/cut_model.h"

namespace tactooth {
namespace {

using test::at;
using test::blockOnTheBench;

/// All bits of the visible surface.
void expectSameSurface(const Surface& surface, const TaggedMesh& expected) {
    const TaggedMesh mesh = visibleMesh(surface);
    ASSERT_EQ(mesh.mesh.triangles, expected.mesh.triangles);
    ASSERT_EQ(mesh.mesh.vertices, expected.mesh.vertices);
    ASSERT_EQ(mesh.tags, expected.tags);
}

TEST(CutSteps, UndoGoesBackMarkByMarkToTheLastBit) {
    const auto piece = blockOnTheBench();
    const CuttingTool& bur = test::flatBur().cutting;
    struct State {
        std::uint64_t hash;
        MaterialVolumes removed;
        TaggedMesh mesh;
    };
    std::vector<State> states;
    for (int i = 0; i < 4; ++i) {
        states.push_back({piece->hash(), piece->removed(), visibleMesh(*piece->surface())});
        piece->mark(0);
        piece->sweep(bur, at(0.3 * i, 0, 0.2), at(0.3 * i, 0.1, -0.3));
        piece->refreshSurface();
        piece->sweep(bur, at(0.3 * i, 0.1, -0.3), at(0.3 * i, 0.4, -0.4));
        if (i < 3) piece->refreshSurface();  // the last cut was not shown yet
    }
    EXPECT_EQ(piece->history().done.size(), 4U);
    for (auto state = states.rbegin(); state != states.rend(); ++state) {
        ASSERT_TRUE(piece->undo());
        EXPECT_EQ(piece->hash(), state->hash);
        EXPECT_EQ(piece->removed(), state->removed);
        expectSameSurface(*piece->surface(), state->mesh);
    }
    EXPECT_FALSE(piece->undo());
}

TEST(CutSteps, AfterUndoTheSameCutRemovesTheSameAgain) {
    const auto piece = blockOnTheBench();
    const auto cut = [&] { return total(piece->sweep(test::flatBur().cutting, at(0, 0, 0.2), at(0.2, 0, -0.4))); };
    piece->mark(0);
    const double first = cut();
    const std::uint64_t hash = piece->hash();
    EXPECT_EQ(cut(), 0);
    ASSERT_TRUE(piece->undo());
    EXPECT_EQ(cut(), first);
    EXPECT_EQ(piece->hash(), hash);
}

TEST(CutSteps, UndoAndRedoGoBackAndForthAsOftenAsOneLikes) {
    const auto piece = blockOnTheBench();
    struct State {
        std::uint64_t hash;
        MaterialVolumes removed;
        TaggedMesh mesh;
    };
    const auto state = [&] { return State{piece->hash(), piece->removed(), visibleMesh(*piece->surface())}; };
    std::vector<State> states = {state()};
    constexpr int kSteps = 60;
    for (int i = 1; i <= kSteps; ++i) {
        if (i % 20 == 0) {
            ASSERT_TRUE(piece->reset(i));
        } else {
            piece->mark(i);
            piece->sweep(test::flatBur().cutting, at(0, 0, 0.2), at(0.01 * (i % 20), 0, -0.02 * (i % 20)));
            piece->refreshSurface();
        }
        states.push_back(state());
    }
    const auto expectState = [&](std::size_t number) {
        SCOPED_TRACE("step " + std::to_string(number));
        EXPECT_EQ(piece->hash(), states[number].hash);
        EXPECT_EQ(piece->removed(), states[number].removed);
        expectSameSurface(*piece->surface(), states[number].mesh);
        EXPECT_EQ(piece->history().done.size(), number);
        EXPECT_EQ(piece->history().undone.size(), kSteps - number);
    };
    for (std::size_t i = kSteps; i-- > 0;) ASSERT_TRUE(piece->undo()), expectState(i);
    EXPECT_FALSE(piece->undo());
    for (std::size_t i = 1; i <= kSteps; ++i) ASSERT_TRUE(piece->redo()), expectState(i);
    EXPECT_FALSE(piece->redo());
    const CutHistory history = piece->history();
    for (int i = 1; i <= kSteps; ++i) {
        EXPECT_EQ(history.done[i - 1].kind, i % 20 == 0 ? CutStep::Kind::Reset : CutStep::Kind::Stroke);
        EXPECT_EQ(history.done[i - 1].time, i);
    }
    piece->volume().validate();
}

TEST(CutSteps, ACutAfterUndoLeavesNothingToRedo) {
    const auto piece = blockOnTheBench();
    const auto cut = [&](double x) { piece->sweep(test::flatBur().cutting, at(x, 0, 0.2), at(x, 0, -0.3)); };
    piece->mark(1), cut(0);
    const std::uint64_t first = piece->hash();
    piece->mark(2), cut(0.4);
    ASSERT_TRUE(piece->undo());
    EXPECT_EQ(piece->history().undone.size(), 1U);
    piece->mark(3);
    EXPECT_EQ(piece->history().undone.size(), 1U) << "nothing was cut yet";
    cut(-0.4);
    EXPECT_EQ(piece->history().undone.size(), 0U);
    EXPECT_FALSE(piece->redo());
    EXPECT_EQ(piece->history().done.back().time, 3);
    ASSERT_TRUE(piece->undo());
    EXPECT_EQ(piece->hash(), first);
}

/// What changes after an undo without a mark is a step of its own: a piece that falls, for example.
TEST(CutSteps, AChangeAfterUndoIsAStepEvenWithoutAMark) {
    const auto piece = blockOnTheBench();
    piece->mark(1);
    const std::uint64_t whole = piece->hash();
    piece->sweep(test::flatBur().cutting, at(0, 0, 0.2), at(0, 0, -0.3));
    ASSERT_TRUE(piece->undo());
    piece->sweep(test::flatBur().cutting, at(0.4, 0, 0.2), at(0.4, 0, -0.3));
    EXPECT_EQ(piece->history().done.size(), 1U);
    ASSERT_TRUE(piece->undo());
    EXPECT_EQ(piece->hash(), whole);
}

TEST(CutSteps, ResetIsAStepThatCanBeUndone) {
    const auto piece = blockOnTheBench();
    EXPECT_FALSE(piece->reset(0)) << "nothing was cut";
    piece->mark(1);
    piece->sweep(test::flatBur().cutting, at(0, 0, 0.2), at(0, 0, -0.3));
    piece->refreshSurface();
    const std::uint64_t cut = piece->hash();
    const TaggedMesh mesh = visibleMesh(*piece->surface());
    ASSERT_TRUE(piece->reset(2));
    EXPECT_EQ(total(piece->removed()), 0);
    EXPECT_TRUE(piece->surface()->patches.empty());
    ASSERT_TRUE(piece->undo());
    EXPECT_EQ(piece->hash(), cut);
    expectSameSurface(*piece->surface(), mesh);
    ASSERT_TRUE(piece->undo());
    EXPECT_EQ(total(piece->removed()), 0);
}

}  // namespace
}  // namespace tactooth
