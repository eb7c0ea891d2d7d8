// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Upsamples the half-size ambient visibility to the picture, over pixels of the same depth only, and darkens with it.
uniform sampler2D depthPicture;
uniform sampler2D ambientVisibilityMap;
uniform vec4 depthRange;  // near, far
uniform vec4 region;      // first and last drawn pixel

layout(location = 0) out vec4 factor;

float distanceAt(ivec2 pixel) {
    float depth = 2.0 * texelFetch(depthPicture, clamp(pixel, ivec2(region.xy), ivec2(region.zw)), 0).r - 1.0;
    return 2.0 * depthRange.x * depthRange.y / (depthRange.y + depthRange.x - depth * (depthRange.y - depthRange.x));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (texelFetch(depthPicture, pixel, 0).r >= 1.0) discard;
    float here = distanceAt(pixel);
    ivec2 corner = (pixel - 3) / 2;
    float sum = 0.0;
    float weights = 1e-4;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            ivec2 half_ = clamp(corner + ivec2(x, y), ivec2(region.xy) / 2, ivec2(region.zw) / 2);
            float weight = 1.0 / (0.02 + abs(distanceAt(2 * half_) - here) / (0.01 * here));
            sum += weight * texelFetch(ambientVisibilityMap, half_, 0).r;
            weights += weight;
        }
    }
    // Light that is thrown to and fro between bright walls brightens what is hidden from the room, so that grooves are
    // only a little darker than the surface around them, and of its hue.
    const float kLost = 0.42;
    float open = sum / weights;
    factor = vec4(vec3(1.0 - kLost * (1.0 - open)), 1.0);
}
