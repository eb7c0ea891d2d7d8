// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/tick_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

TEST(TickCsv, WritesOneRowATickUnderTheDocumentedNames) {
    const test::TemporaryFolder folder;
    auto file = TickCsv::create(folder / "ticks.csv");
    ASSERT_TRUE(file) << file.error().message();
    Tick tick;
    tick.input.device.position = Vec3(1, 2, 3);
    tick.contact.depth = 0.25;
    tick.contact.normal = Vec3(0, 0, 1);
    tick.input.speed = 4;
    tick.force.wrench = {Vec3(5, 6, 7), Vec3(8, 9, 10)};
    tick.contact.triangles = 3;
    tick.diagnostics.micros = 11;
    tick.contact.proxy = {Vec3(12, 13, 14), Quat(0.5, -0.5, 0.5, -0.5)};
    file->write(0.125, tick);
    ASSERT_TRUE(file->commit());
    EXPECT_EQ(test::readText(folder / "ticks.csv"),
              "t,x,y,z,depth,nx,ny,nz,speed,fx,fy,fz,tx,ty,tz,contacts,micros,proxy_x,proxy_y,proxy_z,proxy_qw,"
              "proxy_qx,proxy_qy,proxy_qz\n"
              "0.125,1,2,3,0.25,0,0,1,4,5,6,7,8,9,10,3,11,12,13,14,0.5,-0.5,0.5,-0.5\n");
}

TEST(TickCsv, WithoutCommitNoFileIsLeft) {
    const test::TemporaryFolder folder;
    {
        auto file = TickCsv::create(folder / "ticks.csv");
        ASSERT_TRUE(file);
        file->write(0, Tick());
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(TickCsv, SaysWhereItCannotWrite) {
    const test::TemporaryFolder folder;
    const auto file = TickCsv::create(folder / "none" / "ticks.csv");
    ASSERT_FALSE(file);
    EXPECT_THAT(file.error().message(), ::testing::HasSubstr("ticks.csv"));
}

}  // namespace
}  // namespace tactooth
