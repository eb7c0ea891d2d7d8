// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/live/live_stream.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>

#include "live/udp_listener.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

Tick someTick(std::uint32_t number) {
    Tick tick;
    tick.number = number;
    tick.time = 0.001 * number;
    tick.contact.proxy.position = Vec3(1, 2, 3);
    tick.force.wrench.force = Vec3(0.1, 0.2, 0.3);
    tick.spindle.speedRpm = 200'000;
    tick.contact.triangles = 4;
    tick.input.cutting = tick.contact.placed = true;
    return tick;
}

TEST(LiveStream, SendsTheNewestTick) {
    const test::UdpListener listener;
    const auto stream = LiveStream::open(listener.url());
    ASSERT_TRUE(stream) << stream.error().message();
    (*stream)->write(someTick(7));
    const std::vector<std::byte> datagram = listener.next();
    const auto expected = streamDatagram(someTick(7));
    ASSERT_EQ(datagram.size(), expected.size());
    EXPECT_TRUE(std::equal(datagram.begin(), datagram.end(), expected.begin()));
}

/// Exactly the lines of the page.
TEST(LiveStream, TheLinesOfThePageReadIt) {
    const std::string page = test::readText(TACTOOTH_LIVE_STREAM_PAGE);
    const std::string begin = "```python\n";
    const std::size_t from = page.find(begin) + begin.size();
    const std::string lines = page.substr(from, page.find("```", from) - from);
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 10);
    const test::TemporaryFolder folder;
    std::ofstream(folder / "read.py") << lines;
    int port = 0;
    {
        const test::UdpListener free;
        port = free.port();
    }
    const pid_t reader = ::fork();
    if (reader == 0) {
        if (std::freopen((folder / "out").c_str(), "w", stdout) == nullptr) ::_exit(9);
        ::execl(TACTOOTH_PYTHON, "python3", (folder / "read.py").c_str(), std::to_string(port).c_str(), nullptr);
        ::_exit(9);
    }
    const auto stream = LiveStream::open("udp://127.0.0.1:" + std::to_string(port));
    ASSERT_TRUE(stream);
    int status = -1;
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    std::uint32_t number = 0;
    while (::waitpid(reader, &status, WNOHANG) == 0 && std::chrono::steady_clock::now() < limit) {
        (*stream)->write(someTick(++number));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    std::istringstream out(test::readText(folder / "out"));
    int ticks = 0;
    std::uint32_t last = 0;
    for (std::string line; std::getline(out, line); ++ticks) {
        std::istringstream fields(line);
        std::uint32_t now = 0;
        double time = 0, x = 0, y = 0, z = 0, fx = 0, fy = 0, fz = 0, speed = 0;
        int contacts = 0, flags = 0;
        fields >> now >> time >> x >> y >> z >> fx >> fy >> fz >> speed >> contacts >> flags;
        EXPECT_GT(now, last);
        last = now;
        EXPECT_NEAR(time, 0.001 * now, 1e-9);
        EXPECT_EQ(Vec3(x, y, z), Vec3(1, 2, 3));
        EXPECT_EQ(Vec3(fx, fy, fz), Vec3(0.1, 0.2, 0.3));
        EXPECT_EQ(speed, 200'000);
        EXPECT_EQ(contacts, 4);
        EXPECT_EQ(flags, 3);
    }
    EXPECT_EQ(ticks, 100);
}

TEST(LiveStream, NobodyNeedListen) {
    const auto stream = LiveStream::open("udp://:9");
    ASSERT_TRUE(stream);
    for (std::uint32_t i = 0; i < 20; ++i) (*stream)->write(someTick(i));
}

TEST(StreamAddress, IsReadFromItsForm) {
    for (const auto& [url, host, port] : {std::tuple("udp://127.0.0.1:9870", "127.0.0.1", 9870),
                                          {"udp://[::1]:1", "::1", 1},
                                          {"udp://:65535", "127.0.0.1", 65535},
                                          {"udp://example.org:80", "example.org", 80}}) {
        const auto address = StreamAddress::parse(url);
        ASSERT_TRUE(address) << url;
        EXPECT_EQ(address->host, host);
        EXPECT_EQ(address->port, port);
    }
}

TEST(StreamAddress, WhatIsNoneHasItsSentence) {
    for (const std::string url :
         {"", "udp://", "udp://127.0.0.1", "udp://127.0.0.1:", "udp://127.0.0.1:0", "udp://127.0.0.1:65536",
          "udp://127.0.0.1:-1", "udp://127.0.0.1:80x", "udp://::1:80", "udp://[::1]", "udp://[]:80", "tcp://h:80",
          "127.0.0.1:80", "udp://a/b:80", "udp://u@h:80", "udp://127.0.0.1:99999999999999999999"}) {
        const auto address = StreamAddress::parse(url);
        ASSERT_FALSE(address) << url;
        EXPECT_TRUE(address.error().message().starts_with("--stream " + url)) << address.error().message();
    }
    const auto unknown = LiveStream::open("udp://no-such-host.invalid:80");
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().message().find("not found"), std::string::npos) << unknown.error().message();
}

}  // namespace
}  // namespace tactooth
