// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/motion_files.h"
#include "geometry/mesh/subdivide.h"
#include "geometry/util/pose.h"
#include "session/block_with_cavity.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;
using Json = nlohmann::json;

/// Blocks of 10 mm; the expert's cavity is 4 x 3 mm and 2 mm deep.
class AssessCommand : public test::MotionFiles {
protected:
    std::string surface(const std::string& name, const TriangleMesh& mesh) {
        EXPECT_TRUE(writeStl(mesh, file(name)));
        return file(name);
    }
    std::string block() { return surface("block.stl", box(Vec3(-5, -5, -5), Vec3(5, 5, 5))); }
    std::string expert() { return cavity("expert.stl", 0); }
    /// As the expert's one, but `deeper` mm too deep.
    std::string cavity(const std::string& name, double deeper) {
        return surface(name, blockWithCavity(Vec3(-2, -1.5, 3 - deeper), Vec3(2, 1.5, 5)));
    }
    ProgramRun assess(const std::string& student, const std::vector<std::string>& more = {}) {
        std::vector<std::string> all = {"assess",     student, "--expert", expert(),
                                        "--original", block(), "--out",    file("out")};
        all.insert(all.end(), more.begin(), more.end());
        return runTactooth(all);
    }
    Json report() { return Json::parse(readText(file("out") + "/report.json")); }
    static Json metric(const Json& report, const std::string& id) {
        for (const Json& each : report["metrics"]) {
            if (each["id"] == id) return each;
        }
        ADD_FAILURE() << "no metric " << id;
        return {};
    }
};

std::size_t pagesIn(const std::string& pdf) {
    std::size_t pages = 0;
    for (std::size_t at = 0; (at = pdf.find("/Type /Page\n", at)) != std::string::npos; ++at) ++pages;
    return pages;
}

TEST_F(AssessCommand, PassesGoodWorkAndFailsBadWork) {
    const ProgramRun good = assess(cavity("good.stl", 0.05));
    EXPECT_EQ(good.exitCode, 0) << good.err;
    EXPECT_GE(report()["mark"], 90);
    EXPECT_EQ(report()["pass"], true);
    const ProgramRun bad = assess(cavity("bad.stl", 1.5));
    EXPECT_EQ(bad.exitCode, 1) << bad.err;
    EXPECT_LT(report()["mark"], 65);
    EXPECT_EQ(report()["pass"], false);
}

TEST_F(AssessCommand, LeavesAReportInFourForms) {
    const ProgramRun run = assess(cavity("deep.stl", 0.3));
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, AllOf(HasSubstr("of 100, passed"), HasSubstr("Deepest over-preparation")));
    const Json json = report();
    EXPECT_NEAR(metric(json, "over_max")["value"], 0.3, 0.02);
    EXPECT_EQ(metric(json, "over_max")["unit"], "mm");
    EXPECT_NEAR(metric(json, "over_max")["place"]["z"], 2.7, 0.02);
    EXPECT_TRUE(metric(json, "over_max")["moment"].is_null());
    EXPECT_NEAR(metric(json, "over_volume")["value"], 3.6, 0.05);
    EXPECT_NEAR(metric(json, "floor_depth_median")["value"], 2.3, 0.02);
    EXPECT_TRUE(metric(json, "pulp_open")["value"].is_null());
    EXPECT_EQ(metric(json, "pulp_open")["reason"], "the files have no pulp");
    EXPECT_FALSE(json["criteria"].empty());
    EXPECT_THAT(readText(file("out") + "/report.csv"), HasSubstr("metric,over_max,0.2999"));
    const std::string html = readText(file("out") + "/report.html");
    EXPECT_THAT(html, StartsWith("<!DOCTYPE html>"));
    EXPECT_THAT(html, HasSubstr("Not measurable, because the files have no pulp"));
    EXPECT_THAT(html, Not(HasSubstr("http")));
    EXPECT_THAT(html, HasSubstr("Section from distal to mesial"));
    EXPECT_THAT(html, Not(HasSubstr("Force and depth")));  // there is no session
    EXPECT_LT(html.size(), 2'000'000U);
    const std::string pdf = readText(file("out") + "/report.pdf");
    EXPECT_THAT(pdf, StartsWith("%PDF-"));
    EXPECT_LT(pdf.size(), 2'000'000U);
    EXPECT_EQ(pagesIn(pdf), 2U);
}

