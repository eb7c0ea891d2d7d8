// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
uniform sampler2D ghostColour;  // premultiplied by its opacity
uniform sampler2D ghostDepth;

layout(location = 0) out vec4 fragment;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    fragment = texelFetch(ghostColour, pixel, 0);
    if (fragment.a == 0.0) discard;
    gl_FragDepth = texelFetch(ghostDepth, pixel, 0).r;
}
