import { BufferAttribute, DynamicDrawUsage, Group } from 'three';
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import type { Report } from '../model/report';
import { spread, type Sheet } from '../model/sheet';
import type { SurfacePoints } from '../model/surface_points';
import { areaVectors, pointNormals } from '../model/surface';
import { markMesh } from './mark_mesh';
import { loopColours } from './ramp';
import { SheetMesh, type SheetMaterials } from './sheet_mesh';
import type { ShownSurface } from './shown';
import type { State } from './state';

const loopPixels = 3.5;
// Loops and marks are drawn at this distance [mm] outside the surface, so that its facets do not hide them.
const lift = 0.25;

/** A surface of the model in space, with its loops and marks. */
export class SurfaceMesh extends Group {
  points: Float32Array;
  private readonly places: BufferAttribute;
  private readonly normals: BufferAttribute;
  private readonly mesh: SheetMesh;
  private readonly curves: Line2[];
  private readonly marks: ReturnType<typeof markMesh>[];

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
    this.marks = report.marks.map(markMesh);
    this.add(this.mesh, ...this.curves, ...this.marks);
  }

  show(surface: ShownSurface, options: State): void {
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
    this.marks.forEach((mesh, i) => {
      mesh.visible = options.marks && (options.onlyMark ?? i) === i;
      if (mesh.visible) mesh.lay(this.report.marks[i].points.lifted(surface.points, normals, triangles, lift));
    });
  }

  private lay(curve: Line2, loop: SurfacePoints, normals: Float32Array): void {
    const points = loop.lifted(this.points, normals, this.report.model.triangles, lift);
    curve.geometry.dispose();
    curve.geometry = new LineGeometry();
    curve.geometry.setPositions([...points, ...points.subarray(0, 3)]);
  }
}
