// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
layout(location = 0) out vec4 fragment;

void main() {
    vec2 place = gl_FragCoord.xy * pictureSize.zw;
    if (backgroundBottom.a > 1.5) {
        fragment = vec4(0.0);
    } else if (backgroundBottom.a > 0.5) {
        vec4 far = clipToWorld * vec4(2.0 * place - 1.0, 1.0, 1.0);
        vec3 direction = normalize(far.xyz / far.w - eye.xyz);
        fragment = vec4(toSrgb(compress(environment(direction, 0.25))) + dither(), 1.0);
    } else {
        // Brightest a little below the middle, where the object stands; darker into the corners.
        vec2 fromMiddle = (place - vec2(0.5, 0.42)) * vec2(min(pictureSize.x * pictureSize.w, 1.6), 1.0);
        float dark = smoothstep(0.05, 1.05, length(fromMiddle));
        vec3 colour = mix(mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, 1.0, place.y)),
                          backgroundTop.rgb * 0.62, 0.75 * dark);
        fragment = vec4(colour + dither(), 1.0);
    }
}
