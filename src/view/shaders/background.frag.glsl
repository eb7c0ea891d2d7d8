// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
in vec4 gridColour;

layout(location = 0) out vec4 fragment;

void main() { fragment = gridColour + vec4(vec3(dither() * gridColour.a), 0.0); }
