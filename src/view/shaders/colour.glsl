// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Linear light to what a screen shows.

// Colours below the knee stay as they are (a shade guide must look like itself); above it they approach white smoothly,
// keeping their hue and losing saturation only near the end.
vec3 compress(vec3 light) {
    const float knee = 0.70;
    float peak = max(light.r, max(light.g, light.b));
    if (peak <= knee) return light;
    float compressed = knee + (1.0 - knee) * (1.0 - exp((knee - peak) / (1.0 - knee)));
    float whitening = 1.0 - 1.0 / (1.0 + 0.12 * (peak - knee));
    return mix(light * (compressed / peak), vec3(compressed), whitening);
}

vec3 toSrgb(vec3 linear) {
    vec3 low = linear * 12.92;
    vec3 high = 1.055 * pow(max(linear, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, lessThanEqual(linear, vec3(0.0031308)));
}

// Half a step of noise hides the 8-bit steps of soft gradients. Same pixel, same noise.
float dither() { return (fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0; }
