// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Where no window can be opened, the program and its doctor report the same.
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/cli_test.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using namespace test;

/// An environment without a display, wherever the tests run, except for the variables of `more`.
Environment displayless(const TemporaryFolder& home, const Environment& more) {
    Environment environment = {
        {"DISPLAY", std::nullopt},  {"WAYLAND_DISPLAY", std::nullopt},         {"QT_QPA_PLATFORM", std::nullopt},
        {"ALSOFT_DRIVERS", "none"}, {"XDG_CONFIG_HOME", home.path().string()}, {"XDG_DATA_HOME", home.path().string()}};
    for (const auto& [name, value] : more) environment[name] = value;
    return environment;
}

/// The doctor's finding about the display.
nlohmann::json displayFinding(const ProgramRun& doctor) { return nlohmann::json::parse(doctor.out).at(0); }

TEST(Display, WithoutOneTheProgramAndTheDoctorSayTheSameAndWhatToDo) {
    const TemporaryFolder home;
    const std::vector<std::pair<Environment, std::string>> cases = {
        {{}, "there is no display"},
        {{{"DISPLAY", ""}}, "there is no display"},
        {{{"DISPLAY", ":7777"}}, "the display ':7777' (DISPLAY) cannot be reached"},
        {{{"WAYLAND_DISPLAY", "nowhere"}}, "the display 'nowhere' (WAYLAND_DISPLAY) cannot be used"},
        {{{"QT_QPA_PLATFORM", "bogus"}}, "no window can be opened on Qt's platform 'bogus'; unset QT_QPA_PLATFORM"}};
    for (const auto& [more, sentence] : cases) {
        SCOPED_TRACE(sentence);
        const Environment environment = displayless(home, more);
        const ProgramRun window = runTactooth({}, environment);
        EXPECT_EQ(window.exitCode, 2);
        EXPECT_THAT(window.err, AllOf(StartsWith("tactooth: " + sentence), HasSubstr("start it from a desktop"),
                                      HasSubstr("ssh -X"), HasSubstr("tactooth demo")));
        EXPECT_EQ(std::ranges::count(window.err, '\n'), 1);
        const ProgramRun doctor = runTactooth({"doctor", "--json"}, environment);
        EXPECT_EQ(doctor.exitCode, 1);
        EXPECT_EQ(displayFinding(doctor).at("verdict"), "missing");
        const std::string text = displayFinding(doctor).at("text");
        EXPECT_EQ(text.substr(1) + "\n", window.err.substr(std::string("tactooth: ").size() + 1));
        EXPECT_TRUE(text.front() == 'T' || text.front() == 'N') << text;
    }
}

/// A server on a port of this computer. It accepts every connection and then acts according to `kind`.
class FakeServer {
public:
    enum class Kind { Silent, NeverAccepts, HalfAnAnswer, HalfAnAnswerAndOn, Closes };

    explicit FakeServer(Kind kind) : kind_(kind), socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        for (display_ = kFirst; display_ < kFirst + 500; ++display_) {
            address.sin_port = htons(static_cast<std::uint16_t>(kX11Port + display_));
            if (::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) break;
        }
        ::listen(socket_, kind == Kind::NeverAccepts ? 0 : 8);
        if (kind != Kind::NeverAccepts) thread_ = std::thread([this] { serve(); });
    }
    ~FakeServer() {
        ::shutdown(socket_, SHUT_RDWR);
        if (thread_.joinable()) thread_.join();
        ::close(socket_);
        for (const int each : connections_) ::close(each);
    }
    FakeServer(const FakeServer&) = delete;
    FakeServer& operator=(const FakeServer&) = delete;

    [[nodiscard]] std::string display() const { return "127.0.0.1:" + std::to_string(display_); }

private:
    static constexpr int kX11Port = 6000, kFirst = 3000;

    void serve() {
        for (int connection = 0; (connection = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC)) >= 0;) {
            connections_.push_back(connection);
            // The head of an accepted setup; its length counts words of 4 bytes.
            const unsigned char head[8] = {1, 0, 11, 0, 0, 0, 200, 0};
            if (kind_ == Kind::HalfAnAnswer) (void)!::send(connection, head, 3, MSG_NOSIGNAL);
            if (kind_ == Kind::HalfAnAnswerAndOn) (void)!::send(connection, head, sizeof head, MSG_NOSIGNAL);
            if (kind_ == Kind::Closes) ::shutdown(connection, SHUT_RDWR);
        }
    }

    Kind kind_;
    int socket_;
    int display_ = 0;
    std::vector<int> connections_;
    std::thread thread_;
};

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Within three seconds beyond those that a slow machine needs to start the program. A busy one may need more now and
/// then: one prompt report is enough.
TEST(Display, OneThatNeverAnswersIsReportedWithinThreeSeconds) {
    constexpr int kTries = 3;
    const TemporaryFolder home;
    for (const FakeServer::Kind kind : {FakeServer::Kind::Silent, FakeServer::Kind::NeverAccepts,
                                        FakeServer::Kind::HalfAnAnswer, FakeServer::Kind::HalfAnAnswerAndOn}) {
        double shortest = std::numeric_limits<double>::infinity();
        for (int i = 0; i < kTries && shortest >= 3; ++i) {
            const FakeServer server(kind);
            const auto before = std::chrono::steady_clock::now();
            EXPECT_EQ(runTactooth({"--version"}).exitCode, 0);
            const double toStart = secondsSince(before);
            const auto start = std::chrono::steady_clock::now();
            const ProgramRun window = runTactooth({}, displayless(home, {{"DISPLAY", server.display()}}));
            shortest = std::min(shortest, secondsSince(start) - toStart);
            EXPECT_EQ(window.exitCode, 2);
            EXPECT_THAT(window.err, StartsWith("tactooth: the display '" + server.display() +
                                               "' (DISPLAY) does not answer; start it from a desktop"));
            EXPECT_EQ(std::ranges::count(window.err, '\n'), 1);
        }
        EXPECT_LT(shortest, 3);
    }
    const FakeServer server(FakeServer::Kind::Closes);
    const ProgramRun window = runTactooth({}, displayless(home, {{"DISPLAY", server.display()}}));
    EXPECT_THAT(window.err, HasSubstr("cannot be reached or refuses the connection")) << "a refusal is an answer";
}

TEST(Display, APlatformWithoutAScreenIsOneToTheDoctorToo) {
    const TemporaryFolder home;
    const ProgramRun doctor = runTactooth({"doctor", "--json"}, displayless(home, {{"QT_QPA_PLATFORM", "offscreen"}}));
    EXPECT_EQ(displayFinding(doctor).at("verdict"), "fine");
}

TEST(Display, WhatIsWrongWithAFileIsSaidFirst) {
    const TemporaryFolder home;
    const ProgramRun run = runTactooth({"--bur", "/no/such/bur.stl"}, displayless(home, {}));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("/no/such/bur.stl"));
}

}  // namespace
}  // namespace tactooth
