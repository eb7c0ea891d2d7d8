// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
uniform sampler2D firstPicture;
uniform sampler2D lastPicture;
uniform float share;  // of the last one, 0..1

layout(location = 0) out vec4 fragment;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    fragment = mix(texelFetch(firstPicture, pixel, 0), texelFetch(lastPicture, pixel, 0), share);
}
