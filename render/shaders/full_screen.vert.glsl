// One triangle over the whole viewport, from gl_VertexID 0…2, at infinity (depth 0): a depth test of GL_LESS
// keeps the pixels that show geometry, GL_EQUAL those that show sky.
out vec2 uv;

void main() {
    uv = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
    gl_Position = vec4(2.0 * uv - 1.0, 0.0, 1.0);
}
