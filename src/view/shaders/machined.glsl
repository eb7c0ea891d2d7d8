// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The surface of a handpiece: brushed around its handle, a knurled grip, and in the face of its head the three spray
// holes and the window of the fibre light. Its mesh is in the tool frame: the bur along z, the handle along +x.
uniform sampler3D noiseTexture;
uniform mat4 objectToWorld;

const float kGripFrom = 35.0;   // mm along the handle
const float kGripTo = 51.0;
const float kPitch = 0.9;       // mm between the ridges of the knurl
const float kFaceTop = 10.3;    // mm along the bur: the face of the head ends
const float kHoleCircle = 2.9;  // mm: where the jets begin (SprayParticleSystem)
const float kHole = 0.30;       // mm, radius
const float kWindow = 0.42;

// Returns the normal for the light. `place`: object frame, mm. `lamp`: how bright the surface itself shines.
vec3 machined(vec3 place, vec3 smoothNormal, inout vec3 colour, inout float roughness, inout float metalness,
              inout float lamp) {
    float pixel = fwidth(place.x) + fwidth(place.y) + fwidth(place.z);  // mm, about
    vec3 along = normalize(mat3(objectToWorld)[0]);
    vec3 across = cross(along, smoothNormal);
    // Fine rings that the brush has left: highlights are drawn out across them.
    float stroke = texture(noiseTexture, vec3(0.62 * place.x, 0.035 * place.y, 0.035 * place.z)).x - 0.5;
    float clear = 1.0 / (1.0 + 25.0 * pixel * pixel);
    vec3 normal = smoothNormal + 0.32 * clear * stroke * along;
    colour *= 1.0 + 0.25 * clear * stroke;

    float grip = smoothstep(kGripFrom, kGripFrom + 0.3, place.x) * smoothstep(kGripTo, kGripTo - 0.3, place.x);
    if (grip > 0.0) {
        float middle = 26.2 + 0.09 * (place.x - 34.0);  // of the handle, along z
        vec2 aside = vec2(place.y, place.z - middle);
        float around = atan(aside.x, aside.y) * 5.2;  // mm
        vec2 ridge = 6.2831853 * vec2(place.x + around, place.x - around) / (2.0 * kPitch);
        float seen = grip * smoothstep(0.5 * kPitch, 0.15 * kPitch, pixel);
        vec2 slope = sin(ridge);
        normal += 0.42 * seen * ((slope.x + slope.y) * along + (slope.x - slope.y) * across);
        colour *= 1.0 - 0.30 * seen * smoothstep(0.1, 0.9, -min(cos(ridge.x), cos(ridge.y)));
    }
    if (place.z < kFaceTop && length(place.xy) < 3.6) {
        float angle = atan(place.y, place.x);
        const float kThird = 2.0943951;
        float toHole = abs(mod(angle - 0.25 * kThird + 0.5 * kThird, kThird) - 0.5 * kThird);
        float radius = length(place.xy);
        float fromHole = length(vec2(radius * cos(toHole) - kHoleCircle, radius * sin(toHole)));
        float hole = smoothstep(kHole + 0.06, kHole - 0.06, fromHole);
        float fromWindow = length(place.xy - vec2(0.0, kHoleCircle));
        float window = smoothstep(kWindow + 0.05, kWindow - 0.05, fromWindow);
        colour *= 1.0 - 0.97 * hole;
        metalness *= 1.0 - max(0.8 * hole, window);
        roughness = mix(roughness, 0.9, hole);
        lamp = 1.1 * window;
    }
    return normalize(normal);
}
