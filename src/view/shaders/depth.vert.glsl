layout(location = 0) in vec3 position;

uniform mat4 objectToShadow;

void main() { gl_Position = objectToShadow * vec4(position, 1.0); }
