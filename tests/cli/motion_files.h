// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <fstream>
#include <sstream>

#include "cli/cli_test.h"
#include "geometry/io/stl_writer.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth::test {

/// A CSV file as text and numbers.
struct CsvContent {
    std::string header;
    std::vector<std::string> names;
    std::vector<std::vector<double>> rows;

    [[nodiscard]] double at(std::size_t row, const std::string& name) const {
        const auto column = std::find(names.begin(), names.end(), name) - names.begin();
        return rows.at(row).at(static_cast<std::size_t>(column));
    }
    [[nodiscard]] Vec3 vectorAt(std::size_t row, const std::array<std::string, 3>& axes) const {
        return {at(row, axes[0]), at(row, axes[1]), at(row, axes[2])};
    }
};

/// A plate below z = 0, a ball of 1 mm on its tip, trajectories, and the expected refusal of bad ones.
class MotionFiles : public ::testing::Test {
protected:
    /// Time, s, and the position of the tip, mm.
    using Row = std::array<double, 4>;

    std::string plate() {
        EXPECT_TRUE(writeStl(box(Vec3(-9, -9, -5), Vec3(9, 9, 0)), folder_ / "plate.stl"));
        return folder_ / "plate.stl";
    }
    std::string ball() {
        EXPECT_TRUE(writeStl(sphere(Vec3(0, 0, 1), 1, 32, 16), folder_ / "ball.stl"));
        return folder_ / "ball.stl";
    }
    std::string missing() { return folder_ / "missing"; }
    std::string out() { return folder_ / "out.csv"; }
    std::string file(const std::string& name) { return folder_ / name; }

    std::string text(const std::string& name, const std::string& content) {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return folder_ / name;
    }
    std::string trajectory(const std::vector<Row>& rows) {
        std::ostringstream content;
        content.precision(17);
        content << "t,x,y,z,qw,qx,qy,qz\n";
        for (const auto& [t, x, y, z] : rows) content << t << ',' << x << ',' << y << ',' << z << ",1,0,0,0\n";
        return text("path.csv", content.str());
    }
    /// A file and a part of the expected sentence.
    std::vector<std::pair<std::string, std::string>> badTrajectories() {
        const std::string head = "t,x,y,z,qw,qx,qy,qz\n";
        const std::string good = "0,0,0,1,1,0,0,0\n";
        return {{text("column.csv", "t,x,y,z,qw,qx,qy\n0,0,0,1,1,0,0\n"), "column.csv, line 1"},
                {text("word.csv", head + good + "0.1,0,zero,1,1,0,0,0\n"), "word.csv, line 3"},
                {text("short.csv", head + "0,0,0,1,1,0,0\n"), "short.csv, line 2"},
                {text("nan.csv", head + good + "0.1,nan,0,1,1,0,0,0\n"), "nan.csv, line 3"},
                {text("inf.csv", head + "0,0,0,inf,1,0,0,0\n"), "inf.csv, line 2"},
                {text("zero.csv", head + good + "0.1,0,0,1,0,0,0,0\n"), "zero.csv, line 3: the quaternion"},
                {text("back.csv", head + "0.2,0,0,1,1,0,0,0\n0.1,0,0,1,1,0,0,0\n"), "back.csv, line 3: time runs"},
                {text("empty.csv", ""), "empty.csv"},
                {text("head.csv", head), "head.csv"}};
    }
    CsvContent table() {
        std::ifstream file(out());
        CsvContent csv;
        std::getline(file, csv.header);
        std::istringstream names(csv.header);
        for (std::string name; std::getline(names, name, ',');) csv.names.push_back(name);
        for (std::string line; std::getline(file, line);) {
            std::istringstream fields(line);
            std::vector<double> row;
            for (std::string field; std::getline(fields, field, ',');) row.push_back(std::stod(field));
            csv.rows.push_back(row);
        }
        return csv;
    }
    /// Expects exit code 2, one sentence, and no output file or remains of one.
    void expectRefused(const ProgramRun& run, const std::string& sentence) {
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_THAT(run.out, ::testing::IsEmpty());
        EXPECT_THAT(run.err, ::testing::HasSubstr(sentence));
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
        for (const auto& file : std::filesystem::directory_iterator(folder_.path())) {
            EXPECT_EQ(file.path().filename().string().find("out.csv"), std::string::npos) << file.path();
        }
    }

private:
    TemporaryFolder folder_;
};

}  // namespace tactooth::test
