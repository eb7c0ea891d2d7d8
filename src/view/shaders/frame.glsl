// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The data that all shaders of one pass share. Directions and positions are in the world frame, colours are linear.
layout(std140) uniform Frame {
    mat4 worldToClip;
    mat4 clipToWorld;
    mat4 worldToShadow;  // to texture coordinates and depth of the shadow map
    vec4 eye;
    vec4 clipPlane;      // points on its negative side are not drawn (mirror pass)
    vec4 section;        // the same for sectioned objects
    vec4 toKey;
    vec4 keyColour;
    vec4 toFill;
    vec4 fillColour;
    vec4 skyColour;
    vec4 groundColour;
    vec4 backgroundTop;     // sRGB
    vec4 backgroundBottom;  // sRGB; a: 0 gradient, 1 environment, 2 transparent
    vec4 pictureSize;       // pixels: width, height, 1 / width, 1 / height
    vec4 shadowTexel;       // x: size of a shadow map texel in texture coordinates; y: mm per texel;
                        // z: mm by which a surface may deviate, for each mm of distance from the eye;
                        // w: mm by which a shadow caster may deviate
    vec4 sightEnds;         // pixels: the first and the last point of the line that must be seen
    vec4 sightReach;        // x: its distance from the eye, mm; y, z: pixels around it, and beyond its end, that must be
                            // seen; w: pixels per mm there; 0: nothing must be seen
};
