// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "instruments/builtin_tooth.h"
#include "support/mesh_checks.h"

namespace tactooth::test {

inline void expectSame(const BuiltinTooth& a, const BuiltinTooth& b) {
    EXPECT_EQ(a.fdi, b.fdi);
    EXPECT_EQ(a.name, b.name);
    EXPECT_TRUE(areBitEqual(a.outer, b.outer));
    EXPECT_TRUE(areBitEqual(a.enamel, b.enamel));
    EXPECT_TRUE(areBitEqual(a.dentin, b.dentin));
    EXPECT_TRUE(areBitEqual(a.pulp, b.pulp));
    EXPECT_EQ(a.caries.empty(), b.caries.empty());
}

}  // namespace tactooth::test
