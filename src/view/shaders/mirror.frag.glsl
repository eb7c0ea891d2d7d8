// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
in vec2 place;

uniform sampler2D reflection;  // the reflected picture, in the same pixel positions
uniform float reflectance;     // as a factor on display values
uniform float fog;             // 0..1
uniform float drops;           // 0..1
uniform vec4 covered;          // first and last drawn pixel of the reflection

layout(location = 0) out vec4 fragment;

const float kCells = 8.0;  // drops per radius of the disc: each is a little more than a millimetre
const int kTaps = 12;

// Two random numbers from 0 to 1: pcg2d (M. Jarzynski, M. Olano, "Hash functions for GPU rendering", Journal of Computer
// Graphics Techniques 9(3), 2020). Whole numbers are the same with every driver, a sine is not.
vec2 hash(vec2 cell) {
    const uint kFactor = 1664525u;
    uvec2 v = uvec2(ivec2(cell)) * kFactor + 1013904223u;
    v.x += v.y * kFactor;
    v.y += v.x * kFactor;
    v ^= v >> 16u;
    v.x += v.y * kFactor;
    v.y += v.x * kFactor;
    v ^= v >> 16u;
    return vec2(v >> 8u) / 16777216.0;
}

vec3 seen(vec2 pixel) { return texelFetch(reflection, ivec2(clamp(pixel, covered.xy, covered.zw)), 0).rgb; }

// The picture on fogged glass: scattered over a disc, under the grey of the fog itself.
vec3 fogged(vec2 pixel) {
    if (fog <= 0.0) return seen(pixel);
    float reach = fog * 0.035 * (covered.w - covered.y);
    float turn = 6.2831853 * fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < kTaps; ++i) {
        float angle = turn + 2.3999632 * float(i);
        sum += seen(pixel + reach * sqrt((float(i) + 0.5) / float(kTaps)) * vec2(cos(angle), sin(angle)));
    }
    return mix(sum / float(kTaps), vec3(0.70, 0.72, 0.74), 0.65 * fog);
}

void main() {
    vec2 pixel = gl_FragCoord.xy;
    vec2 cell = floor(place * kCells);
    vec2 random = hash(cell);
    vec2 fromMiddle = place * kCells - cell - mix(vec2(0.38), vec2(0.62), random);
    float radius = mix(0.14, 0.36, fract(7.0 * random.x + random.y));
    float height = 1.0 - dot(fromMiddle, fromMiddle) / (radius * radius);
    vec3 colour;
    if (drops > fract(random.x + 3.0 * random.y) && height > 0.0) {
        // A drop is a strong lens: it shows its surroundings small and upside down, with a bright spot.
        vec2 toPixels = (covered.zw - covered.xy) / (2.0 * kCells);
        colour = seen(pixel - 3.0 * fromMiddle * toPixels) * mix(0.75, 1.05, height);
        vec2 spot = fromMiddle / radius - vec2(-0.35, 0.4);
        colour += 0.7 * smoothstep(0.08, 0.0, dot(spot, spot));
    } else {
        colour = fogged(pixel);
    }
    fragment = vec4(colour * reflectance, 1.0);
}
