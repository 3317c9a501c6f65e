// GLSL of the cloud. Points are discs that lie in the surface. Discs that make up the nearest surface
// are blended (Botsch et al. 2005); the last pass adds depth cues and outlines.

// The alpha of the first pass is not opacity: it marks highlighted points.
const MARKS = /* glsl */ `
  const float MARK_NONE = 1.0;
  const float MARK_HOVERED = 0.75;
  const float MARK_SELECTED = 0.5;
`;

// A light above the viewer's left shoulder, and ambient light from above.
const LIGHT = /* glsl */ `
  float light(vec3 n) {
    float lamp = max(dot(n, normalize(vec3(-0.35, 0.55, 0.75))), 0.0);
    return 0.6 + 0.11 * upward + 0.42 * lamp;
  }
`;

export const splatVertex = /* glsl */ `
  attribute vec3 shade;
  attribute float owner;
  uniform float radius;
  uniform float focal;
  varying vec3 viewNormal;
  varying float upward;
  varying vec3 albedo;
  varying float ownerOut;
  varying float pixels;
  varying float distanceOut;
  const float HIDDEN = 65534.5;
  void main() {
    vec4 view = modelViewMatrix * vec4(position, 1.0);
    gl_Position = owner > HIDDEN ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * view;
    distanceOut = -view.z;
    pixels = 2.0 * radius * focal / max(distanceOut, 1e-4);
    gl_PointSize = clamp(pixels, 1.5, 256.0);
    viewNormal = normalMatrix * normal;
    upward = normal.y;
    albedo = shade;
    ownerOut = owner;
  }
`;

// The disc of a point: position of the fragment on it, and its depth.
const DISC = /* glsl */ `
  uniform float radius;
  uniform float near;
  uniform float far;
  varying vec3 viewNormal;
  varying float pixels;
  varying float distanceOut;

  struct Disc { vec3 normal; bool seenFromBehind; float squaredRadius; float distance; };

  Disc discHere() {
    vec2 offset = gl_PointCoord * 2.0 - 1.0;
    offset.y = -offset.y;
    bool oriented = dot(viewNormal, viewNormal) > 0.25;
    vec3 n = oriented ? normalize(viewNormal) : vec3(0.0, 0.0, 1.0);
    bool behind = n.z < 0.0;
    if (behind) n = -n;
    // A disc seen edge-on is drawn with some thickness, so that silhouettes stay closed.
    float slope = pixels > 2.5 ? dot(n.xy, offset) / max(n.z, 0.3) : 0.0;
    return Disc(n, behind, dot(offset, offset) + slope * slope, distanceOut + radius * slope);
  }
`;

// First pass: depth and highlight marks of the nearest surface.
export const depthFragment = /* glsl */ `
  ${MARKS}
  ${DISC}
  uniform float selected;
  uniform float hovered;
  varying float ownerOut;
  void main() {
    Disc disc = discHere();
    if (disc.squaredRadius > 1.0) discard;
    bool isSelected = abs(ownerOut - selected) < 0.5;
    bool isHovered = abs(ownerOut - hovered) < 0.5;
    gl_FragColor = vec4(0.0, 0.0, 0.0, isSelected ? MARK_SELECTED : isHovered ? MARK_HOVERED : MARK_NONE);
    gl_FragDepth = clamp(far * (disc.distance - near) / ((far - near) * disc.distance), 0.0, 1.0);
  }
`;

// Second pass: sum of the discs at that surface, with weights that fall from their centres.
export const colorFragment = /* glsl */ `
  ${DISC}
  uniform sampler2D depths;
  uniform float selected;
  uniform float hovered;
  uniform vec3 paper;
  varying float upward;
  varying vec3 albedo;
  varying float ownerOut;

  ${LIGHT}

  void main() {
    Disc disc = discHere();
    if (disc.squaredRadius > 1.0) discard;
    float depth = texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r;
    float nearest = near * far / (far - (far - near) * depth);
    if (disc.distance > nearest + 0.8 * radius) discard;
    vec3 color = albedo * light(disc.normal) * (disc.seenFromBehind ? 0.72 : 1.0);
    bool isMarked = abs(ownerOut - selected) < 0.5 || abs(ownerOut - hovered) < 0.5;
    if (selected >= 0.0 && !isMarked) color = mix(color, paper, 0.38);
    float weight = exp(-4.0 * disc.squaredRadius) + 1e-3;
    gl_FragColor = vec4(color * weight, weight);
  }
`;

export const surfaceVertex = /* glsl */ `
  attribute vec3 shade;
  attribute float owner;
  varying vec3 viewNormal;
  varying float upward;
  varying vec3 albedo;
  flat varying float ownerOut;
  void main() {
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    viewNormal = normalMatrix * normal;
    upward = normal.y;
    albedo = shade;
    ownerOut = owner;
  }
`;

export const surfaceDepthFragment = /* glsl */ `
  ${MARKS}
  uniform float selected;
  uniform float hovered;
  flat varying float ownerOut;
  void main() {
    bool isSelected = abs(ownerOut - selected) < 0.5;
    bool isHovered = abs(ownerOut - hovered) < 0.5;
    gl_FragColor = vec4(0.0, 0.0, 0.0, isSelected ? MARK_SELECTED : isHovered ? MARK_HOVERED : MARK_NONE);
  }
`;

