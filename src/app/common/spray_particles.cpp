// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/spray_particles.h"

#include <algorithm>

namespace tactooth {
namespace {

const Vec3f kWater(0.90F, 0.93F, 0.96F);  // sRGB: lit drops in front of a darker mouth
constexpr float kMistWidth = 2.2F;        // a drop of mist stands for a little cloud
constexpr float kPowder = 0.6F;           // share of white in the colour of a chip: fine grains scatter light
constexpr float kPaling = 0.45F;          // share of the water in the colour of a wet chip

/// The path of a particle while a picture is taken, as far as it is drawn.
Vec3f streakOf(const SprayParticle& source, float longest) {
    constexpr float kExposure = 1.0F / 60;  // s
    const Vec3f path = kExposure * source.velocity;
    return path * std::min(1.0F, longest / std::max(path.norm(), 1e-6F));
}

constexpr float kLongestJet = 2.5F, kLongestMist = 1.6F, kLongestChip = 0.5F;  // mm

Particle particleOf(const SprayParticle& source, const MaterialTable& materials) {
    const float left = source.lifetime > 0 ? 1 - source.age / source.lifetime : 1;
    Particle particle{source.place, source.radius, kWater, 1};
    switch (source.kind) {
        case SprayParticleKind::Jet:
            particle.opacity = 0.45F;
            particle.streak = streakOf(source, kLongestJet);
            break;
        case SprayParticleKind::Mist:  // the same amount of water over a growing disc
            particle.radius *= kMistWidth;
            particle.opacity = 0.16F * left * std::min(1.0F, 0.25F / source.radius);
            particle.streak = streakOf(source, kLongestMist);
            break;
        case SprayParticleKind::Chip: {
            const std::array<float, 3>& colour = materials[source.material].colour;
            particle.colour = (1 - kPowder) * Vec3f(colour[0], colour[1], colour[2]) + kPowder * Vec3f::Ones();
            particle.colour += kPaling * source.wetness * (kWater - particle.colour);
            particle.opacity = std::min(1.0F, 2 * left);
            particle.streak = streakOf(source, kLongestChip);
            break;
        }
    }
    return particle;
}

}  // namespace

std::vector<Particle> particlesOf(std::span<const SprayParticle> sources, const MaterialTable& materials) {
    std::vector<Particle> particles;
    particles.reserve(sources.size());
    for (const SprayParticle& source : sources) particles.push_back(particleOf(source, materials));
    return particles;
}

}  // namespace tactooth
