// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The same hand through Tactooth and through the collision libraries that were found when this was configured: at each
// pose every one of them is asked in turn, so that whatever else the machine does meets them alike. Usage and meaning:
// bench/README.md.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "experiments/contact_timing.h"
#include "experiments/quantile.h"
#include "experiments/standard_teeth.h"
#include "experiments/thread_clock.h"
#include "peers/peer.h"
#include "session/io/run_metadata.h"

namespace tactooth::bench {
namespace {

class Ours final : public Baseline {
public:
    Ours(const std::shared_ptr<const Surface>& surface, const std::shared_ptr<const ToolShape>& tool, const Pose& start)
        : body_(tool) {
        body_.setSurface(surface);
        body_.placeAt(start);
    }
    [[nodiscard]] std::string name() const override { return "Tactooth, one tick of the proxy"; }
    [[nodiscard]] std::string gives() const override { return "exact depth"; }
    bool tick(const Pose& deviceInTooth) override { return body_.moveToward(deviceInTooth).contactCount > 0; }

private:
    ProxySolver body_;
};

struct Times {
    std::vector<double> micros;
    std::size_t touching = 0;
};

/// Times of all peers at the poses where the first of them touches.
std::vector<Times> interleaved(const Peers& peers, std::span<const Pose> hand) {
    std::vector<Times> times(peers.size());
    std::vector<double> micros(peers.size());
    std::vector<char> touches(peers.size());
    for (const Pose& pose : hand) {
        for (std::size_t p = 0; p < peers.size(); ++p) {
            const double start = threadMicros();
            touches[p] = peers[p]->tick(pose) ? 1 : 0;
            micros[p] = threadMicros() - start;
        }
        if (touches.front() == 0) continue;
        for (std::size_t p = 0; p < peers.size(); ++p) {
            times[p].micros.push_back(micros[p]);
            times[p].touching += static_cast<std::size_t>(touches[p]);
        }
    }
    return times;
}

void print(const Peers& peers, std::vector<Times> times) {
    std::printf("  %-36s %-12s %9s %9s %9s %8s %8s %9s\n", "way", "gives", "p50 us", "p99 us", "max us", "p50 x",
                "p99 x", "touching");
    const double oursP50 = quantile(times.front().micros, 0.5);
    const double oursP99 = quantile(times.front().micros, 0.99);
    for (std::size_t p = 0; p < peers.size(); ++p) {
        const double p50 = quantile(times[p].micros, 0.5);
        const double p99 = quantile(times[p].micros, 0.99);
        const double share = static_cast<double>(times[p].touching) / static_cast<double>(times[p].micros.size());
        std::printf("  %-36s %-12s %9.1f %9.1f %9.1f %8.1f %8.1f %8.1f%%\n", peers[p]->name().c_str(),
                    peers[p]->gives().c_str(), p50, p99, quantile(times[p].micros, 1), p50 / oursP50, p99 / oursP99,
                    100 * share);
    }
    std::fflush(stdout);
}

void compare(const StandardTooth& tooth, double speed) {
    const TriangleMesh bur = standardBur();
    const TriangleMesh hull = convexHull(bur);
    const std::vector<Pose> hand = toolTrajectory(tooth.mesh, standardToolPath(speed));
    Peers peers;
    peers.push_back(
        std::make_unique<Ours>(plainSurface(tooth.mesh), std::make_shared<const ToolShape>(bur), hand.front()));
    [[maybe_unused]] const Pair pair{tooth.mesh, bur, hull};
#if defined(TACTOOTH_WITH_FCL)
    addFclPeers(pair, peers);
#endif
#if defined(TACTOOTH_WITH_BULLET)
    addBulletPeers(pair, peers);
#endif
    std::vector<Times> times = interleaved(peers, hand);
    std::printf("\n%s (%s), %zu triangles, bur %zu triangles (hull %zu), %g cm/s, %zu poses in contact\n",
                tooth.name.c_str(), tooth.source.c_str(), tooth.mesh.triangles.size(), bur.triangles.size(),
                hull.triangles.size(), speed / 10, times.front().micros.size());
    print(peers, std::move(times));
}

int run(const std::string& only) {
    const RunMetadata facts = currentRunMetadata();
    std::printf("machine:  %s\ncompiler: %s\ncommit:   %s\ncommand:  %s\n", facts.machine.c_str(),
                facts.compiler.c_str(), facts.commit.c_str(), facts.command.c_str());
#if !defined(TACTOOTH_WITH_FCL)
    std::printf("FCL was not found when this was configured (Debian package libfcl-dev): left out.\n");
#endif
#if !defined(TACTOOTH_WITH_BULLET)
    std::printf("Bullet was not found when this was configured (Debian package libbullet-dev): left out.\n");
#endif
    for (const StandardToothKind kind : kStandardTeeth) {
        const auto tooth = standardTooth(kind);
        if (!tooth) return std::fprintf(stderr, "%s\n", tooth.error().message().c_str()), 2;
        if (tooth->name.find(only) == std::string::npos) continue;
        for (const double speed : {kSlowSpeed, kFastSpeed}) compare(*tooth, speed);
    }
    return 0;
}

}  // namespace
}  // namespace tactooth::bench

int main(int count, char** arguments) {
    const bool named = count == 3 && std::strcmp(arguments[1], "--only") == 0;
    if (count != 1 && !named) return std::fprintf(stderr, "usage: peers_bench [--only PART_OF_A_TOOTHS_NAME]\n"), 2;
    return tactooth::bench::run(named ? arguments[2] : "");
}
