// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
in vec3 worldPosition;
in vec3 worldNormal;
#if RICH
in vec3 objectPosition;
#endif
in vec3 noisePlace;  // in the noise texture; of a machined surface: object frame, mm
in vec4 surfaceAppearance;
in vec4 materialAppearance;

#if RICH
in float appearanceOpacity;
uniform sampler2D shellDepth;      // of the body around an inner object
uniform int inner;                 // 1: only points behind the shell are visible
uniform sampler3D distanceField;   // object frame, mm
uniform mat4 objectToField;        // to texture coordinates
uniform sampler2D distanceColours; // linear, from -range to range
uniform float distanceRange;       // mm; 0: the colours of the appearances
uniform float distanceTolerance;   // mm: up to it the colour of 0
uniform float toleranceStep;       // place of the colour just beyond it, 0..1
uniform int glassPhase;            // 0: the body is no glass, 1: without its glass part, 2: only that part
uniform float glassAbove;          // object frame, mm: the height where it begins
#endif
uniform sampler2DShadow shadowMap;
#if BLOCKER_TAPS > 0
uniform sampler2D shadowDepth;  // the shadow map again: the depth itself, of the nearest texel
#endif

layout(location = 0) out vec4 fragment;

const float kPi = 3.14159265;
const float kBounced = 0.6;  // share of the light from around that tissue of the same colour has reflected

// A row of the linear part of worldToShadow.
vec3 shadowRow(int i) { return vec3(worldToShadow[0][i], worldToShadow[1][i], worldToShadow[2][i]); }

#if SHADOW_TAPS > 1
// Sample `i` of `taps` on a spiral over the disc of the radius `reach`: each stands for the same area. `turn`, rad,
// rotates the spiral. The angle between two samples is the golden angle.
vec2 onSpiral(int i, int taps, float reach, float turn) {
    float radius = reach * sqrt((float(i) + 0.5) / float(taps));
    float angle = turn + 2.3999632 * float(i);
    return radius * vec2(cos(angle), sin(angle));
}
#endif

#if BLOCKER_TAPS > 0
const float kSpread = 0.07;     // mm of radius for each mm of distance: half the width of a lamp, 50 mm, 700 mm away
const float kNarrowest = 0.04;  // mm: a texel and a half on a whole molar, so that an edge is as soft in close views
const float kWidest = 0.7;      // mm, from 10 mm away: in a wider penumbra the few samples would show as noise

// The radius of the penumbra at the place `spot`, mm; 0 where nothing throws a shadow. It grows with the mean distance
// of the blockers: of what is nearer to the light than the plane of the surface. R. Fernando, Percentage-closer soft
// shadows, SIGGRAPH 2005 sketches; here in a parallel projection, where one scale turns depth into mm.
float penumbraRadius(vec3 spot, vec2 slope2, float turn) {
    float reach = max(kWidest / shadowTexel.y, 1.5) * shadowTexel.x;
    float sum = 0.0;
    float blockers = 0.0;
    for (int i = 0; i < BLOCKER_TAPS; ++i) {
        // The first sample is the place itself, so that the search does not miss a thin bar right above it.
        vec2 aside = i == 0 ? vec2(0.0) : onSpiral(i, BLOCKER_TAPS, reach, turn);
        // `spot` is offset from the surface, or the surface would block itself.
        float away = spot.z + dot(slope2, aside) - textureLod(shadowDepth, spot.xy + aside, 0.0).r;
        if (away <= 0.0) continue;
        sum += away;
        blockers += 1.0;
    }
    if (blockers == 0.0) return 0.0;
    float apart = sum / blockers / length(shadowRow(2));  // mm: the row is the depth for each mm
    return clamp(kSpread * apart, kNarrowest, kWidest);
}
#endif

