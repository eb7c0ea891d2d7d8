// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <span>
#include <vector>

#include "tooth/volume/cut_volume.h"

namespace tactooth {

/// The kinds of particles around a working bur.
enum class SprayParticleKind : std::uint8_t {
    Jet,   ///< water on its way from the handpiece to the bur
    Mist,  ///< water thrown off by the bur
    Chip   ///< ground material: a parcel of grains, drawn as one ball of their volume
};

/// One particle. Tooth frame, mm, s.
struct SprayParticle {
    Vec3f place = Vec3f::Zero();
    Vec3f velocity = Vec3f::Zero();
    float radius = 0;      ///< of the ball that is drawn
    float relaxation = 0;  ///< time in which air brakes it to 1/e
    float age = 0;
    float lifetime = 0;
    SprayParticleKind kind = SprayParticleKind::Mist;
    MaterialId material{};  ///< of a chip
    float wetness = 0;      ///< of a chip: how much water flowed when it was cut, 0..1
};

/// The state of the bur at one moment.
struct SprayInput {
    Pose toolInTooth;
    Vec3 normal = Vec3::Zero();  ///< out of the tooth where the bur touches it, unit; zero without contact
    double speedRpm = 0;
    double water = 0;          ///< flow of the cooling spray, 0..1
    bool suction = false;      ///< whether the suction tube draws
    MaterialVolumes ground{};  ///< ground off the tooth so far, mm^3
};

/// Water and chips around a bur, for pictures. Chips have the volume that the bur has ground off. Mist and chips leave
/// the bur's rim with its speed, and air brakes them as drops and grains of 8 to 24 um. Equal calls give equal bits.
class SprayParticleSystem {
public:
    /// `burRadius`: of its widest part, mm. `tube`: the middle of the suction tube's opening, tooth frame.
    explicit SprayParticleSystem(double burRadius = 0.5, const Vec3& tube = Vec3::Zero());

    /// Advances by `dt` seconds.
    void advance(const SprayInput& now, double dt);
    [[nodiscard]] std::span<const SprayParticle> particles() const { return particles_; }

    /// Volume of the grains that one chip stands for, mm^3: a ball a tenth of a millimetre wide.
    static constexpr double kChipVolume = 5e-4;
    /// The most particles, for the cost of a picture; the oldest go first.
    static constexpr std::size_t kMaxParticles = 1500;

private:
    void fly(const SprayInput& now, float dt);
    void emitJets(const SprayInput& now);
    void emitMist(const SprayInput& now, double dt);
    void emitChips(const SprayInput& now, double dt);
    [[nodiscard]] SprayParticle thrown(const SprayInput& now, double dt);
    [[nodiscard]] float random(double low, double high);

    double burRadius_;
    Vec3f tube_;
    std::vector<SprayParticle> particles_;
    std::mt19937 random_;
    double mistDue_ = 0;          // share of the next drop
    MaterialVolumes chipsDue_{};  // ground off and not thrown yet, mm^3
    MaterialVolumes ground_{};    // at the last call
    bool started_ = false;
};

}  // namespace tactooth