// The mesh is opaque where it is the nearest surface; discs in front of it are blended with it.
export const surfaceColorFragment = /* glsl */ `
  uniform sampler2D depths;
  uniform float near;
  uniform float far;
  uniform float selected;
  uniform float hovered;
  uniform vec3 paper;
  varying vec3 viewNormal;
  varying float upward;
  varying vec3 albedo;
  flat varying float ownerOut;
  const float TOLERANCE = 0.0005; // metres
  ${LIGHT}
  float distanceOf(float depth) { return near * far / (far - (far - near) * depth); }

  void main() {
    float depth = texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r;
    if (distanceOf(gl_FragCoord.z) > distanceOf(depth) + TOLERANCE) discard;
    vec3 n = normalize(viewNormal);
    vec3 color = albedo * (gl_FrontFacing ? light(n) : 0.6 * light(-n));
    bool isMarked = abs(ownerOut - selected) < 0.5 || abs(ownerOut - hovered) < 0.5;
    if (selected >= 0.0 && !isMarked) color = mix(color, paper, 0.38);
    gl_FragColor = vec4(color, 1.0);
  }
`;

export const composeVertex = /* glsl */ `
  void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }
`;

// Eye-dome lighting (Boucheny 2009): a pixel is darkened by the depth of its neighbours in front.
export const composeFragment = /* glsl */ `
  ${MARKS}
  uniform sampler2D marks;
  uniform sampler2D colors;
  uniform sampler2D depths;
  uniform int samples; // texels per pixel, along each side
  uniform float near;
  uniform float far;
  uniform float reach; // texels
  uniform float strength;
  uniform vec3 outline;
  uniform bool outlined;

  const vec2 AROUND[8] = vec2[8](
    vec2(1.0, 0.0), vec2(0.707, 0.707), vec2(0.0, 1.0), vec2(-0.707, 0.707),
    vec2(-1.0, 0.0), vec2(-0.707, -0.707), vec2(0.0, -1.0), vec2(0.707, -0.707));

  ivec2 size;
  ivec2 inside(vec2 texel) { return clamp(ivec2(texel), ivec2(0), size - 1); }
  float distanceAt(ivec2 texel) {
    float depth = texelFetch(depths, texel, 0).r;
    return depth >= 1.0 ? 1e6 : near * far / (far - (far - near) * depth);
  }
  bool marked(ivec2 texel) {
    float mark = texelFetch(marks, texel, 0).a;
    return mark > 0.25 && mark < 0.875;
  }

  ivec2 neighbor(ivec2 texel, int i) { return inside(vec2(texel) + 0.5 + reach * AROUND[i]); }

  bool onOutline(ivec2 texel) {
    if (marked(texel)) return false;
    for (int i = 0; i < 8; ++i) if (marked(neighbor(texel, i))) return true;
    return false;
  }

  vec4 shadeAt(ivec2 texel) {
    if (outlined && onOutline(texel)) return vec4(outline, 1.0);
    vec4 color = texelFetch(colors, texel, 0);
    if (color.a <= 0.0) return vec4(0.0);
    float here = log2(distanceAt(texel));
    float occlusion = 0.0;
    for (int i = 0; i < 8; ++i) {
      float there = log2(distanceAt(neighbor(texel, i)));
      occlusion += clamp(here - there, 0.0, 0.05);
    }
    return vec4(color.rgb / color.a * max(exp(-strength * occlusion), 0.25), 1.0);
  }

  void main() {
    size = textureSize(colors, 0);
    ivec2 corner = ivec2(gl_FragCoord.xy) * samples;
    vec4 sum = vec4(0.0);
    float depth = 1.0;
    for (int y = 0; y < samples; ++y) {
      for (int x = 0; x < samples; ++x) {
        ivec2 texel = inside(vec2(corner + ivec2(x, y)) + 0.5);
        sum += shadeAt(texel);
        depth = min(depth, texelFetch(depths, texel, 0).r);
      }
    }
    gl_FragColor = sum / float(samples * samples);
    gl_FragDepth = depth;
  }
`;

export const tableVertex = /* glsl */ `
  varying vec2 ground;
  varying vec2 texel;
  void main() {
    ground = position.xz;
    texel = uv;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }
`;

export const tableFragment = /* glsl */ `
  uniform sampler2D shadow;
  uniform vec3 ink;
  uniform float cell;
  uniform float extent;
  uniform float gridOpacity;
  uniform float shadowOpacity;
  varying vec2 ground;
  varying vec2 texel;

  float lines(float step, float width) {
    vec2 slope = fwidth(ground / step);
    vec2 off = abs(fract(ground / step - 0.5) - 0.5) / max(slope, vec2(1e-5));
    vec2 fade = clamp(1.2 - 4.0 * slope, 0.0, 1.0); // fades dense lines at the horizon
    vec2 line = clamp(width - off, 0.0, 1.0) * fade;
    return max(line.x, line.y);
  }

  void main() {
    float fade = 1.0 - smoothstep(0.55, 1.0, length(ground) / extent);
    float grid = (0.45 * lines(cell, 0.9) + 0.55 * lines(5.0 * cell, 1.1)) * gridOpacity * fade;
    float shade = texture2D(shadow, texel).r * shadowOpacity;
    float side = gl_FrontFacing ? 1.0 : 0.15;
    float alpha = (shade + grid * (1.0 - shade)) * side;
    vec3 color = mix(ink, vec3(0.0), shade / max(shade + grid, 1e-4));
    gl_FragColor = vec4(color * alpha, alpha);
  }
`;
