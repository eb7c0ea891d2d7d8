// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Is the material audible? A simple classifier has to distinguish enamel, dentin and caries from 100 ms: the power in
// third-octave bands from 500 Hz to 16 kHz, in dB without their mean (so that loudness says nothing), and the nearest
// of three means in the metric of the common covariance. R. A. Fisher, "The use of multiple measurements in taxonomic
// problems", Ann. Eugen. 7 (1936) 179. It learns from one set of random loads and is tested on another, with other
// noise.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <random>

#include "sound/files/sound_format.h"
#include "sound/material_sounds.h"
#include "spectrum.h"

namespace tactooth {
namespace {

using namespace test;

constexpr int kBands = 16;
constexpr std::array<const char*, 3> kMaterials{"enamel", "dentin", "caries"};
using Features = Eigen::Matrix<double, kBands, 1>;

struct Example {
    std::size_t material;
    Features features;
};

Features featuresOf(std::span<const float> sound) {
    const Spectrum spectrum = averageSpectrum(sound, 1024);
    Features bands;
    for (int i = 0; i < kBands; ++i) {
        const double low = 500.0 * std::exp2(i / 3.0);
        bands[i] = decibel(spectrum.bandPower(low, low * std::exp2(1.0 / 3.0)) + 1e-12);
    }
    return bands.array() - bands.mean();
}

// 100 ms of a cut at a random power, speed and load; with everything of a session, including the turbine at full
// volume.
std::vector<Example> examples(unsigned seed, int each) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    std::vector<Example> result;
    for (int i = 0; i < each; ++i) {
        for (std::size_t material = 0; material < kMaterials.size(); ++material) {
            const double watt = 0.3 * std::pow(50.0, between(0.0, 1.0));  // 0.3 .. 15 W, evenly over the octaves
            DrillSoundState state = cutting(kMaterials[material], watt, between(150000.0, 400000.0));
            state.load = between(0.0, 1.0);
            DrillSynthesiser synthesiser(random());
            (void)renderDrill(synthesiser, 0.1, [&](double) { return state; });
            result.push_back({material, featuresOf(renderDrill(synthesiser, 0.1, [&](double) { return state; }))});
        }
    }
    return result;
}

class Classifier {
public:
    explicit Classifier(const std::vector<Example>& trainingSet) {
        means_.fill(Features::Zero());
        const double each = static_cast<double>(trainingSet.size()) / kMaterials.size();
        for (const Example& trainingSample : trainingSet)
            means_[trainingSample.material] += trainingSample.features / each;
        Eigen::Matrix<double, kBands, kBands> covariance = Eigen::Matrix<double, kBands, kBands>::Identity();  // 1 dB^2
        for (const Example& trainingSample : trainingSet) {
            const Features off = trainingSample.features - means_[trainingSample.material];
            covariance += off * off.transpose() / static_cast<double>(trainingSet.size());
        }
        precision_ = covariance.inverse();
    }

    [[nodiscard]] std::size_t materialOf(const Features& features) const {
        std::size_t best = 0;
        for (std::size_t i = 1; i < means_.size(); ++i)
            if (distance(features, i) < distance(features, best)) best = i;
        return best;
    }

private:
    [[nodiscard]] double distance(const Features& features, std::size_t material) const {
        const Features off = features - means_[material];
        return off.dot(precision_ * off);
    }

    std::array<Features, kMaterials.size()> means_;
    Eigen::Matrix<double, kBands, kBands> precision_;
};

TEST(MaterialClassifier, FindsTheMaterialInATenthOfASecondUnderLoadsItHasNeverHeard) {
    const Classifier classifier(examples(20261, 120));
    const std::vector<Example> exam = examples(90417, 200);
    int right = 0;
    for (const Example& question : exam) right += classifier.materialOf(question.features) == question.material;
    RecordProperty("percent", 100 * right / static_cast<int>(exam.size()));
    EXPECT_GE(right, 0.95 * static_cast<double>(exam.size()));
}

TEST(MaterialClassifier, WithoutTheCutItCanOnlyGuess) {
    // The turbine over a material that is not cut must not reveal the material.
    const Classifier classifier(examples(20261, 60));
    std::vector<Example> exam;
    std::mt19937 random(5);
    for (int i = 0; i < 60; ++i) {
        DrillSoundState state = spinning(150000.0 + 4000.0 * i);
        const std::size_t material = random() % kMaterials.size();
        state.material = characterOf(kMaterials[material]);
        exam.push_back({material, featuresOf(steadySound(state, 0.1))});
    }
    int right = 0;
    for (const Example& question : exam) right += classifier.materialOf(question.features) == question.material;
    EXPECT_LT(right, 40);
}

}  // namespace
}  // namespace tactooth
