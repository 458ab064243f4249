import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  DynamicDrawUsage,
  GLSL3,
  Mesh,
  ShaderMaterial,
  Vector2,
  Vector3,
  Vector4,
} from 'three';
import { channels } from './ramp';

// Each end of a piece is moved to both sides by half the width, at right angles to the piece as it is seen.
const vertexShader = /* glsl */ `
uniform vec2 size;
uniform float width;
in vec3 other;
in float side;
void main() {
  vec4 here = projectionMatrix * (modelViewMatrix * vec4(position, 1.0));
  vec4 there = projectionMatrix * (modelViewMatrix * vec4(other, 1.0));
  vec2 along = (there.xy / there.w - here.xy / here.w) * size;
  vec2 across = vec2(-along.y, along.x) / max(length(along), 1e-6);
  here.xy += side * width * across / size * here.w;
  gl_Position = here;
}`;

const fragmentShader = /* glsl */ `
uniform vec3 lineColour;
out vec4 colour;
void main() {
  colour = vec4(lineColour, 1.0);
}`;

/**
 * Straight pieces with a width in pixels. Unlike wide lines of three.js, they are not drawn as instances, because
 * renderers without graphics hardware are slow with many instances.
 */
export class ThinLines extends Mesh<BufferGeometry, ShaderMaterial> {
  private readonly places: BufferAttribute;
  private readonly others: BufferAttribute;

  /** `pieces` has the two points of each piece. */
  constructor(
    private readonly pieces: Uint32Array,
    colour: string,
    pixels: number,
  ) {
    const uniforms = {
      size: { value: new Vector2(1, 1) },
      width: { value: pixels },
      lineColour: { value: new Vector3(...channels(colour)) },
    };
    const moving = () => new BufferAttribute(new Float32Array(6 * pieces.length), 3).setUsage(DynamicDrawUsage);
    const geometry = new BufferGeometry();
    super(
      geometry,
      new ShaderMaterial({ vertexShader, fragmentShader, uniforms, glslVersion: GLSL3, side: DoubleSide }),
    );
    this.places = moving();
    this.others = moving();
    const corners = Array.from({ length: pieces.length / 2 }, (_, i) => [0, 1, 2, 2, 1, 3].map((c) => 4 * i + c));
    // Seen from the other end, the sides are reversed.
    const sides = Float32Array.from({ length: 2 * pieces.length }, (_, i) => [1, -1, -1, 1][i % 4]);
    geometry.setAttribute('position', this.places);
    geometry.setAttribute('other', this.others);
    geometry.setAttribute('side', new BufferAttribute(sides, 1));
    geometry.setIndex(corners.flat());
    this.frustumCulled = false;
    const viewport = new Vector4();
    this.onBeforeRender = (renderer) => {
      renderer.getViewport(viewport);
      uniforms.size.value.set(viewport.z, viewport.w);
    };
  }

  /** Moves the points of the pieces. */
  lay(points: Float32Array): void {
    for (let i = 0; i < this.pieces.length; i += 2)
      for (let corner = 0; corner < 4; ++corner) {
        const end = corner < 2 ? 0 : 1;
        const here = 3 * this.pieces[i + end],
          there = 3 * this.pieces[i + 1 - end],
          to = 3 * (2 * i + corner);
        for (let c = 0; c < 3; ++c) {
          this.places.array[to + c] = points[here + c];
          this.others.array[to + c] = points[there + c];
        }
      }
    this.places.needsUpdate = this.others.needsUpdate = true;
  }
}
