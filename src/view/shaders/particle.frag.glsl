// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
in vec4 colour;
flat in vec3 shape;

layout(location = 0) out vec4 fragment;

// Fades toward its rim without an edge: many of them together are mist.
void main() {
    vec2 half_ = shape.xy;
    vec2 place = (gl_PointCoord - 0.5) * 2.0 * (shape.z + length(half_));
    float along = clamp(dot(place, half_) / max(dot(half_, half_), 1e-4), -1.0, 1.0);
    vec2 aside = (place - along * half_) / shape.z;
    float inside = 1.0 - dot(aside, aside);
    if (inside <= 0.0) discard;
    float lit = 0.94 + 0.12 * dot(aside, vec2(-0.4, -0.6));  // the operating light is at the upper left
    fragment = vec4(colour.rgb * lit, colour.a * inside * inside * (0.8 + 0.2 * along));
}
