// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/session_setup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "bench_scene.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

BeginEvent unusualSetup() {
    BeginEvent event{test::flatBur(0.7), HapticSettings()};
    event.instrument.edge = {8, 40};
    event.settings.mode = ContactMode::Penalty;
    event.settings.freedom = Freedom::TranslationAndRotation;
    event.settings.spindle = spindlePresets().back();
    event.settings.spindle.inertia = 1.0 / 3;
    event.settings.tickBudget = 1234;
    event.settings.force.damping = 0.1 / 7;
    event.settings.materials[test::kEnamel].removal = 1.0 / 77;
    return event;
}

MeshFinder finderOf(const MeshAttachment& bur) {
    return [&bur](const std::string& name) { return name == bur.name ? meshOf(bur.content) : std::nullopt; };
}

TEST(SessionSetup, BringsBackEveryNumberBitForBit) {
    const BeginEvent event = unusualSetup();
    const MeshAttachment bur = attachmentOf(event.instrument.shape->mesh());
    const auto read = parseSetup(setupText(event, bur.name), builtinMaterials(), finderOf(bur), "s.ttsession");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->settings.mode, event.settings.mode);
    EXPECT_EQ(read->settings.freedom, event.settings.freedom);
    EXPECT_EQ(read->settings.tickBudget, event.settings.tickBudget);
    EXPECT_EQ(read->settings.spindle.name, event.settings.spindle.name);
    EXPECT_EQ(read->settings.spindle.inertia, event.settings.spindle.inertia);
    EXPECT_EQ(read->settings.spindle.stallTorque, event.settings.spindle.stallTorque);
    EXPECT_EQ(read->settings.spindle.pedalCurve, event.settings.spindle.pedalCurve);
    EXPECT_EQ(read->settings.force, event.settings.force);
    for (const MaterialId id : builtinMaterials().ids()) {
        EXPECT_EQ(read->settings.materials[id].removal, event.settings.materials[id].removal);
        EXPECT_EQ(read->settings.materials[id].stiffness, event.settings.materials[id].stiffness);
    }
    EXPECT_EQ(read->instrument.edge.flutes, 8);
    EXPECT_EQ(read->instrument.edge.gritMicrometres, 40);
    EXPECT_EQ(read->instrument.cutting.sharpness, 0.7);
    EXPECT_EQ(read->instrument.shape->mesh().vertices, event.instrument.shape->mesh().vertices);
    EXPECT_EQ(read->instrument.shape->mesh().triangles, event.instrument.shape->mesh().triangles);
}

TEST(SessionSetup, KeepsWhichInstrumentTheHandHolds) {
    for (const HandInstrumentSpec& spec : handInstruments()) {
        const BeginEvent event{handTool(spec.kind), HapticSettings()};
        const MeshAttachment shape = attachmentOf(event.instrument.shape->mesh());
        const std::string text = setupText(event, shape.name);
        const auto read = parseSetup(text, builtinMaterials(), finderOf(shape), "s.ttsession");
        ASSERT_TRUE(read) << read.error().message();
        EXPECT_EQ(read->instrument.hand, spec.kind);
        EXPECT_TRUE(read->instrument.carves());
        EXPECT_EQ(read->instrument.cutting.sharpness, event.instrument.cutting.sharpness);
        std::string other = text;
        other.replace(other.find(spec.name), spec.name.size(), "fork");
        const auto refused = parseSetup(other, builtinMaterials(), finderOf(shape), "s.ttsession");
        ASSERT_FALSE(refused);
        EXPECT_THAT(refused.error().message(), HasSubstr("'hand'"));
    }
    const std::string bur = setupText(unusualSetup(), "surface-0");
    EXPECT_EQ(bur.find("hand"), std::string::npos);  // as before there were any
}

TEST(SessionSetup, EqualBursHaveOneName) {
    const TriangleMesh bur = test::flatBurMesh();
    EXPECT_EQ(attachmentOf(bur).name, attachmentOf(test::flatBurMesh()).name);
    TriangleMesh other = bur;
    other.vertices[0].x() += 1e-6F;
    EXPECT_NE(attachmentOf(bur).name, attachmentOf(other).name);
}

TEST(SessionSetup, NamesWhatIsWrong) {
    const BeginEvent event = unusualSetup();
    const MeshAttachment bur = attachmentOf(event.instrument.shape->mesh());
    const std::string good = setupText(event, bur.name);
    const auto refusal = [&](const std::string& text) {
        const auto read = parseSetup(text, builtinMaterials(), finderOf(bur), "s.ttsession");
        return read ? "accepted" : read.error().message();
    };
    const auto changed = [&](const std::string& what, const std::string& by) {
        std::string text = good;
        const auto at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        return text.replace(at, what.size(), by);
    };
    EXPECT_EQ(refusal(good), "accepted");
    EXPECT_THAT(refusal("{"), HasSubstr("not JSON"));
    EXPECT_THAT(refusal("[]"), HasSubstr("'settings'"));
    EXPECT_THAT(refusal(changed("\"penalty\"", "\"guess\"")), HasSubstr("'contact'"));
    EXPECT_THAT(refusal(changed("\"tick_budget\":1234", "\"tick_budget\":-1")), HasSubstr("'tick_budget'"));
    EXPECT_THAT(refusal(changed("\"sharpness\":0.7", "\"sharpness\":\"much\"")), HasSubstr("'sharpness'"));
    EXPECT_THAT(refusal(changed("\"inertia\"", "\"inertness\"")), HasSubstr("'inertia'"));
    EXPECT_THAT(refusal(changed("\"enamel\"", "\"enamal\"")), HasSubstr("'enamel'"));
    EXPECT_THAT(refusal(changed(bur.name, "surface-0")), HasSubstr("surface of the bur (surface-0)"));
}

TEST(SessionSetup, RefusesASurfaceThatIsDamaged) {
    const std::vector<std::byte> good = attachmentOf(test::flatBurMesh()).content;
    ASSERT_TRUE(meshOf(good));
    for (std::size_t length = 0; length < good.size(); ++length) {
        ASSERT_FALSE(meshOf(std::span(good).first(length))) << length;
    }
    std::vector<std::byte> farAway = good;
    farAway.back() = std::byte{0x7F};  // the last corner names a vertex that is not there
    EXPECT_FALSE(meshOf(farAway));
}

TEST(SessionSetup, RefusesASurfaceBeyondTheLimitOfFiles) {
    for (const float place : {1e6F, 1.1e6F, 1e30F, std::numeric_limits<float>::infinity()}) {
        TriangleMesh mesh = test::flatBurMesh();
        mesh.vertices.front().y() = -place;
        EXPECT_EQ(meshOf(attachmentOf(mesh).content).has_value(), place <= 1e6F) << place;
    }
}

}  // namespace
}  // namespace tactooth