TEST_F(AssessCommand, SaysWhoseWorkItIsAndWhatToDoNext) {
    const ProgramRun run =
        assess(cavity("deep.stl", 0.4), {"--name", "Ann <Lee>", "--comment", "Well done.\nMind the depth & stop."});
    EXPECT_NE(run.exitCode, 2) << run.err;
    const Json json = report();
    EXPECT_EQ(json["name"], "Ann <Lee>");
    EXPECT_EQ(json["comment"], "Well done.\nMind the depth & stop.");
    ASSERT_EQ(json["next"].size(), 2U);
    EXPECT_THAT(json["next"][0].get<std::string>(), AnyOf(HasSubstr("0.40 mm"), HasSubstr("%")));
    const std::string html = readText(file("out") + "/report.html");
    EXPECT_THAT(html, HasSubstr("Student: Ann &lt;Lee&gt;"));
    EXPECT_THAT(html, HasSubstr("Well done.\nMind the depth &amp; stop."));
    EXPECT_THAT(html, HasSubstr(json["next"][0].get<std::string>()));
}

/// A page without its style and its tags.
std::string textOf(const std::string& html) {
    std::string text;
    for (std::size_t at = html.find("</style>"); at < html.size();) {
        const std::size_t tag = std::min(html.find('<', at), html.size());
        text += html.substr(at, tag - at) + ' ';
        at = std::min(html.find('>', tag), html.size() - 1) + 1;
    }
    return text;
}

/// The words in Latin letters that are no unit and no name.
std::vector<std::string> latinWords(const std::string& text) {
    static const std::set<std::string> known = {"mm",  "RMS", "Dice", "SPARC",  "LDLJ",           "Hz", "SD", "UTC",
                                                "TOC", "stl", "ann",  "expert", "Balasubramanian"};
    std::vector<std::string> words;
    std::string word;
    for (const char c : text + ' ') {
        if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
            word += c;
        } else {
            if (word.size() > 1 && !known.contains(word)) words.push_back(word);
            word.clear();
        }
    }
    return words;
}

TEST_F(AssessCommand, WritesThePagesInJapanese) {
    std::filesystem::create_directory(file("class"));
    (void)cavity("class/ann.stl", 0.4);
    (void)text("class/ben.stl", "junk\n");
    ASSERT_EQ(assess(file("class"), {"--language", "ja"}).exitCode, 2);
    const std::string table = readText(file("out") + "/class.html");
    EXPECT_THAT(table, AllOf(HasSubstr("<html lang=\"ja\">"), HasSubstr("クラスの評価"), HasSubstr("1 件中 1 件合格")));
    EXPECT_THAT(readText(file("out") + "/class.csv"), HasSubstr("ben.stl,,not assessed,"));
    const std::string out = file("out") + "/ann/";
    const std::string html = readText(out + "report.html");
    const std::string words = textOf(html);
    EXPECT_THAT(latinWords(words.substr(0, words.find("作成："))), IsEmpty());  // then the program's name follows
    EXPECT_THAT(html, AllOf(HasSubstr("理想の壁を 0.40 mm"), HasSubstr("遠心から近心への断面")));
    EXPECT_THAT(readText(out + "report.pdf"), StartsWith("%PDF-"));
    const std::string json = readText(out + "report.json");
    ASSERT_EQ(assess(file("class"), {"--language", "en"}).exitCode, 2);
    EXPECT_EQ(readText(out + "report.json"), json) << "programs read one language";
    EXPECT_THAT(readText(out + "report.html"), HasSubstr("beyond the ideal wall"));
    expectRefused(assess(file("class"), {"--language", "de"}), "must be one of en,ja");
}

