// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/spray_particle_system.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactooth {
namespace {

// Jets: three holes under the head of the handpiece aim at the bur's tip. At metres a second an eye sees lines, so each
// call places new drops along them.
constexpr int kJets = 3;
constexpr int kDropsPerJet = 40;
constexpr double kHoleRadius = 2.9, kHoleHeight = 9.3;  // mm in the tool frame: beside the chuck's nose
constexpr double kAimHeight = 0.8;                      // mm above the tip
constexpr double kJetSpread = 0.22;                     // mm at its end

// Mist: 50 ml/min give far more drops than can be drawn; so many balls a second stand for them.
constexpr double kMistPerSecond = 1600;
constexpr double kMistLife = 0.32, kChipLife = 0.45;        // s, until they are invisible
constexpr float kMistGrowth = 2.2F;                         // mm/s: eddies spread the drops of a ball
constexpr double kMinGrain = 0.008, kLargestGrain = 0.024;  // mm across
constexpr double kFastest = 20000;                          // mm/s: rim of a 1.3 mm bur at 300,000 rev/min

// Air brakes a small ball of density rho and width d within rho d^2 / (18 mu) (G. G. Stokes, 1851): 3.1 us for a
// micrometre of water in air (18 uPa s). A chip is 2.9 times as heavy and breaks up: the same number serves.
constexpr double kRelaxation = 3.1;  // s/mm^2
constexpr double kGravity = 9810;    // mm/s^2, toward the roots
constexpr double kTubeRadius = 3;    // mm
constexpr double kTubeFlow = 3.3e5;  // mm^3/s: 20 l/min, a saliva ejector that lets one still see the spray
constexpr double kTwoPi = 2 * std::numbers::pi;

/// Displacement toward the tube within `dt` at distance `r`: air flows in through a half sphere, so r^3 falls by
/// 3 Q t / (2 pi).
double drawnTo(double r, double dt) { return std::cbrt(std::max(0.0, r * r * r - 3 * kTubeFlow * dt / kTwoPi)); }

float radiusOfChip() { return static_cast<float>(std::cbrt(3 * SprayParticleSystem::kChipVolume / (2 * kTwoPi))); }

}  // namespace

SprayParticleSystem::SprayParticleSystem(double burRadius, const Vec3& tube)
    : burRadius_(burRadius), tube_(tube.cast<float>()) {}

/// Uniformly distributed; the same numbers on every computer.
float SprayParticleSystem::random(double low, double high) {
    return static_cast<float>(low + (high - low) * static_cast<double>(random_()) / 4294967296.0);
}

void SprayParticleSystem::advance(const SprayInput& now, double dt) {
    std::erase_if(particles_, [](const SprayParticle& particle) { return particle.kind == SprayParticleKind::Jet; });
    fly(now, static_cast<float>(dt));
    if (now.water > 0) {
        emitMist(now, dt);
        emitJets(now);
    }
    emitChips(now, dt);
    if (particles_.size() > kMaxParticles)
        particles_.erase(particles_.begin(), particles_.end() - static_cast<std::ptrdiff_t>(kMaxParticles));
}

void SprayParticleSystem::fly(const SprayInput& now, float dt) {
    for (SprayParticle& particle : particles_) {
        const Vec3f air(0, 0, static_cast<float>(-kGravity) * particle.relaxation);
        const float left = std::exp(-dt / particle.relaxation);
        particle.place += air * dt + (particle.velocity - air) * (particle.relaxation * (1 - left));
        particle.velocity = air + (particle.velocity - air) * left;
        particle.age += dt;
        if (particle.kind == SprayParticleKind::Mist) particle.radius += kMistGrowth * dt;
        if (!now.suction) continue;
        const Vec3f away = particle.place - tube_;
        const double distance = away.norm();
        const double drawn = drawnTo(distance, dt);
        if (drawn < kTubeRadius) particle.age = particle.lifetime;
        particle.place = tube_ + away * static_cast<float>(drawn / std::max(distance, 1e-9));
    }
    std::erase_if(particles_, [](const SprayParticle& particle) { return particle.age >= particle.lifetime; });
}

