// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/cut_journal.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <random>

#include "support/expect_assert.h"

namespace tactooth {
namespace {

constexpr double kSpacing = 0.05;  // mm

bool isIdentical(const CutField& a, const CutField& b) {
    return a.isCut == b.isCut && std::memcmp(a.cut.data(), b.cut.data(), sizeof a.cut) == 0 &&
           a.cutNormal == b.cutNormal && std::memcmp(&a.boundary, &b.boundary, sizeof a.boundary) == 0;
}

/// Lowers some nodes of the field, as a bur does.
void change(CutField& field, std::mt19937& random, int nodes) {
    std::uniform_real_distribution<float> distance(-1, 1), share(0, 1);
    field.isCut = true;
    for (int i = 0; i < nodes; ++i) {
        const int node = static_cast<int>(random() % kBrickNodes);
        field.cut[node] = static_cast<float>(kCutBand * kSpacing) * distance(random);
        field.cutNormal[node] = OctahedralNormal(Vec3(distance(random), distance(random), 2).normalized());
        field.boundary[random() % 3][node] = {share(random), OctahedralNormal(Vec3::UnitX())};
    }
}

TEST(FieldChange, MakesOneFieldOutOfTheOtherBitForBit) {
    std::mt19937 random(1);
    for (int run = 0; run < 100; ++run) {
        CutField from = CutField::untouched(kSpacing);
        if (run % 3 != 0) change(from, random, 200);
        CutField to = run % 5 == 0 ? CutField::untouched(kSpacing) : from;
        if (run % 5 != 0) change(to, random, run % 7 * 60);
        CutField made = from;
        FieldChange::between(from, to, kSpacing).apply(made, kSpacing);
        EXPECT_TRUE(isIdentical(made, to)) << run;
    }
}

TEST(FieldChange, HoldsOnlyWhatDiffers) {
    std::mt19937 random(2);
    const CutField whole = CutField::untouched(kSpacing);
    CutField field = whole;
    change(field, random, 20);
    const std::size_t least = FieldChange::between(whole, whole, kSpacing).bytes();
    EXPECT_LE(FieldChange::between(whole, field, kSpacing).bytes(), least + 20 * 32);
    EXPECT_EQ(FieldChange::between(field, whole, kSpacing).bytes(), least) << "untouched nodes need no values";
    EXPECT_LT(least, 200U);
}

/// A few bricks, and a journal of what happens to them.
class Journal {
public:
    explicit Journal(std::size_t maxBytes = CutJournal::kMaxBytes) : journal_(kSpacing, maxBytes) {
        for (int i = 0; i < 4; ++i) {
            auto brick = std::make_unique<Brick>();
            brick->setField(CutField::untouched(kSpacing));
            brick->tooth.fill(-1);
            bricks_.insert({i, 0, 0}, std::move(brick));
        }
    }
    void step(int nodes = 100) {
        mark();
        cut(nodes);
    }
    void mark() { journal_.mark(bricks_); }
    void cut(int nodes) {
        const BrickKey key{static_cast<int>(random_() % 4), 0, 0};
        CutField field = *bricks_.find(key);
        journal_.keep(key, *bricks_.find(key));
        change(field, random_, nodes);
        bricks_.find(key)->setField(field);
    }
    void undo() { set(journal_.undo(bricks_)); }
    void redo() { set(journal_.redo(bricks_)); }
    [[nodiscard]] std::vector<CutField> fields() const {
        std::vector<CutField> fields;
        for (int i = 0; i < 4; ++i) fields.push_back(*bricks_.find({i, 0, 0}));
        return fields;
    }
    [[nodiscard]] const CutJournal& journal() const { return journal_; }

private:
    void set(const CutJournal::Fields& fields) {
        for (const auto& [key, field] : fields) bricks_.find(key)->setField(field);
    }
    std::mt19937 random_{3};
    BrickMap bricks_;
    CutJournal journal_;
};

void expectFields(const Journal& journal, const std::vector<CutField>& fields) {
    const std::vector<CutField> now = journal.fields();
    for (std::size_t i = 0; i < fields.size(); ++i) EXPECT_TRUE(isIdentical(now[i], fields[i])) << "brick " << i;
}

TEST(CutJournal, GoesBackAndForthThroughAllSteps) {
    Journal bricks;
    std::vector<std::vector<CutField>> states = {bricks.fields()};
    for (int i = 0; i < 50; ++i) {
        bricks.step();
        bricks.cut(10);
        states.push_back(bricks.fields());
    }
    for (int round = 0; round < 2; ++round) {
        for (std::size_t i = 50; i-- > 0;) bricks.undo(), expectFields(bricks, states[i]);
        EXPECT_EQ(bricks.journal().undoable(), 0U);
        EXPECT_EQ(bricks.journal().redoable(), 50U);
        for (std::size_t i = 1; i <= 50; ++i) bricks.redo(), expectFields(bricks, states[i]);
    }
}

TEST(CutJournal, AMarkWithoutAChangeIsNoStep) {
    Journal bricks;
    bricks.step();
    for (int i = 0; i < 5; ++i) bricks.step(0);  // a brick is kept, and stays as it is: a step all the same
    EXPECT_EQ(bricks.journal().undoable(), 6U);
    CutJournal none(kSpacing);
    for (int i = 0; i < 5; ++i) none.mark(BrickMap());
    EXPECT_EQ(none.undoable(), 0U);
}

TEST(CutJournal, ChangesBeforeTheFirstMarkBelongToNoStep) {
    Journal bricks;
    bricks.cut(50);
    EXPECT_EQ(bricks.journal().undoable(), 0U);
    const std::vector<CutField> before = bricks.fields();
    bricks.step();
    bricks.undo();
    expectFields(bricks, before);
}

TEST(CutJournal, BeyondItsMemoryTheOldestStepsAreForgotten) {
    constexpr std::size_t kBytes = 50'000;
    Journal bricks(kBytes);
    std::vector<std::vector<CutField>> states = {bricks.fields()};
    for (int i = 0; i < 100; ++i) bricks.step(), states.push_back(bricks.fields());
    bricks.mark();  // the last step ends
    const std::size_t kept = bricks.journal().undoable();
    EXPECT_GT(kept, 5U);
    EXPECT_LT(kept, 60U);
    EXPECT_LT(bricks.journal().bytes(), kBytes + 2 * sizeof(CutField));
    for (std::size_t i = 0; i < kept; ++i) bricks.undo(), expectFields(bricks, states[99 - i]);
    EXPECT_EQ(bricks.journal().undoable(), 0U);
}

TEST(CutJournalAsserts, WithoutAStepNothingIsUndoneOrRedone) {
    Journal bricks;
    EXPECT_ASSERT(bricks.undo());
    EXPECT_ASSERT(bricks.redo());
}

}  // namespace
}  // namespace tactooth
