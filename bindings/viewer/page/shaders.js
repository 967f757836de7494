"use strict";

// Blocks are drawn at once. Each vertex looks up the pose of its block, or its own place as a node, in a texture, and
// has the colour and the light of its whole face: by software, a fragment costs as much as a vertex, and there are
// more. For the same reason a fragment has one distance from an edge, the smallest of three, and a section only if
// there is one.

const blockVertexShader = `
precision highp float;
precision highp int;
uniform highp sampler2D states;  // rows of texels: poses (place and colour value, rotation), then nodes
uniform int statesWidth;
uniform float firstNode;         // texel
uniform sampler2D colours;
uniform vec2 range;              // of the coloured values
uniform vec3 missingColour;
uniform bool isFlat;             // 2D: no light
uniform bool isPicking;
uniform float selected;
#ifdef HAS_SECTION
uniform vec4 section;            // plane: normal, and offset along it
#endif
in vec3 edges;                   // distance from the edges of three classes, 0 or 1
in vec2 owner;                   // block, and node or -1
in vec3 across;                  // normal of the face; at a node, the next and the previous node of the face
out vec3 edge;
#ifdef HAS_SECTION
out float ahead;                 // of the section
#endif
flat out vec4 tone;              // colour and light

vec4 texel(float index) {
  int i = int(index);
  return texelFetch(states, ivec2(i % statesWidth, i / statesWidth), 0);
}

vec3 rotated(vec4 q, vec3 v) {
  return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v);
}

vec3 numberAsColour(float number) {
  return vec3(mod(number, 256.0), mod(floor(number / 256.0), 256.0), floor(number / 65536.0)) / 255.0;
}

vec3 colourOf(float value) {
  if (value > 1e30) return missingColour;
  float part = clamp((value - range.x) / max(range.y - range.x, 1e-30), 0.0, 1.0);
  return texelFetch(colours, ivec2(int(part * 255.0 + 0.5), 0), 0).rgb;
}

/** From a lamp above the shoulder of the camera. */
float lightOn(vec3 normal) {
  vec3 right = vec3(viewMatrix[0][0], viewMatrix[1][0], viewMatrix[2][0]);
  vec3 up = vec3(viewMatrix[0][1], viewMatrix[1][1], viewMatrix[2][1]);
  vec3 towards = vec3(viewMatrix[0][2], viewMatrix[1][2], viewMatrix[2][2]);
  return 0.62 + 0.3 * dot(normal, normalize(towards + 0.8 * up - 0.5 * right)) + 0.16 * normal.z;
}

void main() {
  vec4 at = texel(2.0 * owner.x);
  vec4 q = texel(2.0 * owner.x + 1.0);
  bool isNode = owner.y >= 0.0;
  vec3 place = isNode ? texel(firstNode + owner.y).xyz : at.xyz + rotated(q, position);
  edge = edges;
#ifdef HAS_SECTION
  ahead = dot(section.xyz, place) - section.w;
#endif
  if (isPicking) {
    tone = vec4(numberAsColour(owner.x + 1.0), 1.0);
  } else {
    vec3 colour = colourOf(at.w);
    if (owner.x == selected) colour = mix(colour, vec3(1.0, 0.45, 0.1), 0.6);
    float light = 1.0;
    if (!isFlat) {
      vec3 normal = rotated(q, across);
      if (isNode) normal = cross(texel(firstNode + across.x).xyz - place, texel(firstNode + across.y).xyz - place);
      light = lightOn(normalize(normal));
    }
    tone = vec4(colour, light);
  }
  gl_Position = at.w < -1e30 ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * viewMatrix * vec4(place, 1.0);
}
`;

const blockFragmentShader = `
precision highp float;
uniform bool isFlat;
uniform float opacity;
uniform vec3 edgeColour;
uniform float edgeOpacity;
uniform bool isPicking;
in vec3 edge;
#ifdef HAS_SECTION
in float ahead;
#endif
flat in vec4 tone;

void main() {
#ifdef HAS_SECTION
  if (ahead > 0.0) discard;
#endif
  if (isPicking) {
    gl_FragColor = tone;
    return;
  }
  // A section shows the inside of a cut block in one even tone, which looks like its cut face.
  bool isOutside = isFlat || gl_FrontFacing;
  vec3 colour = tone.rgb * (isOutside ? tone.a : 0.75);
  float distance = min(min(edge.x, edge.y), edge.z);
  float width = max(fwidth(distance), 1e-6);
  float line = clamp(1.4 - distance / width, 0.0, 1.0);
  // Blocks of a few pixels would be all edge.
  line *= clamp(0.125 / width - 0.25, 0.0, 1.0) * (isOutside ? 1.0 : 0.0);
  colour = mix(colour, edgeColour, line * edgeOpacity);
  gl_FragColor = vec4(colour, opacity);
}
`;

// Bars of a width in pixels and in metres, which face the camera.

const barVertexShader = `
precision highp float;
in vec3 begin;
in vec3 end;
in vec2 widths;   // pixels, and metres besides
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
  vec4 at = position.x < 0.5 ? a : b;
  float width = widths.x + widths.y * projectionMatrix[1][1] * 0.5 * viewport.y / at.w;
  vec2 side = vec2(-along.y, along.x) * (width + 1.0) / viewport;
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
