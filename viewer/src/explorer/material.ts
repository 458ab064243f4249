import { DoubleSide, FrontSide, GLSL3, ShaderMaterial, Vector3 } from 'three';
import { channels, flipColour, ramp } from './ramp';
import type { Colouring } from './state';

const vertexShader = /* glsl */ `
in float value;
in vec2 turns;
out vec3 vNormal;
out vec3 vToEye;
out float vValue;
out vec2 vTurns;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  vNormal = normalMatrix * normal;
  vToEye = -seen.xyz;
  vValue = value;
  vTurns = turns;
  gl_Position = projectionMatrix * seen;
}`;

// Choices that do not change between frames are made when the shader is compiled, because software renderers execute it
// as well.
const fragmentShader = /* glsl */ `
uniform float scaleEnd;
uniform vec3 ramp[${ramp.length}];
uniform vec3 flipColour;
uniform vec2 cells;
in vec3 vNormal;
in vec3 vToEye;
in float vValue;
in vec2 vTurns;
out vec4 colour;

const float pi = 3.14159265358979;

// Converts Ottosson's OKLab (2020) to sRGB.
vec3 srgb(vec3 lab) {
  float x = lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z;
  float y = lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z;
  float z = lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z;
  vec3 lms = vec3(x * x * x, y * y * y, z * z * z);
  vec3 linear = clamp(mat3(4.0767416621, -1.2684380046, -0.0041960863, -3.3077115913, 2.6097574011, -0.7034186147,
                           0.2309699292, -0.3413193965, 1.7076147010) * lms, 0.0, 1.0);
  return mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
}

// The torus is mapped to a torus of revolution about the grey axis of OKLab, as in the pictures that foramen makes.
vec3 torusColour(vec2 turns) {
  float hue = 2.0 * pi * turns.x, tube = 2.0 * pi * turns.y;
  float chroma = 0.095 + 0.02 * cos(tube);
  return srgb(vec3(0.68 + 0.12 * sin(tube), chroma * cos(hue), chroma * sin(hue)));
}

vec3 rampColour(float share) {
  float at = clamp(share, 0.0, 1.0) * ${ramp.length - 1}.0;
  vec3 c = ramp[0];
${ramp
  .slice(1)
  .map((_, i) => `  c = mix(c, ramp[${i + 1}], clamp(at - ${i}.0, 0.0, 1.0));`)
  .join('\n')}
  return c;
}

vec3 surfaceColour() {
#if COLOURS == 1
  vec3 c = rampColour(vValue / scaleEnd);
#elif COLOURS == 2
  vec3 c = torusColour(vTurns);
#elif COLOURS == 3
  vec2 cell = floor(vTurns * cells);
  vec3 c = torusColour((cell + 0.5) / cells);
  if (mod(cell.x + cell.y, 2.0) > 0.5) c = mix(c, vec3(1.0), 0.4);
#elif COLOURS == 4
  vec3 c = flipColour;
#else
  vec3 c = ramp[0];
#endif
  return c;
}

// There is a light at the upper left and a weaker one at the right; surfaces at a grazing angle are darker. Squares
// approximate the sRGB curve.
vec3 lighted(vec3 base) {
  vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal);
  vec3 eye = normalize(vToEye);
  float key = max(dot(n, vec3(-0.391, 0.651, 0.651)), 0.0);
  float fill = max(dot(n, vec3(0.867, -0.108, 0.488)), 0.0);
  float edge = smoothstep(0.0, 0.5, dot(n, eye));
  float light = (0.36 + 0.1 * n.y + 0.66 * key + 0.2 * fill) * (0.6 + 0.4 * edge);
  float shine = max(2.0 * key * n.z - 0.6, 0.0);
  return sqrt(base * base * light + 0.03 * shine * shine);
}

void main() {
  vec3 c = surfaceColour();
#if defined(LIT)
  c = lighted(c);
#endif
  colour = vec4(c, 1.0);
}`;

const vectorOf = (colour: string) => new Vector3(...channels(colour));

/** The colouring of a material: one that the user chose, or the colour of flipped triangles. */
export type Painting = Colouring | 'flips';

// The values of COLOURS in the shader.
const kinds: Record<Painting, number> = {
  plain: 0,
  displacement: 1,
  strength: 1,
  error: 1,
  fit: 1,
  torus: 2,
  checkerboard: 3,
  flips: 4,
};

/** The material of all surfaces. It is lit in space and unlit on the torus. */
export class SurfaceMaterial extends ShaderMaterial {
  constructor(light: 'lit' | 'flat', cells: [number, number]) {
    super({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      defines: { COLOURS: 0, ...(light === 'lit' ? { LIT: '' } : {}) },
      uniforms: {
        scaleEnd: { value: 1 },
        ramp: { value: ramp.map(vectorOf) },
        flipColour: { value: vectorOf(flipColour) },
        cells: { value: cells },
      },
    });
  }

  /** `bothSides` must be set if the inner side of triangles can be visible. */
  paint(painting: Painting, scaleEnd: number, bothSides: boolean): void {
    this.uniforms.scaleEnd.value = scaleEnd;
    const side = bothSides ? DoubleSide : FrontSide;
    if (this.defines.COLOURS === kinds[painting] && this.side === side) return;
    this.defines.COLOURS = kinds[painting];
    this.side = side;
    this.needsUpdate = true;
  }

  /** Moves the surface back in depth, behind the marks and edges that are drawn on it. */
  behind(steps: number): this {
    this.polygonOffset = steps > 0;
    this.polygonOffsetFactor = this.polygonOffsetUnits = steps;
    return this;
  }
}
