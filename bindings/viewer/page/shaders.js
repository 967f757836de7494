"use strict";

// Blocks are drawn at once. Each vertex looks up the pose of its block, or its own place as a node, in a texture.

const blockVertexShader = `
precision highp float;
precision highp int;
uniform highp sampler2D states;  // rows of texels: poses (place and colour value, rotation), then nodes
uniform int statesWidth;
uniform float firstNode;         // texel
in vec3 edges;                   // distance from each edge of the triangle, that of the opposite corner being 1
in vec2 owner;                   // block, and node or -1
out vec3 edge;
out vec3 place;
out float value;
flat out vec2 identity;          // block, and 1 if it is selected
uniform float selected;

vec4 texel(float index) {
  int i = int(index);
  return texelFetch(states, ivec2(i % statesWidth, i / statesWidth), 0);
}

void main() {
  vec4 at = texel(2.0 * owner.x);
  vec4 q = texel(2.0 * owner.x + 1.0);
  vec3 local = position;
  vec3 world = at.xyz + local + 2.0 * cross(q.xyz, cross(q.xyz, local) + q.w * local);
  if (owner.y >= 0.0) world = texel(firstNode + owner.y).xyz;
  edge = edges;
  place = world;
  value = at.w;
  identity = vec2(owner.x, owner.x == selected ? 1.0 : 0.0);
  gl_Position = at.w < -1e30 ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * viewMatrix * vec4(world, 1.0);
}
`;

const blockFragmentShader = `
precision highp float;
uniform sampler2D colours;
uniform vec2 range;        // of the coloured values
uniform bool isFlat;       // 2D: no light
uniform float opacity;
uniform vec3 edgeColour;
uniform float edgeOpacity;
uniform vec4 section;      // plane: normal, and offset along it
uniform bool hasSection;
uniform bool isPicking;
uniform vec3 missingColour;
in vec3 edge;
in vec3 place;
in float value;
flat in vec2 identity;

void main() {
  if (hasSection && dot(section.xyz, place) > section.w) discard;
  if (isPicking) {
    float id = identity.x + 1.0;
    gl_FragColor = vec4(mod(id, 256.0), mod(floor(id / 256.0), 256.0), floor(id / 65536.0), 255.0) / 255.0;
    return;
  }
  float part = clamp((value - range.x) / max(range.y - range.x, 1e-30), 0.0, 1.0);
  vec3 colour = value > 1e30 ? missingColour : texture2D(colours, vec2(part * 255.0 / 256.0 + 0.5 / 256.0, 0.5)).rgb;
  float light = 1.0;
  if (!isFlat) {
    // A section shows the inside of a cut block in one even tone, which looks like its cut face.
    vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
    vec3 towards = vec3(viewMatrix[0][2], viewMatrix[1][2], viewMatrix[2][2]);
    vec3 right = vec3(viewMatrix[0][0], viewMatrix[1][0], viewMatrix[2][0]);
    vec3 up = vec3(viewMatrix[0][1], viewMatrix[1][1], viewMatrix[2][1]);
    vec3 lamp = normalize(towards + 0.8 * up - 0.5 * right);
    light = gl_FrontFacing ? 0.62 + 0.3 * dot(normal, lamp) + 0.16 * normal.z : 0.75;
  }
  colour *= light;
  if (identity.y > 0.5) colour = mix(colour, vec3(1.0, 0.45, 0.1), 0.6);
  vec3 width = fwidth(edge);
  vec3 distance = edge / max(width, vec3(1e-6));
  float nearest = min(min(distance.x, distance.y), distance.z);
  float line = 1.0 - smoothstep(0.4, 1.3, nearest);
  // Blocks of a few pixels would be all edge.
  float size = 1.0 / max(max(width.x, width.y), width.z);
  line *= smoothstep(2.0, 10.0, size) * (gl_FrontFacing || isFlat ? 1.0 : 0.0);
  colour = mix(colour, edgeColour, line * edgeOpacity);
  gl_FragColor = vec4(colour, opacity);
}
`;

// Bars of a constant width in pixels or in metres, which face the camera.

const barVertexShader = `
precision highp float;
in vec3 begin;
in vec3 end;
in float width;   // pixels
in vec4 tint;
uniform vec2 viewport;
uniform float lift;  // towards the camera, in the depth of the clip space
out vec4 colour;
out vec2 across;
out vec3 place;

void main() {
  vec4 a = projectionMatrix * viewMatrix * vec4(begin, 1.0);
  vec4 b = projectionMatrix * viewMatrix * vec4(end, 1.0);
  vec2 along = (b.xy / b.w - a.xy / a.w) * viewport;
  float size = length(along);
  along = size > 0.0 ? along / size : vec2(1.0, 0.0);
  vec2 side = vec2(-along.y, along.x) * (width + 1.0) / viewport;
  vec4 at = position.x < 0.5 ? a : b;
  at.xy += (side * position.y + along * (position.x - 0.5) / viewport) * at.w;
  at.z -= lift * at.w;
  colour = tint;
  across = vec2(position.y * (width + 1.0), width);
  place = position.x < 0.5 ? begin : end;
  gl_Position = width > 0.0 ? at : vec4(2.0, 2.0, 2.0, 1.0);
}
`;

const barFragmentShader = `
precision highp float;
uniform vec4 section;
uniform bool hasSection;
in vec4 colour;
in vec2 across;
in vec3 place;

void main() {
  if (hasSection && dot(section.xyz, place) > section.w) discard;
  float cover = clamp(across.y + 0.5 - abs(across.x), 0.0, 1.0);
  gl_FragColor = vec4(colour.rgb, colour.a * cover);
}
`;
