// Counts surfaces over each other.
layout(location = 0) out vec4 out_count;

void main() {
    out_count = vec4(1.0);
}
