// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
in vec2 place;

uniform sampler2D reflection;  // the reflected picture, pixel by pixel in place
uniform float reflectance;     // already as a factor on display values

layout(location = 0) out vec4 fragment;

void main() { fragment = vec4(texelFetch(reflection, ivec2(gl_FragCoord.xy), 0).rgb * reflectance, 1.0); }
