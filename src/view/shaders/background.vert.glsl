// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Draws the background as a grid of cells, two triangles each. The colours are computed only at the grid corners.
out vec4 gridColour;
out float gl_ClipDistance[2];

const ivec2 kCells = ivec2(40, 25);

void main() {
    gl_ClipDistance[0] = gl_ClipDistance[1] = 1.0;  // the background has no position in the scene
    int cell = gl_VertexID / 6;
    int corner = gl_VertexID % 6;
    ivec2 offset = ivec2(corner == 1 || corner == 2 || corner == 4 ? 1 : 0, corner == 2 || corner >= 4 ? 1 : 0);
    vec2 place = vec2(ivec2(cell % kCells.x, cell / kCells.x) + offset) / vec2(kCells);
    gl_Position = vec4(2.0 * place - 1.0, 1.0, 1.0);
    if (backgroundBottom.a > 1.5) {
        gridColour = vec4(0.0);
    } else if (backgroundBottom.a > 0.5) {
        vec4 far = clipToWorld * vec4(2.0 * place - 1.0, 1.0, 1.0);
        vec3 direction = normalize(far.xyz / far.w - eye.xyz);
        gridColour = vec4(toSrgb(compress(0.6 * (environment(direction, 0.5) + bib(direction, 0.5)))), 1.0);
    } else {
        // Brightest a little below the centre, where the object is; darker toward the corners.
        vec2 fromMiddle = (place - vec2(0.5, 0.42)) * vec2(min(pictureSize.x * pictureSize.w, 1.6), 1.0);
        float dark = smoothstep(0.05, 1.05, length(fromMiddle));
        vec3 colour = mix(mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, 1.0, place.y)),
                          backgroundTop.rgb * 0.62, 0.75 * dark);
        gridColour = vec4(colour, 1.0);
    }
}
