#version 330 core
// One colour over a whole region.

flat in vec4 f_paint;

out vec4 color;

void main() {
    color = f_paint;
}
