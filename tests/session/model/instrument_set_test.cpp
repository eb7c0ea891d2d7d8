// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/instrument_set.h"

#include <gtest/gtest.h>

#include "model/model_scene.h"

namespace tactooth {
namespace {

TEST(InstrumentSet, HasNoMeshesUntilTheyAreMadeAndFetched) {
    test::ManualExecutor later;
    InstrumentSet instruments(later.executor());
    instruments.poll();
    EXPECT_TRUE(instruments.isBusy());
    EXPECT_FALSE(instruments.meshes());
    later.runNext();
    EXPECT_FALSE(instruments.meshes());
    instruments.poll();
    EXPECT_FALSE(instruments.isBusy());
    ASSERT_TRUE(instruments.meshes());
    EXPECT_FALSE(instruments.meshes()->handpieces.turbine->triangles.empty());
    EXPECT_FALSE(instruments.meshes()->suction->triangles.empty());
    EXPECT_FALSE(instruments.meshes()->mirror->triangles.empty());
}

TEST(InstrumentSet, EachDriveHasTheHandpieceThatItNeeds) {
    InstrumentSet instruments(test::runInline);
    instruments.poll();
    const HandpieceMeshes& handpieces = instruments.meshes()->handpieces;
    const std::vector<SpindlePreset>& drives = spindlePresets();
    EXPECT_EQ(handpieces.of(drives[0]), handpieces.turbine);
    EXPECT_EQ(handpieces.of(drives[1]), handpieces.contraAngle) << "an electric motor needs a gear";
    EXPECT_EQ(handpieces.of(drives[2]), handpieces.lowSpeed);
    // The coupling of a motor is wider than a turbine's.
    EXPECT_GT(boundingBox(*handpieces.contraAngle).sizes().y(), boundingBox(*handpieces.turbine).sizes().y() + 5);
}

TEST(InstrumentSet, TheMirrorHasTheSizeThatWasChosenBeforeItWasMade) {
    test::ManualExecutor later;
    InstrumentSet instruments(later.executor());
    instruments.setMirror({.diameter = 18});
    later.runNext();
    instruments.poll();
    EXPECT_EQ(instruments.meshes()->disc.radius, makeMirror(18).disc.radius);
}

TEST(InstrumentSet, AnotherSizeReplacesTheMirrorAlone) {
    InstrumentSet instruments(test::runInline);
    instruments.poll();
    const InstrumentMeshes before = *instruments.meshes();
    instruments.setMirror({.diameter = 24});
    EXPECT_NE(instruments.meshes()->mirror, before.mirror);
    EXPECT_EQ(instruments.meshes()->handpieces.turbine, before.handpieces.turbine);
    EXPECT_EQ(instruments.meshes()->disc.radius, makeMirror(24).disc.radius);
    EXPECT_EQ(instruments.mirror().diameter, 24);
}

TEST(InstrumentSet, FogAndDropsKeepTheMesh) {
    InstrumentSet instruments(test::runInline);
    instruments.poll();
    const auto mesh = instruments.meshes()->mirror;
    instruments.setMirror({.fogged = true, .wet = true});
    EXPECT_EQ(instruments.meshes()->mirror, mesh);
    EXPECT_TRUE(instruments.mirror().fogged && instruments.mirror().wet);
}

TEST(InstrumentSet, TheGlassDimsOnlyIfItIsToAndFogSwitchedOffWipesIt) {
    InstrumentSet instruments(test::runInline);
    const MirrorGlass::Input inMouth{.isInMouth = true};
    instruments.advanceGlass(inMouth, 100);
    EXPECT_EQ(instruments.glass().fog(), 0);
    instruments.setMirror({.dims = true});
    instruments.advanceGlass(inMouth, 100);
    EXPECT_EQ(instruments.glass().fog(), 1);
    instruments.setMirror({.diameter = 24, .dims = true});
    EXPECT_EQ(instruments.glass().fog(), 1) << "another size";
    instruments.setMirror({.fogged = true, .dims = true});
    EXPECT_EQ(instruments.glass().fog(), 0);
}

TEST(InstrumentSet, WaterIsOnAndSuctionOffAtFirst) {
    const InstrumentSet instruments(test::runInline);
    EXPECT_TRUE(instruments.water());
    EXPECT_FALSE(instruments.suction());
}

TEST(InstrumentSet, OnlyWhatIsOnIsHeard) {
    InstrumentSet instruments(test::runInline);
    for (const bool water : {false, true}) {
        for (const bool suction : {false, true}) {
            instruments.setWater(water);
            instruments.setSuction(suction);
            DrillSoundState heard;
            heard.water = 0.7;
            heard.suction = 0.4;
            heard.speedRpm = 1000;
            instruments.muteIdle(heard);
            EXPECT_EQ(heard.water, water ? 0.7 : 0);
            EXPECT_EQ(heard.suction, suction ? 0.4 : 0);
            EXPECT_EQ(heard.speedRpm, 1000);
        }
    }
}

}  // namespace
}  // namespace tactooth
