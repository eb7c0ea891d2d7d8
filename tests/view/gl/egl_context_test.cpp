// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/gl/egl_context.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstdlib>

namespace tactooth {
namespace {

TEST(EglContext, DistinguishesSoftwareFromGraphicsCards) {
    for (const char* const software : {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Software Rasterizer"}) {
        EXPECT_TRUE(isSoftwareRenderer(software)) << software;
    }
    for (const char* const card : {"NVIDIA GeForce RTX 3060/PCIe/SSE2", "Mesa Intel(R) UHD Graphics 620 (KBL GT2)",
                                   "AMD Radeon RX 580 Series"}) {
        EXPECT_FALSE(isSoftwareRenderer(card)) << card;
    }
}

TEST(EglContext, DrawsBySoftwareWhereThatIsAskedFor) {
    const char* const before = std::getenv("LIBGL_ALWAYS_SOFTWARE");
    const std::string kept = before == nullptr ? "0" : before;
    ASSERT_EQ(setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1), 0);
    const auto context = EglContext::create();
    ASSERT_EQ(setenv("LIBGL_ALWAYS_SOFTWARE", kept.c_str(), 1), 0);
    ASSERT_TRUE(context) << context.error().message();
    EXPECT_TRUE(isSoftwareRenderer(rendererName())) << rendererName();
}

TEST(EglContext, AContextIsCurrentWhileItLives) {
    const auto context = EglContext::create();
    ASSERT_TRUE(context) << context.error().message();
    EXPECT_FALSE(rendererName().empty());
}

}  // namespace
}  // namespace tactooth
