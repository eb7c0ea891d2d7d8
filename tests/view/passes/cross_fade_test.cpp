// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/cross_fade.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "view/gl/egl_context.h"
#include "view/gl/render_target.h"

namespace tactooth {
namespace {

constexpr ImageSize kSize{67, 41};
using Bytes = std::vector<std::uint8_t>;

Bytes randomPicture(std::uint32_t seed) {
    std::mt19937 random(seed);
    Bytes picture(std::size_t{4} * kSize.width * kSize.height);
    for (std::uint8_t& byte : picture) byte = static_cast<std::uint8_t>(random() % 256);
    return picture;
}

/// A window's picture, in a context of its own.
class CrossFadeTest : public ::testing::Test {
protected:
    void SetUp() override {
        auto context = EglContext::create();
        ASSERT_TRUE(context) << context.error().message();
        context_ = std::move(*context);
        auto shown = RenderTarget::create(kSize, 0);
        ASSERT_TRUE(shown) << shown.error().message();
        shown_ = std::move(*shown);
        auto fade = CrossFade::create();
        ASSERT_TRUE(fade) << fade.error().message();
        fade_.emplace(std::move(*fade));
    }
    void show(const Bytes& picture) const {
        glBindTexture(GL_TEXTURE_2D, shown_.colourTexture());
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kSize.width, kSize.height, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
        glBindTexture(GL_TEXTURE_2D, 0);
    }
    [[nodiscard]] Bytes seen() const {
        Bytes picture(std::size_t{4} * kSize.width * kSize.height);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, shown_.framebuffer());
        glReadPixels(0, 0, kSize.width, kSize.height, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
        return picture;
    }
    void keepBoth(const Bytes& first, const Bytes& last) {
        show(first);
        ASSERT_TRUE(fade_->keepFirst(shown_.framebuffer(), kSize));
        show(last);
        ASSERT_TRUE(fade_->keepLast(shown_.framebuffer()));
    }

    std::optional<EglContext> context_;  // the others need it until they are destroyed
    RenderTarget shown_;
    std::optional<CrossFade> fade_;
};

TEST_F(CrossFadeTest, BeginsWithTheFirstPictureAndEndsWithTheLastOneBitForBit) {
    const Bytes first = randomPicture(1), last = randomPicture(2);
    keepBoth(first, last);
    fade_->draw(shown_.framebuffer(), 0);
    EXPECT_EQ(seen(), first);
    fade_->draw(shown_.framebuffer(), 1);
    EXPECT_EQ(seen(), last);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(CrossFadeTest, EachStepIsNearerToTheLastPicture) {
    const Bytes first = randomPicture(3), last = randomPicture(4);
    keepBoth(first, last);
    Bytes before = first;
    for (const double share : {0.1, 0.25, 0.3, 0.5, 0.8, 0.95, 1.0}) {
        fade_->draw(shown_.framebuffer(), share);
        const Bytes now = seen();
        for (std::size_t i = 0; i < now.size(); ++i) {
            ASSERT_LE(std::abs(last[i] - now[i]), std::abs(last[i] - before[i]));
            ASSERT_NEAR(now[i], first[i] + share * (last[i] - first[i]), 1);
        }
        before = now;
    }
}

TEST_F(CrossFadeTest, IsUsedAgainForPicturesOfAnotherSize) {
    keepBoth(randomPicture(5), randomPicture(6));
    const ImageSize half{kSize.width / 2, kSize.height / 2};
    show(randomPicture(7));
    ASSERT_TRUE(fade_->keepFirst(shown_.framebuffer(), half));
    ASSERT_TRUE(fade_->keepLast(shown_.framebuffer()));
    const Bytes last = randomPicture(8);
    show(last);
    fade_->draw(shown_.framebuffer(), 1);
    const Bytes picture = seen();
    EXPECT_TRUE(std::equal(picture.end() - 4, picture.end(), last.end() - 4)) << "beyond that size nothing is drawn";
    EXPECT_FALSE(std::equal(picture.begin(), picture.begin() + 4, last.begin()));
}

}  // namespace
}  // namespace tactooth