void SprayParticleSystem::emitJets(const SprayInput& now) {
    for (int jet = 0; jet < kJets; ++jet) {
        const double angle = kTwoPi * (jet + 0.25) / kJets;
        const Vec3 hole(kHoleRadius * std::cos(angle), kHoleRadius * std::sin(angle), kHoleHeight);
        const Vec3 aim(0, 0, kAimHeight);
        for (int i = 0; i < kDropsPerJet; ++i) {
            const double direction = random(0, 1);
            const double spread = kJetSpread * direction;
            const Vec3 aside{random(-spread, spread), random(-spread, spread), random(-spread, spread)};
            SprayParticle drop;
            drop.place = (now.toolInTooth * (hole + direction * (aim - hole) + aside)).cast<float>();
            drop.radius = random(0.04, 0.09) * static_cast<float>(std::sqrt(now.water));
            drop.kind = SprayParticleKind::Jet;
            particles_.push_back(drop);
        }
    }
}

/// A particle that leaves the rim during the last `dt`: along the rim, scattered, away from the tooth in contact.
SprayParticle SprayParticleSystem::thrown(const SprayInput& now, double dt) {
    const double angle = random(0, kTwoPi);
    const Vec3 rim(burRadius_ * std::cos(angle), burRadius_ * std::sin(angle), random(0.1, 0.9));
    const Vec3 along(std::sin(angle), -std::cos(angle), 0);                       // clockwise, seen from the shaft
    const Vec3 scatter{random(-0.5, 0.5), random(-0.5, 0.5), random(-0.2, 0.6)};  // braces: in this order
    Vec3 direction = now.toolInTooth.rotation * (along + scatter);
    direction += std::max(0.0, 0.15 - direction.dot(now.normal)) * now.normal;
    const double speed = std::min(kFastest, burRadius_ * kTwoPi * now.speedRpm / 60) * random(0.1, 1);
    const double grain = random(kMinGrain, kLargestGrain);
    SprayParticle particle;
    particle.place = (now.toolInTooth * rim).cast<float>();
    particle.velocity = (speed * direction.normalized()).cast<float>();
    particle.relaxation = static_cast<float>(kRelaxation * grain * grain);
    particle.age = -random(0, dt);  // it left at some time during the step
    const float flown = static_cast<float>(dt) + particle.age;
    particle.place += particle.velocity * (particle.relaxation * (1 - std::exp(-flown / particle.relaxation)));
    particle.velocity *= std::exp(-flown / particle.relaxation);
    particle.age = flown;
    return particle;
}

void SprayParticleSystem::emitMist(const SprayInput& now, double dt) {
    mistDue_ += kMistPerSecond * now.water * dt;
    for (; mistDue_ >= 1; mistDue_ -= 1) {
        SprayParticle drop = thrown(now, dt);
        drop.kind = SprayParticleKind::Mist;
        drop.radius = random(0.02, 0.12) + kMistGrowth * drop.age;
        drop.lifetime = static_cast<float>(kMistLife) * random(0.4, 1);
        particles_.push_back(drop);
    }
}

void SprayParticleSystem::emitChips(const SprayInput& now, double dt) {
    for (std::size_t m = 0; m < kMaxMaterials; ++m) {
        // Less than before: after an undo, or for another tooth.
        if (started_ && now.ground[m] > ground_[m]) chipsDue_[m] += now.ground[m] - ground_[m];
        for (; chipsDue_[m] >= kChipVolume; chipsDue_[m] -= kChipVolume) {
            SprayParticle chip = thrown(now, dt);
            chip.kind = SprayParticleKind::Chip;
            chip.material = static_cast<MaterialId>(m);
            chip.wetness = static_cast<float>(now.water);
            chip.radius = radiusOfChip();
            chip.lifetime = static_cast<float>(kChipLife) * random(0.4, 1);
            particles_.push_back(chip);
        }
    }
    ground_ = now.ground;
    started_ = true;
}

}  // namespace tactooth
