// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/constraint_set.h"

#include <gtest/gtest.h>

#include <random>

#include "support/expect_assert.h"

namespace tactooth {
namespace {

template <class Set>
class ConstraintSetTest : public ::testing::Test {
protected:
    using Vector = typename Set::Vector;
    using Space = typename Set::Space;
    static constexpr int kSize = Vector::RowsAtCompileTime;

    static WatchedPair pairNumber(std::uint32_t number) {
        WatchedPair watched{{0, number, 0}, {}};
        watched.plane.normal = Vec3::UnitZ();
        watched.plane.offset = number;
        return watched;
    }
    static Vector unit(int axis) {
        Vector v = Vector::Zero();
        v[axis] = 1;
        return v;
    }
    Vector randomUnit() {
        std::normal_distribution<double> normal;
        Vector v;
        for (int i = 0; i < kSize; ++i) v[i] = normal(random_);
        return v.normalized();
    }

    std::mt19937 random_{17};
    Set set_;
};

using Sets = ::testing::Types<ConstraintSet<3>, ConstraintSet<6>>;
TYPED_TEST_SUITE(ConstraintSetTest, Sets);

}  // namespace

TYPED_TEST(ConstraintSetTest, WithoutConstraintsTheTargetIsNearest) {
    const typename TestFixture::Vector target = 3 * this->randomUnit();
    const auto answer = this->set_.nearest(target, 1e-9);
    ASSERT_TRUE(answer.feasible);
    EXPECT_EQ(answer.point, target);
    EXPECT_EQ(answer.activeCount, 0);
}

TYPED_TEST(ConstraintSetTest, OneConstraintGivesTheProjection) {
    for (int i = 0; i < 100; ++i) {
        this->set_.clear();
        const auto normal = this->randomUnit();
        const typename TestFixture::Vector target = 2 * this->randomUnit();
        const double offset = normal.dot(target) + 0.5;
        this->set_.add(this->pairNumber(7), {normal, offset});
        const auto answer = this->set_.nearest(target, 1e-12);
        ASSERT_TRUE(answer.feasible);
        EXPECT_LT((answer.point - (target + 0.5 * normal)).norm(), 1e-12);
        this->set_.setActive(answer);
        ASSERT_EQ(this->set_.activeCount(), 1);
        EXPECT_NEAR(this->set_.multiplier(0), 0.5, 1e-12);
        EXPECT_EQ(this->set_.watched(this->set_.active()[0]).pair.tooth, 7U);
    }
}

TYPED_TEST(ConstraintSetTest, RandomAnswersMeetTheConditionsOfKarushKuhnAndTucker) {
    std::uniform_real_distribution<double> offset(-1, 0);  // the origin meets all of them
    for (int i = 0; i < 500; ++i) {
        this->set_.clear();
        for (std::uint32_t k = 0; k < 10; ++k)
            this->set_.add(this->pairNumber(k), {this->randomUnit(), offset(this->random_)});
        const typename TestFixture::Vector target = 2 * this->randomUnit();
        const auto answer = this->set_.nearest(target, 1e-12);
        ASSERT_TRUE(answer.feasible);
        this->set_.setActive(answer);
        auto push = (answer.point - target).eval();
        for (int k = 0; k < this->set_.activeCount(); ++k) {
            EXPECT_GE(this->set_.multiplier(k), 0);
            push -= this->set_.multiplier(k) * this->set_.spaces()[this->set_.active()[k]].normal;
        }
        EXPECT_LT(push.norm(), 1e-7);
        for (const auto& space : this->set_.spaces()) EXPECT_GT(space.normal.dot(answer.point), space.offset - 1e-9);
    }
}

TYPED_TEST(ConstraintSetTest, KnowsThatOpposedConstraintsHaveNoCommonPoint) {
    this->set_.add(this->pairNumber(0), {this->unit(0), 1});
    this->set_.add(this->pairNumber(1), {-this->unit(0), 0});
    EXPECT_FALSE(this->set_.nearest(TestFixture::Vector::Zero(), 1e-12).feasible);
}

TYPED_TEST(ConstraintSetTest, NumbersItsConstraintsAndReplacesThem) {
    EXPECT_EQ(this->set_.add(this->pairNumber(4), {this->unit(0), 1}), 0);
    EXPECT_EQ(this->set_.add(this->pairNumber(5), {this->unit(1), 1}), 1);
    this->set_.set(0, this->pairNumber(6), {this->unit(2), 3});
    EXPECT_EQ(this->set_.count(), 2);
    EXPECT_EQ(this->set_.watched(0).pair.tooth, 6U);
    EXPECT_EQ(this->set_.spaces()[0].offset, 3);
    this->set_.set(2, this->pairNumber(8), {this->unit(2), 3});
    EXPECT_EQ(this->set_.count(), 3);
}

TYPED_TEST(ConstraintSetTest, KeepsTheActiveSetUntilTheNextAnswer) {
    this->set_.add(this->pairNumber(0), {this->unit(0), -1});
    this->set_.add(this->pairNumber(1), {this->unit(1), 1});
    this->set_.setActive(this->set_.nearest(TestFixture::Vector::Zero(), 1e-12));
    EXPECT_FALSE(this->set_.isActive(0));
    EXPECT_TRUE(this->set_.isActive(1));
    this->set_.clear();
    EXPECT_EQ(this->set_.count(), 0);
    EXPECT_EQ(this->set_.activeCount(), 1);
    EXPECT_EQ(this->set_.activeNormal(0), Vec3::UnitZ());
}

TYPED_TEST(ConstraintSetTest, AssertsItsCapacityAndItsNumbers) {
    EXPECT_ASSERT(this->set_.set(1, this->pairNumber(0), {this->unit(0), 0}));
    for (std::uint32_t i = 0; i < TypeParam::kCapacity; ++i) this->set_.add(this->pairNumber(i), {this->unit(0), 0});
    EXPECT_TRUE(this->set_.isFull());
    EXPECT_ASSERT(this->set_.add(this->pairNumber(0), {this->unit(0), 0}));
    EXPECT_ASSERT((void)this->set_.multiplier(0));
    EXPECT_ASSERT((void)this->set_.watched(-1));
    EXPECT_ASSERT(this->set_.setActive(typename TypeParam::Answer{}));
}

}  // namespace tactooth