// The share of the operating light that reaches the point.
float keyVisibility(vec3 normal) {
#if SHADOW_TAPS == 0
    return 1.0;
#else
    // Offset the lookup from the surface by one and a half texels and more, or facets would shade themselves. Add three times
    // the usual error for a surface that is coarser here than in the shadow map, or there than here.
    float slope = 1.0 - clamp(dot(normal, toKey.xyz), 0.0, 1.0);
    float coarse = 3.0 * max(shadowTexel.z * distance(eye.xyz, worldPosition), shadowTexel.w);
    vec3 place = worldPosition + normal * (shadowTexel.y * (1.5 + 2.5 * slope) + coarse);
    vec3 spot = (worldToShadow * vec4(place, 1.0)).xyz;
    if (any(lessThan(spot, vec3(0.0))) || any(greaterThan(spot, vec3(1.0)))) return 1.0;
#if SHADOW_TAPS == 1
    // The sixteen texels around the place, weighted by how much of a square of three texels around it they cover: the
    // steps of the map do not show. The offset from the surface is enough for all of them.
    vec2 texelPlace = spot.xy / shadowTexel.x - 0.5;
    vec2 corner = floor(texelPlace);
    vec2 after = texelPlace - corner;
    vec2 before = 1.0 - after;
    vec4 low = textureGather(shadowMap, corner * shadowTexel.x, spot.z);
    vec4 right = textureGather(shadowMap, (corner + vec2(2.0, 0.0)) * shadowTexel.x, spot.z);
    vec4 above = textureGather(shadowMap, (corner + vec2(0.0, 2.0)) * shadowTexel.x, spot.z);
    vec4 high = textureGather(shadowMap, (corner + 2.0) * shadowTexel.x, spot.z);
    vec2 lower = before.x * low.wx + low.zy + right.wx + after.x * right.zy;
    vec2 upper = before.x * above.wx + above.zy + high.wx + after.x * high.zy;
    return (before.y * lower.x + lower.y + upper.x + after.y * upper.y) / 9.0;
#else
    // Samples on a spiral over the penumbra of the operating light, rotated from pixel to pixel. Each sample compares
    // with the plane of the surface at its own place, or slopes would shade themselves.
    vec3 scale2 = vec3(dot(shadowRow(0), shadowRow(0)), dot(shadowRow(1), shadowRow(1)), dot(shadowRow(2), shadowRow(2)));
    vec3 plane = mat3(worldToShadow) * normal / scale2;
    vec2 slope2 = -plane.xy / min(plane.z, -0.15 * length(plane));
    float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
#if BLOCKER_TAPS > 0
    float radius = penumbraRadius(spot, slope2, turn);
    if (radius == 0.0) return 1.0;
#else
    const float radius = 0.2;  // mm: about that of an operating light on a tooth
#endif
    float penumbra = max(radius / shadowTexel.y, 1.5) * shadowTexel.x;
    float sum = 0.0;
    for (int i = 0; i < SHADOW_TAPS; ++i) {
        vec2 aside = onSpiral(i, SHADOW_TAPS, penumbra, turn);
        sum += texture(shadowMap, vec3(spot.xy + aside, spot.z + dot(slope2, aside)));
    }
    return sum / float(SHADOW_TAPS);
#endif
#endif
}

// GGX microfacet lobe with Smith masking, divided by 4 (n.l)(n.v). B. Walter et al., Microfacet models for refraction
// through rough surfaces, EGSR 2007; masking in the approximation of E. Hammon, GDC 2017.
float microfacets(float nh, float nl, float nv, float roughness) {
    float a = roughness * roughness;
    float a2 = a * a;
    float d = nh * nh * (a2 - 1.0) + 1.0;
    return a2 / (kPi * d * d) * 0.5 / max(mix(2.0 * nl * nv, nl + nv, a), 1e-4);
}

float grazing(float cosine) {
    float x = clamp(1.0 - cosine, 0.0, 1.0);
    float x2 = x * x;
    return x2 * x2 * x;
}

// The share of the whole environment that a rough surface reflects. B. Karis, Physically based shading on mobile, 2014.
vec2 environmentShare(float nv, float roughness) {
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
    return vec2(-1.04, 1.04) * a + r.zw;
}

