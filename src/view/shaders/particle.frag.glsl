// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
in vec4 colour;

layout(location = 0) out vec4 fragment;

void main() {
    vec2 place = 2.0 * gl_PointCoord - 1.0;
    float inside = 1.0 - dot(place, place);
    if (inside <= 0.0) discard;
    float lit = 0.92 + 0.2 * dot(place, vec2(-0.4, -0.6));  // the operating light is at the upper left
    fragment = vec4(colour.rgb * lit, colour.a * inside);
}