TEST_F(AssessCommand, NeedsAFontForJapanese) {
    const std::string fonts = text("fonts.conf", "<?xml version=\"1.0\"?><fontconfig></fontconfig>\n");
    const ProgramRun run = runTactooth({"assess", cavity("deep.stl", 0.3), "--expert", expert(), "--original", block(),
                                        "--language", "ja", "--out", file("out")},
                                       {{"FONTCONFIG_FILE", fonts}});
    expectRefused(run, "install the package fonts-ipafont-gothic");
    EXPECT_FALSE(std::filesystem::exists(file("out")));
}

TEST_F(AssessCommand, WritesTheReportToTheOutputToo) {
    const ProgramRun run = assess(cavity("deep.stl", 0.3), {"--json"});
    EXPECT_EQ(Json::parse(run.out), report());
}

TEST_F(AssessCommand, GivesNothingForAnUncutTooth) {
    const ProgramRun run = assess(block());
    EXPECT_EQ(run.exitCode, 1) << run.err;
    EXPECT_EQ(report()["mark"], 0);
    EXPECT_THAT(report()["limited_by"], testing::Contains("cleared_share"));
}

TEST_F(AssessCommand, GivesTheSameReportAgain) {
    const std::string student = cavity("deep.stl", 0.2);
    (void)assess(student);
    const std::string once = readText(file("out") + "/report.json");
    (void)assess(student);
    EXPECT_EQ(readText(file("out") + "/report.json"), once);
}

