import { BufferAttribute, BufferGeometry, CanvasTexture, DynamicDrawUsage, Points, PointsMaterial } from 'three';
import type { Mark } from '../model/mark';
import { ThinLines } from './thin_lines';

const linePixels = 1.6,
  dotPixels = 8;

/** A mark of all shapes on one surface: a line or a dot for each shape. */
export function markMesh(mark: Mark): ThinLines | Dots {
  return mark.isCurve
    ? new ThinLines(mark.pieces(), mark.colour, linePixels)
    : new Dots(mark.points.length, mark.colour);
}

class Dots extends Points {
  private readonly places: BufferAttribute;

  constructor(count: number, colour: string) {
    const places = new BufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage);
    super(
      new BufferGeometry().setAttribute('position', places),
      new PointsMaterial({ color: colour, size: dotPixels, sizeAttenuation: false, map: disc(), alphaTest: 0.5 }),
    );
    this.places = places;
    this.frustumCulled = false;
  }

  /** Moves the dots. */
  lay(points: Float32Array): void {
    this.places.array.set(points);
    this.places.needsUpdate = true;
  }
}

// Without this texture, dots are squares.
function disc(): CanvasTexture {
  const size = 64;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size;
  const context = canvas.getContext('2d')!;
  context.fillStyle = '#fff';
  context.arc(size / 2, size / 2, size / 2 - 1, 0, 2 * Math.PI);
  context.fill();
  return new CanvasTexture(canvas);
}
