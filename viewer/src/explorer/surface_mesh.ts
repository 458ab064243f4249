import { BufferAttribute, DynamicDrawUsage, Group } from 'three';
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import type { Loop } from '../model/loop';
import type { Report } from '../model/report';
import { spread, type Sheet } from '../model/sheet';
import { areaVectors, pointNormals } from '../model/surface';
import { loopColours } from './ramp';
import { SheetMesh, type SheetMaterials } from './sheet_mesh';
import type { ShownSurface } from './shown';

const loopPixels = 3.5;
// Loops are drawn at this distance [mm] outside the surface, so that its facets do not hide them.
const loopLift = 0.25;

/** A surface of the model in space, with its loops. */
export class SurfaceMesh extends Group {
  points: Float32Array;
  private readonly places: BufferAttribute;
  private readonly normals: BufferAttribute;
  private readonly mesh: SheetMesh;
  private readonly curves: Line2[];

  constructor(
    private readonly report: Report,
    private readonly sheet: Sheet,
    materials: SheetMaterials,
  ) {
    super();
    const moving = () =>
      new BufferAttribute(new Float32Array(3 * sheet.landmarks.length), 3).setUsage(DynamicDrawUsage);
    this.places = moving();
    this.normals = moving();
    this.mesh = new SheetMesh(sheet, materials, this.places, this.normals);
    this.points = report.model.mean;
    this.curves = report.loops.map((_, i) => {
      const curve = new Line2(
        new LineGeometry(),
        new LineMaterial({ color: loopColours[i % 2], linewidth: loopPixels }),
      );
      curve.frustumCulled = false;
      return curve;
    });
    this.add(this.mesh, ...this.curves);
  }

  show(surface: ShownSurface, options: { loops: boolean; flips: boolean; edges: boolean }): void {
    const { triangles, landmarks } = this.report.model;
    this.points = surface.points;
    const normals = pointNormals(landmarks, triangles, areaVectors(surface.points, triangles));
    spread(this.places.array as Float32Array, 3, surface.points, this.sheet.landmarks);
    spread(this.normals.array as Float32Array, 3, normals, this.sheet.landmarks);
    this.places.needsUpdate = this.normals.needsUpdate = true;
    this.mesh.show(surface.values, options.flips ? surface.flipped : [], options.edges);
    this.curves.forEach((curve, i) => {
      curve.visible = options.loops;
      if (options.loops) this.lay(curve, this.report.loops[i], normals);
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