TEST_F(AssessCommand, LaysAScanOnTheTooth) {
    const Pose moved{Vec3(1.2, -0.8, 0.5), Quat(Eigen::AngleAxisd(0.08, Vec3(1, 2, 3).normalized()))};
    const TriangleMesh deep = blockWithCavity(Vec3(-2, -1.5, 2.7), Vec3(2, 1.5, 5));
    const std::string scan = surface("scan.stl", transformed(subdivided(deep, 3), moved));
    expectRefused(assess(scan), "does not lie on the uncut tooth");
    const ProgramRun run = assess(scan, {"--align"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_NEAR(metric(report(), "over_max")["value"], 0.3, 0.02);
    EXPECT_NEAR(metric(report(), "floor_depth_median")["value"], 2.3, 0.02);
    EXPECT_LT(report()["fit"]["residual"], 0.02);
    const std::string other = surface("other.stl", sphere(Vec3(0, 0, 1), 4.5, 48, 32));
    expectRefused(assess(other, {"--align"}), "cannot be laid on the uncut tooth");
}

TEST_F(AssessCommand, ReadsASavedToothWithoutAnOriginal) {
    EXPECT_TRUE(writeStl(test::cylinder(Vec3::Zero(), 0.5, 4, 64), file("bur.stl")));
    const auto drilled = [&](const std::string& name, double depth) {
        const std::string path = trajectory({{0, 0, 0.01, 5.2}, {0.4, 0, 0.01, 5 - depth}});
        const ProgramRun run =
            runTactooth({"cut", "--tooth", block(), "--tool", file("bur.stl"), "--trajectory", path, "--out",
                         file(name + ".stl"), "--save", file(name + ".tactooth"), "--record", file(name + ".ttsession"),
                         "--speed-rpm", "200000", "--feed", "rigid"});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return file(name);
    };
    const std::string ideal = drilled("ideal", 1.0) + ".tactooth", deep = drilled("deep", 1.4);
    const ProgramRun saved = runTactooth({"assess", deep + ".tactooth", "--expert", ideal, "--out", file("out")});
    EXPECT_NE(saved.exitCode, 2) << saved.err;
    EXPECT_EQ(metric(report(), "path_length")["reason"], "the work is not a recorded session");
    EXPECT_NEAR(metric(report(), "over_max")["value"], 0.4, 0.02);
    // The tip is 1.2 mm deep, halfway through what is too deep, after 1.4 of 1.6 of the way.
    const ProgramRun session = runTactooth({"assess", deep + ".ttsession", "--expert", ideal, "--out", file("out")});
    EXPECT_NE(session.exitCode, 2) << session.err;
    EXPECT_NEAR(metric(report(), "over_max")["value"], 0.4, 0.02);
    ASSERT_FALSE(metric(report(), "over_max")["moment"].is_null());
    EXPECT_NEAR(metric(report(), "over_max")["moment"], 0.39, 0.02);
    const auto cause = metric(report(), "over_max")["cause"];
    ASSERT_FALSE(cause.is_null());
    EXPECT_LE(cause["from"], cause["to"]);
    EXPECT_GT(cause["to"], 0.3);
    ASSERT_FALSE(report()["errors"].empty());
    EXPECT_EQ(report()["errors"][0]["wall"], "Floor");
    EXPECT_NEAR(report()["errors"][0]["depth"], 0.4, 0.02);
    EXPECT_FALSE(report()["errors"][0]["moment"].is_null());
    EXPECT_THAT(readText(file("out") + "/report.html"), HasSubstr("deep.ttsession' --until 1 "));
    EXPECT_GT(report()["seconds"], 0.3);
    EXPECT_EQ(metric(report(), "path_length")["reason"], "no hand has touched the tooth in this session");
}

TEST_F(AssessCommand, MeasuresTheHandInASession) {
    const ProgramRun played = runTactooth({"demo", "--seconds", "3", "--out", file("demo")});
    ASSERT_EQ(played.exitCode, 0) << played.err;
    const ProgramRun run =
        runTactooth({"assess", file("demo") + "/session.ttsession", "--exercise", "class-1-46", "--out", file("out")});
    EXPECT_NE(run.exitCode, 2) << run.err;
    const auto value = [&](const std::string& id) { return metric(report(), id)["value"].get<double>(); };
    EXPECT_NEAR(value("session_time"), 3, 0.01);
    EXPECT_GT(value("drilling_time"), 0.2);
    EXPECT_LT(value("drilling_time") + value("idle_time") + value("dead_time"), 3.01);
    EXPECT_GT(value("path_length"), 5);
    EXPECT_GE(value("strokes"), 1);
    EXPECT_GT(value("force_peak"), value("force_p95"));
    EXPECT_GT(value("force_p95"), value("force_mean"));
    EXPECT_GT(value("removed_enamel"), 0.01);
    EXPECT_GT(value("efficiency"), 0);
    EXPECT_THAT(readText(file("out") + "/report.html"), HasSubstr("Force and depth during the session"));
    EXPECT_EQ(pagesIn(readText(file("out") + "/report.pdf")), 2U);
    EXPECT_GT(value("economy"), 0);
    EXPECT_LE(value("economy"), 1);
    EXPECT_EQ(metric(report(), "path_ratio")["reason"], "the ideal is not an expert's recorded session");
    EXPECT_NEAR(value("target_time") + value("band_time") + value("outside_time"), 1, 1e-9);
    EXPECT_EQ(metric(report(), "periphery_first")["reason"],
              "hardly any of the deep decay was removed in this session");
    for (const char* id : {"clutch_uses", "finger_lifts", "mirror_time"}) {
        EXPECT_TRUE(metric(report(), id)["value"].is_null()) << id;
    }
}

TEST_F(AssessCommand, ComparesTheHandWithThatOfAnExpertsSession) {
    const std::string session = file("demo") + "/session.ttsession";
    ASSERT_EQ(runTactooth({"demo", "--seconds", "3", "--out", file("demo")}).exitCode, 0);
    const ProgramRun run = runTactooth({"assess", session, "--expert", session, "--out", file("out")});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(metric(report(), "path_ratio")["value"], 1);
    EXPECT_GT(metric(report(), "target_time")["value"], 0.8) << "what the bur has cut is the ideal";
    EXPECT_EQ(metric(report(), "outside_time")["value"], 0);
}

TEST_F(AssessCommand, AssessesAClassWithARowForEach) {
    std::filesystem::create_directory(file("class"));
    (void)cavity("class/ann.stl", 0.05);
    (void)cavity("class/ben, b.stl", 1.5);
    (void)text("class/carl.stl", "junk\n");
    (void)text("class/readme.txt", "no work\n");
    (void)text("class/.hidden.stl", "junk\n");
    const ProgramRun run = assess(file("class"));
    EXPECT_EQ(run.exitCode, 2) << "one cannot be assessed";
    EXPECT_THAT(run.out, AllOf(HasSubstr("passed"), HasSubstr("failed"), HasSubstr("carl.stl: this is text")));
    const std::string csv = readText(file("out") + "/class.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4) << csv;
    EXPECT_THAT(csv, AllOf(StartsWith("work,mark,result,cleared_share,cleared_share_score,"), HasSubstr("\nann.stl,"),
                           HasSubstr("\n\"ben, b.stl\","), HasSubstr("\ncarl.stl,,not assessed,")));
    const std::string html = readText(file("out") + "/class.html");
    EXPECT_THAT(
        html, AllOf(HasSubstr("href=\"ben%2C%20b/report.html\""), HasSubstr("1 of 2 passed"), Not(HasSubstr("http"))));
    for (const char* each : {"ann", "ben, b"}) {
        EXPECT_TRUE(std::filesystem::exists(file("out") + "/" + each + "/report.pdf"));
    }
    EXPECT_FALSE(std::filesystem::exists(file("out") + "/carl"));
    std::filesystem::remove(file("class/carl.stl"));
    const ProgramRun two = assess(file("class"), {"--json"});
    EXPECT_EQ(two.exitCode, 1) << "one fails";
    const Json rows = Json::parse(two.out);
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0]["work"], "ann.stl");
    EXPECT_EQ(rows[0]["pass"], true);
    EXPECT_EQ(rows[1]["folder"], "ben, b");
    EXPECT_EQ(rows[1]["pass"], false);
    expectRefused(assess(file("class"), {"--name", "Ann"}), "a folder has many works");
    std::filesystem::remove(file("class/ben, b.stl"));
    std::filesystem::rename(file("class/ann.stl"), file("class/class.html.stl"));
    EXPECT_EQ(assess(file("class")).exitCode, 0) << "all pass";
    EXPECT_TRUE(std::filesystem::exists(file("out") + "/class.html.stl/report.html")) << "beside the table";
    std::filesystem::remove(file("class/class.html.stl"));
    expectRefused(assess(file("class")), "there is no work in this folder");
}

TEST_F(AssessCommand, ShowsTheTrendOverEarlierTrials) {
    const std::string student = cavity("deep.stl", 0.3);
    const auto trial = [&](const std::string& name, const std::vector<std::string>& more) {
        std::vector<std::string> all = {"assess",     student, "--expert", expert(),
                                        "--original", block(), "--out",    file("all/" + name)};
        all.insert(all.end(), more.begin(), more.end());
        return runTactooth(all);
    };
    (void)trial("t1", {});
    const std::string alone = readText(file("all/t1/report.html"));
    EXPECT_THAT(alone, Not(HasSubstr("Trials of this exercise")));
    (void)trial("strict", {"--rubric", "near-ideal-strict"});
    const ProgramRun run = trial("t2", {"--earlier", file("all")});
    EXPECT_NE(run.exitCode, 2) << run.err;
    EXPECT_THAT(run.err, AllOf(HasSubstr("strict"), HasSubstr("is left out: its rubric is")));
    const Json json = Json::parse(readText(file("all/t2/report.json")));
    ASSERT_EQ(json["trend"]["marks"].size(), 2U);
    EXPECT_EQ(json["trend"]["marks"][1], json["mark"]);
    EXPECT_TRUE(json["trend"]["interval"].is_null()) << "two are too few";
    EXPECT_THAT(readText(file("all/t2/report.html")), HasSubstr("Trials of this exercise"));
    (void)trial("t2", {"--earlier", file("all")});
    EXPECT_EQ(Json::parse(readText(file("all/t2/report.json"))), json) << "its own old report does not count";
    std::filesystem::create_directory(file("none"));
    EXPECT_THAT(trial("t3", {"--earlier", file("none")}).err, HasSubstr("There is no earlier trial"));
    expectRefused(trial("t3", {"--earlier", missing()}), "cannot be read");
    (void)text("none/report.json", "{}");
    expectRefused(trial("t3", {"--earlier", file("none")}), "this is no report of an assessment");
}

TEST_F(AssessCommand, PutsTheTrialsOfAStudentTogether) {
    std::filesystem::create_directories(file("class/ann"));
    (void)cavity("class/ann/2.stl", 0.3);
    (void)cavity("class/ann/10.stl", 0.05);
    (void)cavity("class/ben.stl", 0.1);
    const ProgramRun run = assess(file("class"));
    EXPECT_NE(run.exitCode, 2) << run.err;
    const std::string out = file("out") + "/";
    const Json last = Json::parse(readText(out + "ann/10/report.json"));
    EXPECT_EQ(last["name"], "ann");
    ASSERT_EQ(last["trend"]["marks"].size(), 2U) << "10 comes after 2";
    EXPECT_TRUE(Json::parse(readText(out + "ann/2/report.json"))["trend"].is_null());
    EXPECT_THAT(readText(out + "ann/student.html"),
                AllOf(HasSubstr("Trials of ann"), HasSubstr("href=\"10/report.html\""), HasSubstr("<svg")));
    EXPECT_THAT(readText(out + "class.html"),
                AllOf(HasSubstr("href=\"ann/student.html\""), HasSubstr("href=\"ann/10/report.html\""),
                      HasSubstr("href=\"ben/report.html\"")));
    EXPECT_THAT(readText(out + "class.csv"), AllOf(HasSubstr("\nann/2.stl,"), HasSubstr("\nben.stl,")));
    expectRefused(assess(file("class"), {"--earlier", file("out")}), "give each student a folder");
    const auto learned = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = {"learned", file("out"), "--out", file("learned")};
        all.insert(all.end(), more.begin(), more.end());
        return runTactooth(all);
    };
    const ProgramRun tested = learned({"--json"});
    EXPECT_EQ(tested.exitCode, 1) << tested.err;
    const Json result = Json::parse(tested.out);
    ASSERT_EQ(result["students"].size(), 2U);
    EXPECT_EQ(result["students"][0]["name"], "ann");
    EXPECT_EQ(result["students"][0]["trials"].size(), 2U);
    EXPECT_THAT(readText(file("learned/learned.html")), HasSubstr("Has it been learnt?"));
    EXPECT_THAT(learned({"--language", "ja"}).out, HasSubstr("more passed trials"));
    EXPECT_THAT(readText(file("learned/learned.html")), HasSubstr("習得できたか"));
    // With rates that lie far apart, two passed trials can be enough: 0.1 squared is 1 %.
    EXPECT_EQ(learned({"--adequate", "0.01", "--inadequate", "0.9", "--trials", "2"}).exitCode, 1) << "ben has but one";
    std::filesystem::remove_all(file("out") + "/ben");
    EXPECT_EQ(learned({"--adequate", "0.01", "--inadequate", "0.9", "--trials", "2"}).exitCode, 0);
    expectRefused(learned({"--trials", "1", "--adequate", "0.001", "--inadequate", "0.999"}), "give at least so many");
    expectRefused(learned({"--adequate", "0.5", "--inadequate", "0.4"}), "cannot be distinguished");
    expectRefused(learned({"--acceptable", "0.5", "--unacceptable", "0.4"}), "are not in order");
    expectRefused(runTactooth({"learned", file("class"), "--out", file("learned")}), "there is no report.json");
}

