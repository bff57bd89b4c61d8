#version 330 core
// The kept picture, pixel by pixel.

uniform sampler2D kept;

out vec4 color;

void main() {
    color = texelFetch(kept, ivec2(gl_FragCoord.xy), 0);
}
