#version 330 core
// Corners of the fills of regions. Pixels, y points down.

uniform vec2 screen;

in vec2 pixel;
in vec4 paint;  // sRGB and opacity

flat out vec4 f_paint;

void main() {
    gl_Position = vec4(pixel.x / screen.x * 2.0 - 1.0, 1.0 - pixel.y / screen.y * 2.0, 0.0, 1.0);
    f_paint = paint;
}
