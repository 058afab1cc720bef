#pragma once

namespace palpate::sim {

/// GLSL 1.20. Everything is seen from the camera; the lights hang on it, so that a form reads the same from
/// every side.
inline constexpr const char* kVertexShader = R"(
#version 120
attribute vec3 position;
attribute vec3 normal;
attribute vec4 colour;
attribute vec3 edge;
varying vec3 at;
varying vec3 outwards;
varying vec4 tint;
varying vec3 to_edge;
void main() {
  at = position;
  outwards = normal;
  tint = colour;
  to_edge = edge;
  gl_Position = gl_ProjectionMatrix * vec4(position, 1.0);
}
)";

/// Light is added up in nearly linear colours (a gamma of 2: no pow(), which took a fifth of a frame's time).
/// A translucent surface is denser where it is seen from the side, as a film is: this draws its outline. Mesh
/// edges are a faint darkening one pixel wide. An opacity of 2 is a solid surface whose colour is read from a
/// legend: no light plays on it.
inline constexpr const char* kFragmentShader = R"(
#version 120
varying vec3 at;
varying vec3 outwards;
varying vec4 tint;
varying vec3 to_edge;
const vec3 key = vec3(-0.42, 0.68, 0.60);
const vec3 fill = vec3(0.80, 0.10, 0.59);
void main() {
  vec3 n = normalize(gl_FrontFacing ? outwards : -outwards);
  vec3 v = normalize(-at);
  float facing = max(dot(n, v), 0.0);
  float aside = 1.0 - facing;
  float rim = aside * aside * aside;
  vec3 albedo = tint.rgb * tint.rgb;
  float diffuse = 0.42 + 0.05 * n.y + 0.55 * max(dot(n, key), 0.0) + 0.20 * max(dot(n, fill), 0.0);
  float shine = max(dot(n, normalize(key + v)), 0.0);
  shine *= shine;
  shine *= shine;
  shine *= shine;
  shine *= shine;
  shine *= shine;  // to the power of 32
  vec3 light = albedo * diffuse * (1.0 - 0.45 * rim) + vec3(0.16) * shine;
  if (tint.a > 1.5) light = albedo * (0.85 + 0.15 * facing);  // a colour that means something
  float opacity = tint.a < 1.0 ? mix(tint.a, 1.0, 0.75 * rim) + 0.25 * shine : 1.0;

  vec3 pixels = to_edge / max(fwidth(to_edge), vec3(1e-6));
  float line = 1.0 - smoothstep(0.4, 1.2, min(min(pixels.x, pixels.y), pixels.z));
  if (!gl_FrontFacing) line = 0.0;
  light *= 1.0 - 0.22 * line;
  gl_FragColor = vec4(sqrt(light), clamp(opacity + 0.10 * line, 0.0, 1.0));
}
)";

}  // namespace palpate::sim
