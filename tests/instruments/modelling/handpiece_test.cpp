// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/modelling/handpiece.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

// A head of radius 4 from z = 10 to 20 and a handle of radius 3 around z = 15 up to x = 50.
constexpr Section kHead[] = {circle(10, 4), circle(20, 4)};
constexpr Section kHandle[] = {circle(0, 3, 15), circle(50, 3, 15)};

Handpiece handpiece(double fillet = 2) {
    return Handpiece({.head = kHead,
                      .headBottom = 10,
                      .headTop = 20,
                      .headEdge = 0.5,
                      .handle = kHandle,
                      .handleEnd = 50,
                      .handleEdge = 0.5,
                      .fillet = fillet,
                      .filletFrom = 16,
                      .filletTo = 18});
}

TEST(Handpiece, IsAHeadAndAHandleThatEndWhereTheyAreCutOff) {
    const Handpiece body = handpiece(0);
    EXPECT_LT(body(Vec3(0, 0, 15), 0), 0);
    EXPECT_LT(body(Vec3(30, 0, 15), 0), 0);
    EXPECT_NEAR(body(Vec3(0, 0, 9), 0), 1, 1e-9);
    EXPECT_NEAR(body(Vec3(0, 0, 21), 0), 1, 1e-9);
    EXPECT_NEAR(body(Vec3(51, 0, 15), 0), 1, 1e-9);
    EXPECT_GT(body(Vec3(-6, 0, 15), 0), 1) << "the handle leaves toward +x alone";
}

TEST(Handpiece, WhatIsCarvedIsTakenFromTheHandle) {
    const Handpiece body = handpiece();
    const Vec3 onHandle(30, 3, 15), onHead(-4, 0, 15);
    EXPECT_NEAR(body(onHandle, 0), 0, 1e-9);
    EXPECT_NEAR(body(onHandle, 0.2), 0.2, 1e-9);
    EXPECT_NEAR(body(onHead, 0.2), body(onHead, 0), 1e-9);
}

TEST(Handpiece, TheFilletFillsTheCornerBelowItsEndAlone) {
    const Vec3 below(4.4, 0, 11.7), above(4.4, 0, 18.3);  // outside head and handle, near both
    EXPECT_LT(handpiece(2)(below, 0), handpiece(0.01)(below, 0) - 0.1);
    EXPECT_NEAR(handpiece(2)(above, 0), handpiece(0.01)(above, 0), 1e-9);
}

TEST(Handpiece, ReturnsWhereTheHandleIs) { EXPECT_NEAR(handpiece().handleMiddle(30), 15, 1e-12); }

}  // namespace
}  // namespace tactooth
