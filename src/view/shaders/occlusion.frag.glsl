// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Ambient visibility: the share of the surroundings that each point sees past its neighbours. It uses only the depth
// buffer: rays to points scattered over a ball, weighted as by M. McGuire et al., Scalable ambient obscurance, HPG 2012
// (its falloff; own sampling).
uniform sampler2D depthPicture;
uniform mat4 clipToView;
uniform float pixelsPerRadian;  // picture height / (2 tan(field of view / 2))
uniform float reach;            // mm
uniform vec4 region;            // first and last drawn pixel

layout(location = 0) out float ambientVisibility;

const int kTaps = 14;

vec3 viewPoint(ivec2 pixel) {
    pixel = clamp(pixel, ivec2(region.xy), ivec2(region.zw));
    float depth = texelFetch(depthPicture, pixel, 0).r;
    vec2 place = (vec2(pixel) + 0.5) / vec2(textureSize(depthPicture, 0));
    vec4 view = clipToView * vec4(2.0 * vec3(place, depth) - 1.0, 1.0);
    return view.xyz / view.w;
}

// The nearer neighbour on each side gives the better estimate of the surface's slope: the other may be behind an edge.
// At the border of the region there is only one neighbour; the other is the point itself.
vec3 slope(vec3 here, vec3 before, vec3 after) {
    vec3 a = here - before;
    vec3 b = after - here;
    if (a == vec3(0.0)) return b;
    return abs(a.z) < abs(b.z) || b == vec3(0.0) ? a : b;
}

void main() {
    ivec2 pixel = 2 * ivec2(gl_FragCoord.xy);
    if (texelFetch(depthPicture, clamp(pixel, ivec2(region.xy), ivec2(region.zw)), 0).r >= 1.0) {
        ambientVisibility = 1.0;
        return;
    }
    vec3 here = viewPoint(pixel);
    vec3 normal = normalize(cross(slope(here, viewPoint(pixel - ivec2(1, 0)), viewPoint(pixel + ivec2(1, 0))),
                                  slope(here, viewPoint(pixel - ivec2(0, 1)), viewPoint(pixel + ivec2(0, 1)))));
    float disc = clamp(reach * pixelsPerRadian / -here.z, 3.0, 220.0);
    float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    float hidden = 0.0;
    for (int i = 0; i < kTaps; ++i) {
        float share = (float(i) + 0.5) / float(kTaps);
        float angle = turn + 2.3999632 * float(i);
        vec3 ray = viewPoint(pixel + ivec2(disc * share * vec2(cos(angle), sin(angle)))) - here;
        float distance2 = dot(ray, ray);
        float rise = dot(ray, normal) - 0.004 * -here.z * 0.1;
        float falloff = max(1.0 - distance2 / (reach * reach), 0.0);
        hidden += max(rise, 0.0) * inversesqrt(distance2 + 1e-4) * falloff;
    }
    ambientVisibility = clamp(1.0 - 2.1 * hidden / float(kTaps), 0.0, 1.0);
}
