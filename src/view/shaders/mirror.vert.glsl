// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
uniform vec4 centre;  // world, mm
uniform vec4 right;   // world, in the plane of the disc, as long as its radius
uniform vec4 up;
uniform int sectors;

out vec2 place;  // position on the disc: the rim is at length 1

// A fan as separate triangles: vertex 3 k is the centre, 3 k + 1 and 3 k + 2 are adjacent on the rim.
void main() {
    int step = gl_VertexID % 3;
    float angle = 6.2831853 * float(gl_VertexID / 3 + max(step - 1, 0)) / float(sectors);
    place = step == 0 ? vec2(0.0) : vec2(cos(angle), sin(angle));
    gl_Position = worldToClip * vec4(centre.xyz + place.x * right.xyz + place.y * up.xyz, 1.0);
}