/// Ten works of five students, each deeper than the one before; the teachers mark by the depth.
TEST_F(AssessCommand, CalibratesARubricToTheMarksOfTeachers) {
    std::filesystem::create_directory(file("class"));
    std::string marks = "work,student,teacher,mark\n";
    for (int i = 0; i < 10; ++i) {
        // As a Mac writes it in the file's name, and a PC in the table.
        const std::string name = i == 3 ? "w\u00e9" : "w" + std::to_string(i);
        (void)cavity("class/" + (i == 3 ? std::string("we\u0301") : name) + ".stl", 0.05 * i);
        const std::string begin = name + ",s" + std::to_string(i / 2);
        marks += begin + ",Sato," + std::to_string(95 - 7 * i) + "\n";
        marks += begin + ",Brown," + std::to_string(91 - 6 * i) + "\n";
    }
    const std::vector<std::string> command = {"calibrate",  file("class"),   "--expert", expert(),
                                              "--original", block(),         "--marks",  text("marks.csv", marks),
                                              "--out",      file("our.toml")};
    std::vector<std::string> asJson = command;
    asJson.emplace_back("--json");
    const ProgramRun run = runTactooth(asJson);
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["works"], 10);
    EXPECT_EQ(json["students"], 5);
    EXPECT_GT(json["teachers"]["icc"], 0.8);
    EXPECT_LT(json["fitted"]["rms"], json["start"]["rms"]);
    const ProgramRun again = runTactooth({"assess", file("class/w0.stl"), "--expert", expert(), "--original", block(),
                                          "--rubric", file("our.toml"), "--out", file("out")});
    EXPECT_EQ(again.exitCode, 0) << again.err;  // the fitted rubric can be used
    const std::string once = readText(file("our.toml"));
    std::filesystem::remove(file("class/w9.stl"));
    expectRefused(runTactooth(command), "10");  // too few
    EXPECT_EQ(readText(file("our.toml")), once);
    std::vector<std::string> onItself = command;
    onItself.insert(onItself.end(), {"--rubric", file("our.toml")});
    expectRefused(runTactooth(onItself), "our.toml");
    EXPECT_EQ(readText(file("our.toml")), once) << "where the fit begins is not replaced";
    std::vector<std::string> other = command;
    other[7] = text("other.csv", "work,student,teacher,mark\nx,y,z,50\n");
    expectRefused(runTactooth(other), "none of the works has a mark");
    other[7] = text("bad.csv", "work,student,teacher,mark\nw0,y,z,500\n");
    expectRefused(runTactooth(other), "bad.csv, line 2");
}

