// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Liquids on an object (SurfaceLiquids). They change the appearances of vertices, so that pixels cost nothing more.
// A wetness above 1 is running water: where shading is careful, it has waves.
uniform vec4 waterFilm;  // where the water arrives, world, mm; amount, 0..1
uniform vec4 bloodFilm;  // the opening of the pulp, world, mm; how far blood has spread, mm
uniform float slurry;    // 0..1

// From -1 to 1, over about a millimetre: the edges of liquids are not round.
float ragged(vec3 place) {
    return (sin(2.3 * place.x + 1.7 * place.y) + sin(3.1 * place.y - 2.9 * place.z) + sin(2.7 * place.z + 3.7 * place.x)) / 3.0;
}

// `surface`: linear colour, roughness; `material`: metalness, translucency, wetness, grain.
void addLiquids(vec3 place, inout vec4 surface, inout vec4 material) {
    if (waterFilm.w > 0.0) {
        float away = distance(place, waterFilm.xyz);
        float film = waterFilm.w * (1.0 - smoothstep(5.0, 13.0, away));
        // Water fills the pores of a dry matt surface, which then looks darker and smoother.
        surface.rgb *= 1.0 - 0.22 * film * (1.0 - clamp(material.z, 0.0, 1.0));
        surface.a = mix(surface.a, min(surface.a, 0.34), film);
        material.z = mix(material.z, 1.5, film);
        material.w *= 1.0 - 0.6 * film;
        float milk = slurry * film * (1.0 - smoothstep(0.9, 3.4, away * (1.0 + 0.35 * ragged(place))));
        surface = mix(surface, vec4(0.83, 0.815, 0.77, 0.45), 0.8 * milk);
        material.y = mix(material.y, 0.6, milk);
    }
    if (bloodFilm.w > 0.0) {
        float away = distance(place, bloodFilm.xyz) * (1.0 + 0.3 * ragged(1.9 * place));
        float cover = 1.0 - smoothstep(0.7 * bloodFilm.w, bloodFilm.w, away);
        vec3 thin = surface.rgb * vec3(0.75, 0.16, 0.13);
        vec3 thick = vec3(0.19, 0.006, 0.005);
        surface.rgb = mix(surface.rgb, mix(thin, thick, cover), min(2.0 * cover, 1.0));
        surface.a = mix(surface.a, 0.22, cover);
        material = mix(material, vec4(0.0, 0.5, 1.6, 0.05), cover);
    }
}
