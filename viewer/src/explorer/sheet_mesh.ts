import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  Sphere,
  Vector3,
} from 'three';
import { spread, type Sheet } from '../model/sheet';
import { SurfaceMaterial } from './material';

/** The materials of surfaces, of marked triangles and of edges. */
export interface SheetMaterials {
  surface: SurfaceMaterial;
  marks: SurfaceMaterial;
  edges: LineBasicMaterial;
}

export function sheetMaterials(light: 'lit' | 'flat', cells: [number, number]): SheetMaterials {
  const marks = new SurfaceMaterial('flat', cells).behind(1); // unlit, because they are visible from both sides
  marks.paint('flips', 1, true);
  return {
    surface: new SurfaceMaterial(light, cells).behind(2),
    marks,
    edges: new LineBasicMaterial({ color: 0x000000, opacity: 0.28, transparent: true }),
  };
}

/**
 * A surface of the model on its sheet, coloured by the values of its landmarks, with marked triangles, and with edges
 * if requested.
 */
export class SheetMesh extends Group {
  private readonly value: BufferAttribute;
  private readonly marked: Mesh;
  private readonly edges: LineSegments;

  /** `normals` are needed if the material is lit. */
  constructor(
    private readonly sheet: Sheet,
    materials: SheetMaterials,
    places: BufferAttribute,
    normals: BufferAttribute | null,
  ) {
    super();
    this.value = new BufferAttribute(new Float32Array(sheet.landmarks.length), 1).setUsage(DynamicDrawUsage);
    const geometryOf = (index: Uint32Array) => {
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', places);
      geometry.setAttribute('value', this.value);
      geometry.setAttribute('turns', turns);
      if (normals) geometry.setAttribute('normal', normals);
      geometry.setIndex(new BufferAttribute(index, 1));
      geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
      return geometry;
    };
    const turns = new BufferAttribute(sheet.turns, 2);
    this.marked = new Mesh(geometryOf(new Uint32Array(0)), materials.marks);
    this.edges = new LineSegments(geometryOf(edgesOf(sheet.corners)), materials.edges);
    this.add(new Mesh(geometryOf(sheet.corners), materials.surface), this.marked, this.edges);
  }

  /** `values` has one value per landmark; null means 0 for all. `marked` are triangles of the sheet. */
  show(values: Float32Array | null, marked: number[], edges: boolean): void {
    const target = this.value.array as Float32Array;
    if (values) spread(target, 1, values, this.sheet.landmarks);
    else target.fill(0);
    this.value.needsUpdate = true;
    this.edges.visible = edges;
    this.marked.visible = marked.length > 0;
    const corners = marked.flatMap((t) => [...this.sheet.corners.subarray(3 * t, 3 * t + 3)]);
    if (this.marked.visible) this.marked.geometry.setIndex(new BufferAttribute(Uint32Array.from(corners), 1));
  }
}

// Each edge is drawn once.
function edgesOf(corners: Uint32Array): Uint32Array {
  const edges = new Map<string, [number, number]>();
  for (let i = 0; i < corners.length; ++i) {
    const ends = [corners[i], corners[i % 3 === 2 ? i - 2 : i + 1]].sort((a, b) => a - b) as [number, number];
    edges.set(ends.join(), ends);
  }
  return Uint32Array.from([...edges.values()].flat());
}
