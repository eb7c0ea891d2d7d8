// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Combines the pictures of two eyes. Side by side: each on its half. Anaglyph for red-cyan glasses with the
// least-squares matrices of E. Dubois, A projection method to generate anaglyph stereo images, ICASSP 2001.
uniform sampler2D leftPicture;
uniform sampler2D rightPicture;
uniform int anaglyph;
uniform vec4 targetSize;  // pixels: width, height

layout(location = 0) out vec4 fragment;

const mat3 kLeft = transpose(mat3(0.437, 0.449, 0.164, -0.062, -0.062, -0.024, -0.048, -0.050, -0.017));
const mat3 kRight = transpose(mat3(-0.011, -0.032, -0.007, 0.377, 0.761, 0.009, -0.026, -0.093, 1.234));

void main() {
    vec2 place = gl_FragCoord.xy / targetSize.xy;
    if (anaglyph == 1) {
        vec4 left = texture(leftPicture, place);
        vec4 right = texture(rightPicture, place);
        fragment = vec4(clamp(kLeft * left.rgb + kRight * right.rgb, 0.0, 1.0), max(left.a, right.a));
    } else if (place.x < 0.5) {
        fragment = texture(leftPicture, vec2(2.0 * place.x, place.y));
    } else {
        fragment = texture(rightPicture, vec2(2.0 * place.x - 1.0, place.y));
    }
}