void main() {
    vec3 colour = surfaceAppearance.rgb;
    float roughness = surfaceAppearance.a;
#ifdef TISSUE
    const float metalness = 0.0;
#else
    float metalness = materialAppearance.x;
#endif
    float translucency = materialAppearance.y;
    float wetness = materialAppearance.z;
    float grain = materialAppearance.w;

#if RICH
    float glass = 0.0;
    float glassSlope = 0.0;  // of the facing to the eye, for each pixel
    if (glassPhase != 0) {
        glassSlope = fwidth(abs(dot(normalize(worldNormal), normalize(eye.xyz - worldPosition))));
        glass = objectPosition.z > glassAbove ? glassShare(glassAbove) : 0.0;
        if ((glassPhase == 1) == (glass > 0.0)) discard;
    }
    if (inner == 1 && gl_FragCoord.z < texelFetch(shellDepth, ivec2(gl_FragCoord.xy), 0).r) discard;
    if (distanceRange > 0.0) {
        float away = texture(distanceField, (objectToField * vec4(objectPosition, 1.0)).xyz).r;
        float share = away / distanceRange;
        if (distanceTolerance > 0.0) {
            float beyond = (abs(away) - distanceTolerance) / (distanceRange - distanceTolerance);
            share = beyond <= 0.0 ? 0.0 : sign(away) * mix(toleranceStep, 1.0, beyond);
        }
        colour = texture(distanceColours, vec2(0.5 + 0.5 * share, 0.5)).rgb;
    }
#endif
    vec3 toEye = normalize(eye.xyz - worldPosition);
    vec3 smoothNormal = normalize(worldNormal);
    if (!gl_FrontFacing) smoothNormal = -smoothNormal;
    float lamp = 0.0;  // what the surface itself shines
    vec3 normal;
#ifdef MACHINED
    normal = machined(noisePlace, smoothNormal, colour, roughness, metalness, lamp);
#else
    vec4 bumps = texture(noiseTexture, noisePlace) - 0.5;
    normal = normalize(smoothNormal + grain * 0.6 * bumps.xyz);
    colour *= 1.0 + grain * 0.25 * bumps.w;
#endif

    float nv = clamp(dot(normal, toEye), 0.02, 1.0);
    float nl = dot(normal, toKey.xyz);
    float shadow = keyVisibility(smoothNormal);

    // Thin rims of a translucent crown let the darkness of the mouth through: greyer and cooler at grazing view.
    float edgeOn = 1.0 - nv;
    vec3 body = colour * mix(vec3(1.0), vec3(0.74, 0.80, 0.88), translucency * edgeOn * edgeOn);

    // Light that enters scatters sideways before it leaves, red farthest. It bends around the terminator and into
    // shadows.
    vec3 wrap = translucency * vec3(0.40, 0.30, 0.24);
    vec3 creep = max(nl + wrap, 0.0) / ((1.0 + wrap) * (1.0 + wrap));
    // Beyond the terminator the surface shades itself; light that scatters there entered on the lit side.
    float direct = mix(1.0, shadow, smoothstep(0.0, 0.35, nl));
    vec3 arriving = mix(vec3(direct), vec3(sqrt(direct), direct, direct), 0.35 * translucency);
    vec3 diffuse = keyColour.rgb * creep * arriving;
    diffuse += fillColour.rgb * max(dot(normal, toFill.xyz), 0.0);
    // What comes from around has met the same tissue before: it has its hue, and so have the shadows.
    vec3 around = mix(groundColour.rgb, skyColour.rgb, normal.z * 0.5 + 0.5);
    float grey = dot(colour, vec3(0.30, 0.55, 0.15));
    diffuse += around * mix(vec3(1.0), colour / max(grey, 0.05), kBounced);
    vec3 light = body * diffuse * (1.0 - metalness);

    // Reflectance of the operating light: 4.5 % for tissue, the colour itself for metal.
    vec3 f0 = mix(vec3(0.045), colour, metalness);
    vec3 halfway = normalize(toKey.xyz + toEye);
    float nh = clamp(dot(normal, halfway), 0.0, 1.0);
    float fresnel = grazing(dot(toEye, halfway));
    float lit = max(nl, 0.0);
    light += keyColour.rgb * (f0 + (1.0 - f0) * fresnel) *
             (lit * shadow * kPi * microfacets(nh, lit, nv, max(roughness, 0.25)));

    // A film of saliva on top: 2 % reflection, smooth, following only the broad shape.
    vec3 filmNormal = mix(smoothNormal, normal, 0.17);
#if SHADOW_TAPS > 1
    if (wetness > 1.0) {  // running water
        vec3 waves = textureLod(noiseTexture, 0.23 * noisePlace, 0.0).xyz - 0.5;
        filmNormal = normalize(filmNormal + 0.75 * min(wetness - 1.0, 0.5) * waves);
    }
#endif
    float filmNv = clamp(dot(filmNormal, toEye), 0.02, 1.0);
    float filmNh = clamp(dot(filmNormal, halfway), 0.0, 1.0);
    float filmNl = max(dot(filmNormal, toKey.xyz), 0.0);
    float film = wetness * (0.025 + 0.6 * grazing(filmNv));
    light *= 1.0 - film;
    light += keyColour.rgb * (wetness * shadow * filmNl * (0.02 + 0.98 * fresnel) * kPi *
                              microfacets(filmNh, filmNl, filmNv, 0.27));

    // Metal reflects the room. The film reflects it sharply, and the surface below adds a soft share.
    vec3 reflected = reflect(-toEye, mix(filmNormal, normal, metalness));
    vec2 share = environmentShare(nv, roughness);
    vec3 roomShare = f0 * share.x + share.y;
    vec3 softRoom = mix(groundColour.rgb, skyColour.rgb, reflected.z * 0.5 + 0.5);
    light += (1.0 - metalness) * softRoom * (roomShare + film);
    // What a film reflects of the room is seen where it reflects much: toward its edges.
    const float kFaint = 0.06;
    float sharp = max(film - kFaint, 0.0) * (1.0 - metalness);
    if (sharp + metalness > 0.0) {
        float blur = mix(0.08, roughness, metalness);
        vec3 room = environment(reflected, blur);
        light += sharp * (room - softRoom);
#ifndef TISSUE
        light += metalness * 1.9 * (room + bib(reflected, blur)) * roomShare;
#endif
    }

    light += lamp;
#if RICH
    // Like glass: a rim at grazing view hides more than a face at perpendicular view.
    float opacity = mix(appearanceOpacity, 1.0, 0.75 * edgeOn * edgeOn * step(appearanceOpacity, 0.999));
    if (glassPhase == 2) opacity = mix(1.0, glassOpacity(nv, glassSlope, glassAbove), glass);
#else
    const float opacity = 1.0;
#endif
    fragment = vec4(toSrgb(compress(light)) + dither(), opacity);
}
