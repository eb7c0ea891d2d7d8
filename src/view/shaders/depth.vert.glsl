// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec3 position;

uniform mat4 objectToShadow;

void main() { gl_Position = objectToShadow * vec4(position, 1.0); }