TEST_F(AssessCommand, RefusesWhatCannotBeAssessed) {
    const std::string student = cavity("student.stl", 0.1);
    expectRefused(runTactooth({"assess", student, "--out", file("out")}), "there is nothing to compare with");
    expectRefused(runTactooth({"assess", student, "--expert", expert(), "--out", file("out")}),
                  "does not say what the tooth was like before; give the uncut tooth by --original");
    expectRefused(runTactooth({"assess", student, "--exercise", "nine", "--out", file("out")}),
                  "there is no exercise 'nine'");
    expectRefused(assess(missing()), "there is no such file");
    expectRefused(assess(student, {"--rubric", "nine"}), "there is no rubric 'nine'");
    expectRefused(assess(student, {"--rubric", text("bad.toml", "name = 3\n")}), "bad.toml, line 1");
    expectRefused(assess(surface("huge.stl", box(Vec3(-500, -5, -5), Vec3(5, 5, 5)))), "more than any tooth");
    expectRefused(assess(text("no.stl", "solid nothing\nendsolid\n")), "no.stl");
    EXPECT_FALSE(std::filesystem::exists(file("out")));
}

TEST_F(AssessCommand, DocumentsEachMetric) {
    const std::string page = readText(TACTOOTH_PAGES "/../assessment.md");
    (void)assess(cavity("deep.stl", 0.3));
    for (const Json& each : report()["metrics"]) {
        EXPECT_THAT(page, HasSubstr("`" + each["id"].get<std::string>() + "`"));
    }
}

}  // namespace
}  // namespace tactooth
