import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Group, Mesh, Sphere, Vector3 } from 'three';
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import type { Loop } from '../model/loop';
import type { Report } from '../model/report';
import { areaVectors, pointNormals } from '../model/surface';
import type { SurfaceMaterial } from './material';
import { loopColours } from './ramp';
import type { ShownSurface } from './shown';

const loopPixels = 3.5;
// Loops stand this far off the surface, so that they do not sink into its facets.
const loopLift = 0.25;

/** The numbers of each corner from those of its landmark. */
export function spread(target: Float32Array, size: number, values: Float32Array, triangles: Uint32Array): void {
  for (let i = 0; i < triangles.length; ++i)
    for (let c = 0; c < size; ++c) target[size * i + c] = values[size * triangles[i] + c];
}

/** A surface of the model with its loops, in space; corners of triangles stand beside each other. */
export class SurfaceMesh extends Group {
  points: Float32Array;
  private readonly places: BufferAttribute;
  private readonly normals: BufferAttribute;
  private readonly value: BufferAttribute;
  private readonly flipped: BufferAttribute;
  private readonly curves: Line2[];

  constructor(private readonly report: Report, material: SurfaceMaterial) {
    super();
    const corners = report.model.triangles.length;
    const dynamic = (size: number) => new BufferAttribute(new Float32Array(size * corners), size).setUsage(DynamicDrawUsage);
    this.places = dynamic(3);
    this.normals = dynamic(3);
    this.value = dynamic(1);
    this.flipped = dynamic(1);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.places);
    geometry.setAttribute('normal', this.normals);
    geometry.setAttribute('value', this.value);
    geometry.setAttribute('flipped', this.flipped);
    geometry.setAttribute('turns', new BufferAttribute(report.torus.cornerTurns, 2));
    geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
    this.points = report.model.mean;
    this.add(new Mesh(geometry, material));
    this.curves = report.loops.map((_, i) => {
      const curve = new Line2(new LineGeometry(), new LineMaterial({ color: loopColours[i % 2], linewidth: loopPixels }));
      curve.frustumCulled = false;
      this.add(curve);
      return curve;
    });
  }

  show(surface: ShownSurface, loops: boolean, flips: boolean): void {
    const { triangles, landmarks } = this.report.model;
    this.points = surface.points;
    const normals = pointNormals(landmarks, triangles, areaVectors(surface.points, triangles));
    spread(this.places.array as Float32Array, 3, surface.points, triangles);
    spread(this.normals.array as Float32Array, 3, normals, triangles);
    if (surface.values) spread(this.value.array as Float32Array, 1, surface.values, triangles);
    else (this.value.array as Float32Array).fill(0);
    markFlipped(this.flipped.array as Float32Array, flips ? surface.flipped : []);
    for (const attribute of [this.places, this.normals, this.value, this.flipped]) attribute.needsUpdate = true;
    this.curves.forEach((curve, i) => {
      curve.visible = loops;
      if (loops) this.lay(curve, this.report.loops[i], normals);
    });
  }

  private lay(curve: Line2, loop: Loop, normals: Float32Array): void {
    const { triangles } = this.report.model;
    const points = loop.along(3, (triangle, corner, c) => {
      const at = 3 * triangles[3 * triangle + corner] + c;
      return this.points[at] + loopLift * normals[at];
    });
    curve.geometry.dispose();
    curve.geometry = new LineGeometry();
    curve.geometry.setPositions([...points, ...points.subarray(0, 3)]);
  }
}

/** One for the corners of these triangles, zero for all others. */
export function markFlipped(corners: Float32Array, triangles: number[]): void {
  corners.fill(0);
  for (const t of triangles) corners.fill(1, 3 * t, 3 * t + 3);
}
