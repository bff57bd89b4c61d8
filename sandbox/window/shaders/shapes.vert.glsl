#version 330 core
// One quad a shape or stroke, a pixel larger than what it covers. All lengths are pixels, y points down.

uniform vec2 screen;

in vec2 corner;    // -1..1
in vec2 origin;    // of the shape frame
in vec2 axis;      // x axis of the shape frame (cos, sin)
in vec4 extent;    // half extents of the core, rounding radius, outline width or minus the softness of a shadow
in vec4 detail;    // mark from x, mark to x, first polygon vertex, number of polygon vertices or minus that of sides
in uvec3 paints;   // a byte each: fill and opacity, edge and whether hatched, mark and opacity
#ifdef TEXTURED
in vec4 grain;     // tiles a pixel (negative: lies across), number of the texture + 0.99 strength, start in the tile
#endif

out vec2 place;    // in the shape frame
flat out vec4 f_extent, f_detail;
flat out uvec3 f_paints;
#ifdef TEXTURED
flat out vec4 f_grain;
#endif

void main() {
    place = corner * (extent.xy + extent.z + 1.0);
    // The shape frame has y up, the screen y down: a reflection, not a turn.
    vec2 pixel = origin + vec2(axis.x * place.x + axis.y * place.y, axis.y * place.x - axis.x * place.y);
    gl_Position = vec4(pixel.x / screen.x * 2.0 - 1.0, 1.0 - pixel.y / screen.y * 2.0, 0.0, 1.0);
    f_extent = extent;
    f_detail = detail;
    f_paints = paints;
#ifdef TEXTURED
    f_grain = grain;
#endif
}
