#version 330 core
// Signed distances in pixels, so that one pixel of coverage is one unit of distance and edges are equally crisp
// at every zoom. Distance functions after Inigo Quilez, "2D distance functions".

in vec2 place;
flat in vec4 f_extent, f_detail;
flat in uvec3 f_paints;
#ifdef TEXTURED
uniform sampler2DArray textures;
flat in vec4 f_grain;

// What the material adds to the colour. The tile lies fixed in the shape frame.
float texture_at(vec2 p) {
    vec2 along = f_grain.x < 0.0 ? p.yx : p;
    float lod = log2(max(abs(f_grain.x) * 128.0, 1.0));
    return textureLod(textures, vec3(f_grain.zw + along * abs(f_grain.x), floor(f_grain.y)), lod).r;
}
#endif

out vec4 color;

float box_distance(vec2 p, vec2 half_size) {
    vec2 d = abs(p) - half_size;
    return length(max(d, 0.0)) + min(max(d.x, d.y), 0.0);
}

#ifdef OUTLINED
uniform sampler2D vertices;  // polygon vertices in metres, one a texel, 1024 a row
uniform float scale;         // pixels a metre

vec2 vertex(int i) {
    return texelFetch(vertices, ivec2(i & 1023, i >> 10), 0).xy * scale;
}

float polygon_distance(vec2 p, int first, int count) {
    vec2 before = vertex(first + count - 1);
    float nearest = dot(p - before, p - before);
    float deepest = -1e30;
    for (int i = 0; i < count; i++) {
        vec2 here = vertex(first + i);
        vec2 along = here - before;
        vec2 to = p - before;
        vec2 off = to - along * clamp(dot(to, along) / dot(along, along), 0.0, 1.0);
        nearest = min(nearest, dot(off, off));
        deepest = max(deepest, (to.x * along.y - to.y * along.x));  // outside of any edge is outside of all
        before = here;
    }
    return deepest > 0.0 ? sqrt(nearest) : -sqrt(nearest);
}

// Any outline with holes, given as the two ends of each side: inside where a ray crosses it an odd number of times.
float outline_distance(vec2 p, int first, int count) {
    float nearest = 1e30;
    bool inside = false;
    for (int i = 0; i < count; i++) {
        vec2 start = vertex(first + 2 * i);
        vec2 along = vertex(first + 2 * i + 1) - start;
        vec2 to = p - start;
        vec2 off = to - along * clamp(dot(to, along) / dot(along, along), 0.0, 1.0);
        nearest = min(nearest, dot(off, off));
        bool rises = (to.y >= 0.0) != (to.y >= along.y);
        if (rises && (along.x * to.y - along.y * to.x > 0.0) == (along.y > 0.0)) inside = !inside;
    }
    return inside ? -sqrt(nearest) : sqrt(nearest);
}

float core_distance(vec2 p, int first, int count) {
    if (count == 0) return box_distance(p, f_extent.xy);
    return count > 0 ? polygon_distance(p, first, count) : outline_distance(p, first, -count);
}
#else
float core_distance(vec2 p, int first, int count) {
    return box_distance(p, f_extent.xy);
}
#endif

float stroke_distance(vec2 p, float from, float to) {
    return length(p - vec2(clamp(p.x, from, to), 0.0));
}

vec4 paint_of(uint bytes) {
    return vec4(bytes & 255u, (bytes >> 8) & 255u, (bytes >> 16) & 255u, bytes >> 24) / 255.0;
}

void main() {
    float distance = core_distance(place, int(f_detail.z), int(f_detail.w)) - f_extent.z;
    bool shadow = f_extent.w < 0.0;
    float coverage = clamp(shadow ? distance / f_extent.w : 0.5 - distance, 0.0, 1.0);
    if (coverage <= 0.0) discard;

    vec4 fill = paint_of(f_paints.x), edge = paint_of(f_paints.y), mark = paint_of(f_paints.z);
    if (shadow) coverage *= coverage * (3.0 - 2.0 * coverage);
    vec3 paint = fill.rgb;
#ifdef TEXTURED
    paint += texture_at(place) * (fract(f_grain.y) / 0.99);
#endif
    if (edge.a > 0.5) {
        float stripe = abs(fract((gl_FragCoord.x - gl_FragCoord.y) / 9.9) - 0.5) * 9.9;
        paint = mix(edge.rgb, paint, clamp(stripe, 0.0, 1.0));
    }
    float spoke = clamp(0.5 + max(f_extent.w, 0.7) * 0.75 - stroke_distance(place, f_detail.x, f_detail.y), 0.0, 1.0);
    paint = mix(paint, mark.rgb, spoke * mark.a);
    float rim = clamp(distance + f_extent.w + 0.5, 0.0, 1.0) * clamp(f_extent.w, 0.0, 1.0);
    paint = mix(paint, edge.rgb, rim);
    color = vec4(paint, coverage * mix(fill.a, 1.0, max(rim, spoke * mark.a)));  // hollow shapes keep their lines
}
