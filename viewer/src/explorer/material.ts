import { DoubleSide, GLSL3, ShaderMaterial, Vector3 } from 'three';
import { channels, flipColour, ramp } from './ramp';
import type { Colouring } from './state';

// Corners of a triangle stand beside each other in the buffers, so gl_VertexID tells which corner a vertex is.
const vertexShader = /* glsl */ `
in float value;
in vec2 turns;
in float flipped;
out vec3 vNormal;
out vec3 vToEye;
out float vValue;
out vec2 vTurns;
out vec3 vCorner;
flat out float vFlipped;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  vNormal = normalMatrix * normal;
  vToEye = -seen.xyz;
  vValue = value;
  vTurns = turns;
  vFlipped = flipped;
  int corner = gl_VertexID % 3;
  vCorner = vec3(corner == 0, corner == 1, corner == 2);
  gl_Position = projectionMatrix * seen;
}`;

const fragmentShader = /* glsl */ `
uniform int kind;        // 0 plain, 1 distances, 2 torus, 3 checkerboard of the torus
uniform float scaleEnd;
uniform vec3 ramp[${ramp.length}];
uniform vec3 flipColour;
uniform vec2 cells;
uniform bool lit;
uniform bool edges;
uniform bool clipped;    // to the domain of the torus
uniform float edgeStrength;
in vec3 vNormal;
in vec3 vToEye;
in float vValue;
in vec2 vTurns;
in vec3 vCorner;
flat in float vFlipped;
out vec4 colour;

const float pi = 3.14159265358979;

// Ottosson's OKLab (2020) to sRGB.
vec3 srgb(vec3 lab) {
  float x = lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z;
  float y = lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z;
  float z = lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z;
  vec3 lms = vec3(x * x * x, y * y * y, z * z * z);
  vec3 linear = clamp(mat3(4.0767416621, -1.2684380046, -0.0041960863, -3.3077115913, 2.6097574011, -0.7034186147,
                           0.2309699292, -0.3413193965, 1.7076147010) * lms, 0.0, 1.0);
  return mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
}

// As in the pictures that foramen makes: the torus laid about the grey axis of OKLab.
vec3 torusColour(vec2 turns) {
  float hue = 2.0 * pi * turns.x, tube = 2.0 * pi * turns.y;
  float chroma = 0.095 + 0.02 * cos(tube);
  return srgb(vec3(0.68 + 0.12 * sin(tube), chroma * cos(hue), chroma * sin(hue)));
}

vec3 rampColour(float share) {
  float at = clamp(share, 0.0, 1.0) * float(${ramp.length - 1});
  int low = min(int(at), ${ramp.length - 2});
  return mix(ramp[low], ramp[low + 1], at - float(low));
}

vec3 surfaceColour() {
  if (vFlipped > 0.5) return flipColour;
  if (kind == 1) return rampColour(vValue / scaleEnd);
  if (kind == 2) return torusColour(vTurns);
  if (kind == 3) {
    vec2 cell = floor(vTurns * cells);
    vec3 c = torusColour((cell + 0.5) / cells);
    return mod(cell.x + cell.y, 2.0) < 0.5 ? c : mix(c, vec3(1.0), 0.4);
  }
  return ramp[0];
}

vec3 lighted(vec3 base) {
  vec3 n = normalize(vNormal);
  if (!gl_FrontFacing) n = -n;
  vec3 eye = normalize(vToEye);
  float key = max(dot(n, normalize(vec3(-0.45, 0.75, 0.75))), 0.0);
  float fill = max(dot(n, normalize(vec3(0.8, -0.1, 0.45))), 0.0);
  float sky = 0.5 + 0.5 * n.y;
  float facing = max(dot(n, eye), 0.0);
  vec3 c = pow(base, vec3(2.2));
  c *= 0.26 + 0.2 * sky + 0.66 * key + 0.2 * fill;
  c *= 0.6 + 0.4 * smoothstep(0.0, 0.5, facing);
  vec3 halfway = normalize(eye + normalize(vec3(-0.45, 0.75, 0.75)));
  c += 0.05 * pow(max(dot(n, halfway), 0.0), 24.0);
  return pow(c, vec3(1.0 / 2.2));
}

void main() {
  if (clipped && (any(lessThan(vTurns, vec2(0.0))) || any(greaterThan(vTurns, vec2(1.0))))) discard;
  vec3 c = surfaceColour();
  if (edges) {
    vec3 width = fwidth(vCorner);
    vec3 inside = smoothstep(vec3(0.0), width * 1.1, vCorner);
    c = mix(c * (1.0 - edgeStrength), c, min(min(inside.x, inside.y), inside.z));
  }
  colour = vec4(lit ? lighted(c) : c, 1.0);
}`;

const vectorOf = (colour: string) => new Vector3(...channels(colour));

/** The one material of all surfaces, in space (lit) and on the flat torus (clipped to its domain). */
export class SurfaceMaterial extends ShaderMaterial {
  constructor(where: 'space' | 'torus', cells: [number, number]) {
    super({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      side: DoubleSide,
      uniforms: {
        kind: { value: 0 },
        scaleEnd: { value: 1 },
        ramp: { value: ramp.map(vectorOf) },
        flipColour: { value: vectorOf(flipColour) },
        cells: { value: cells },
        lit: { value: where === 'space' },
        clipped: { value: where === 'torus' },
        edges: { value: false },
        edgeStrength: { value: 0.3 },
      },
    });
    if (where === 'space') {
      this.polygonOffset = true;  // loops lie on the surface
      this.polygonOffsetFactor = this.polygonOffsetUnits = 1;
    }
  }

  show(colouring: Colouring, scaleEnd: number, edges: boolean): void {
    const kinds: Partial<Record<Colouring, number>> = { plain: 0, torus: 2, checkerboard: 3 };
    this.uniforms.kind.value = kinds[colouring] ?? 1;
    this.uniforms.scaleEnd.value = scaleEnd;
    this.uniforms.edges.value = edges;
  }
}
