// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The section cap: a square on the section plane, shaded as a surface with one appearance.
uniform vec4 centre;  // world, mm
uniform vec4 right;   // world, in the plane, half as long as the square's side
uniform vec4 up;
uniform vec4 appearances[2];

out vec3 worldPosition;
out vec3 worldNormal;
out vec3 noisePlace;
out vec4 surfaceAppearance;
out vec4 materialAppearance;
out float gl_ClipDistance[2];

void main() {
    vec2 corner = 2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0;
    worldPosition = centre.xyz + corner.x * right.xyz + corner.y * up.xyz;
    worldNormal = -section.xyz;
    noisePlace = noisePlaceOf(worldPosition);
    surfaceAppearance = appearances[0];
    materialAppearance = appearances[1];
    gl_Position = worldToClip * vec4(worldPosition, 1.0);
    gl_ClipDistance[0] = dot(clipPlane, vec4(worldPosition, 1.0));
    gl_ClipDistance[1] = 1.0;
}
